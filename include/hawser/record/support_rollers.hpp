// Positions of lines in their supports, and the supports that carry them.
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

// Crossing of every box with the nearest part of its line. poses: of the bodies of the case. The same on all
// ranks. Collective.
std::vector<SupportCrossing> support_crossings(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                               const Kinematics& state, const std::vector<RigidPose>& poses);

// Rollers of the supports of a case. The subject must outlive the object.
class SupportRollers {
 public:
  explicit SupportRollers(const Subject& subject);

  // Crossing of every box. Collective.
  std::vector<SupportCrossing> crossings(const Snapshot& s) const;
  // For each line the arc lengths [m] of the first and last box that carry it, the same on all ranks; first
  // above second: none. Collective.
  std::vector<std::array<double, 2>> carrying(const Snapshot& s) const;
  // Forces on the lines [N] by volume of the contact term, this rank's part; first(): the first roller of a
  // box among these volumes.
  std::vector<Vec3> forces(const Kinematics& state) const;
  size_t first(size_t box) const { return first_[box]; }

 private:
  const Subject& subject_;
  const LineVolumeContact* contact_;
  std::vector<size_t> first_;  // by box
};

}  // namespace hawser::record
