// Reactions of the supports of laid lines and where the lines pass them, at every accepted step; and lines
// that are off the end of a roller or never lie on it.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/support_rollers.hpp"

namespace hawser::record {

class SupportLog : public Recording {
 public:
  // The subject outlives it.
  explicit SupportLog(const Subject& subject);

  // A series for each box: `force` and `<roller>_force` on the line [N, space axes], `height`, `offset` and
  // `arc_length` of its crossing.
  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  void rows(const Snapshot& s, Rows& to) override;
  // Every box once off the end of whose rollers a line was, the first time it was; then those over which a
  // line went clear so far, although boxes further on carried it, and groups that never carried one.
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

 private:
  const Subject& subject_;
  SupportRollers rollers_;
  std::vector<Vec3> forces_;  // N, of the last step, of all volumes of the contact: this rank's part
  std::vector<SupportCrossing> crossings_;  // of the last step
  std::vector<bool> off_;                   // reported already
  std::vector<int>
      carried_;  // not 0: a line has touched a part of the box on this rank; findings() joins the ranks
  std::vector<double> lowest_;  // m, height of the line over each; infinite: it did not cross it
  std::vector<std::string> warnings_;
};

}  // namespace hawser::record
