// Where lines pass their supports, and which supports carry them.
#pragma once

#include <array>
#include <vector>

#include "hawser/model/supports.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser {
class LineVolumeContact;
}

namespace hawser::record {

using model::SupportCrossing;

// Of every box, of what is nearest to it. poses: of the bodies of the case. The same on all ranks.
// Collective.
std::vector<SupportCrossing> support_crossings(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                               const Kinematics& at, const std::vector<RigidPose>& poses);

// The rollers of supports of a case that has some. The subject outlives it.
class SupportRollers {
 public:
  explicit SupportRollers(const Subject& subject);

  // Of every box. Collective.
  std::vector<SupportCrossing> crossings(const Snapshot& s) const;
  // Of each line the arc lengths [m] of the first and the last box that carry it, the same on all ranks; the
  // first above the second: none does. Collective.
  std::vector<std::array<double, 2>> carrying(const Snapshot& s) const;
  // N on the line, of every volume of the contact term, this rank's part; of a box the first of its rollers
  // among them.
  std::vector<Vec3> forces(const Kinematics& at) const;
  size_t first(size_t box) const { return first_[box]; }

 private:
  const Subject& subject_;
  const LineVolumeContact* contact_;
  std::vector<size_t> first_;  // by box
};

}  // namespace hawser::record
