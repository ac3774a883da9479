// The class TensionPeaks: folds are reported first, because their straightening is also an impact.
#include "hawser/record/tension_peaks.hpp"

#include "hawser/record/line_extremes.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

TensionPeaks::TensionPeaks(const Subject& subject, const EdgeErrors* errors, const Audit& audit)
    : subject_(subject),
      errors_(errors),
      audit_(audit),
      folds_(subject.model, subject.local(), subject.term<Feeders>()),
      snaps_(subject.model, subject.local()) {}

void TensionPeaks::declare(Declarations& to) {
  const char *before = "effective_tension_before", *after = "effective_tension_after";
  before_ = find_field(to.contents.fields, before);
  after_ = find_field(to.contents.fields, after);
  to.every_step.insert({before, after});
}

void TensionPeaks::step(const Snapshot& s) {
  folds_.update(s.at, s.values[before_], s.values[after_]);
  snaps_.update(s.step.time, s.step.h, s.values[before_], s.values[after_],
                errors_ ? &errors_->volume_passages() : nullptr);
}

std::vector<Warning> TensionPeaks::warnings(const std::vector<io::SummaryRow>& summary) {
  const model::Case& c = subject_.model;
  folds_.gather(subject_.comm());
  snaps_.gather(subject_.comm());
  std::vector<Warning> out;
  for (size_t i = 0; i < summary.size(); ++i) {
    const io::SummaryRow& r = summary[i];
    if (!is_largest_tension(c, r)) continue;
    const int line = c.line_index(r.line);
    std::string text = folds_.warning(line, r.line, r.value);
    if (text.empty())
      text = snaps_.warning(line, r.line, r.value, !audit_.note().empty(), advice::step_choice(c));
    if (!text.empty()) out.push_back({std::move(text), i});
  }
  return out;
}

}  // namespace hawser::record
