// Warnings of lines that penetrate a volume deeper than is acceptable for that volume.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser {
class LineVolumeContact;
}  // namespace hawser

namespace hawser::record {

class DeepContacts : public Recording {
 public:
  // The subject must outlive the object.
  explicit DeepContacts(const Subject& subject);

  void start(const Snapshot& s) override { step(s); }
  void step(const Snapshot& s) override;
  // No rows; exchanges the deepest contacts between the ranks.
  std::vector<io::SummaryRow> summary() override;
  // Warnings for the rows "max penetration" of lines.
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;
  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  // The contact of a line whose depth is the largest multiple of the acceptable one.
  struct Deepest {
    int line = -1, volume = -1;  // indices into the case
    double factor = 1;           // depth over the acceptable depth
    double depth = 0, time = 0, arc_length = 0;
    double stiffness = 0;          // N/m per m, automatic
    int impact = 0, stiffest = 0;  // 1: advice::PenetratedStiffness::in_impact, highest

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("line", "", self.line);
      each("volume", "", self.volume);
      each("factor", "", self.factor);
      each("depth", "m", self.depth);
      each("time", "s", self.time);
      each("arc length", "m", self.arc_length);
      each("stiffness", "N/m^2", self.stiffness);
      each("impact", "", self.impact);
      each("stiffest", "", self.stiffest);
    }
  };
  using PerLine = std::map<int, Deepest>;  // lines with unacceptable depths only
  static void put(const Deepest& d, PerLine& to);
  // True if the step is as short as those that resolve an impact on the stiffness of the volume.
  bool in_impact(const ActiveContact& at, const Snapshot& s) const;

  const Subject& subject_;
  const LineVolumeContact* contact_;  // null: no volumes
  std::vector<int> volumes_;          // of the term: index into Case::volumes
  PerLine of_rank_, of_run_;
};

}  // namespace hawser::record
