// Reactions of the supports of laid lines and where the lines pass them, at every accepted step; and lines
// that are off the end of a roller or start beneath one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/subject.hpp"

namespace hawser {
class LineVolumeContact;
}

namespace hawser::record {

// Where the axis of a line goes through the plane across the path at a box, as the box sees it, m.
struct SupportCrossing {
  bool known = false;  // nothing of the line goes through it
  double offset = 0;   // to the left of the middle
  double height = 0;   // above where a line that just touches the roller below has its axis
  double arc = 0;      // unstretched, of the line from its end A
};
// Of every box, of what is nearest to it. poses: of the bodies of the case. The same on all ranks.
// Collective.
std::vector<SupportCrossing> support_crossings(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                               const Kinematics& at, const std::vector<RigidPose>& poses);

// A line that starts beneath the rollers that it should lie on, in one sentence with the remedy; its key is
// that of the support that is out of line with its neighbours, if one is. nullopt: none does. poses: of the
// bodies.
struct Beneath {
  std::string key, why;
};
std::optional<Beneath> beneath_supports(const model::Case& c, const std::vector<SupportCrossing>& crossings,
                                        const std::vector<RigidPose>& poses);

// That a line which is laid over supports was bent farther than steel stays elastic, of a row of the summary;
// empty: it was not.
std::string overbent(const model::Case& c, const io::SummaryRow& row);

class SupportLog {
 public:
  SupportLog(MPI_Comm comm, const Subject& subject);

  // One for each box: `force` and `<roller>_force` on the line [N, space axes], `height`, `offset` and
  // `arc_length` of its crossing.
  std::vector<io::ResultSeries> series() const;
  // Their rows at a state, on rank 0 (elsewhere empty). Collective.
  std::vector<std::vector<double>> rows(const Kinematics& at, const std::vector<io::BodyPose>& poses);
  // Of each line the arc lengths [m] of the first and the last box that carry it, the same on all ranks; the
  // first above the second: none does. Collective.
  std::vector<std::array<double, 2>> carrying(const Kinematics& at,
                                              const std::vector<io::BodyPose>& poses) const;
  // Every box once off the end of whose rollers a line was, the first time it was; then those over which a
  // line went clear so far, although boxes further on carried it, and groups that never carried one. On rank
  // 0.
  std::vector<std::string> warnings() const;

 private:
  // Of every box, with these poses of the bodies.
  std::vector<SupportCrossing> crossings(const Kinematics& at, const std::vector<io::BodyPose>& poses) const;

  MPI_Comm comm_;
  const Subject& subject_;
  const LineVolumeContact* contact_;
  std::vector<int> first_;  // of each box, its first roller among the volumes of the contact term
  std::vector<bool> off_;   // told of already
  std::vector<bool> carried_;
  std::vector<double> lowest_;  // m, height of the line over each; infinite: it did not cross it
  std::vector<std::string> warnings_;
};

}  // namespace hawser::record
