// Reactions of supports of laid lines and positions of lines in them at every accepted step, with warnings on
// lines that are beyond the end of a roller or never rest on it.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/support_rollers.hpp"

namespace hawser::record {

class SupportLog : public Recording {
 public:
  // The subject must outlive the object.
  explicit SupportLog(const Subject& subject);

  // One series per box: `force` and `<roller>_force` on the line [N, space axes], `height`, `offset` and
  // `arc_length` of its crossing.
  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  void rows(const Snapshot& s, Rows& to) override;
  // Each box once when a line is first beyond the end of its rollers; then boxes that never carried their
  // line although later boxes did, and groups that never carried one.
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

 private:
  const Subject& subject_;
  SupportRollers rollers_;
  std::vector<Vec3> forces_;                // N, last step, all contact volumes: this rank's part
  std::vector<SupportCrossing> crossings_;  // last step
  std::vector<bool> reported_;              // by box: the line has been beyond the end of its rollers
  std::vector<int>
      loaded_;  // not 0: a line has touched a part of the box on this rank; warnings() joins the ranks
  std::vector<double> lowest_;  // m, height of the line over each box; infinite: no crossing
  std::vector<std::string> warnings_;
};

}  // namespace hawser::record
