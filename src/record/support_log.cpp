// The class SupportLog: the rows of boxes, and which of them a line is off or never lies on.
#include "hawser/record/support_log.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/supports.hpp"
#include "hawser/base/gather.hpp"

namespace hawser::record {

SupportLog::SupportLog(const Subject& subject)
    : subject_(subject),
      rollers_(subject),
      off_(subject.model.supports.size(), false),
      carried_(off_),
      lowest_(off_.size(), HUGE_VAL) {}

void SupportLog::declare(Declarations& to) {
  for (const model::SupportBox& b : subject_.model.supports) {
    io::ResultSeries& s = to.contents.series.emplace_back(io::ResultSeries{b.name, {{"force", "N", 3}}});
    for (const std::string& roller : b.rollers) s.columns.push_back({roller + "_force", "N", 3});
    for (const char* name : {"height", "offset", "arc_length"}) s.columns.push_back({name, "m", 1});
  }
}

void SupportLog::step(const Snapshot& s) {
  const model::Case& c = subject_.model;
  const std::vector<SupportCrossing> crosses = rollers_.crossings(s);
  std::vector<Vec3> forces = rollers_.forces(s.at);
  const int rank = rank_of(subject_.comm());
  MPI_Reduce(rank == 0 ? MPI_IN_PLACE : forces.data(), forces.data(), 3 * static_cast<int>(forces.size()),
             MPI_DOUBLE, MPI_SUM, 0, subject_.comm());
  rows_.assign(c.supports.size(), {});
  for (size_t k = 0; k < rows_.size() && rank == 0; ++k) {
    const model::SupportBox& b = c.supports[k];
    const SupportCrossing& x = crosses[k];
    std::vector<double>& row = rows_[k];
    const auto of = [&](size_t i) -> const Vec3& { return forces[rollers_.first(k) + i]; };
    Vec3 sum = Vec3::Zero();
    for (size_t i = 0; i < b.rollers.size(); ++i) sum += of(i);
    row.assign(sum.begin(), sum.end());
    if (sum != Vec3::Zero()) carried_[k] = true;
    if (x.known) lowest_[k] = std::min(lowest_[k], x.height);
    for (size_t i = 0; i < b.rollers.size(); ++i) row.insert(row.end(), of(i).begin(), of(i).end());
    for (const double value : {x.height, x.offset, x.arc}) row.push_back(x.known ? value : std::nan(""));
    if (off_[k] || !x.known || std::abs(x.offset) <= b.half_width || x.height >= b.rise) continue;
    off_[k] = true;
    warnings_.push_back(advice::off_rollers(b, x, s.at.time));
  }
}

void SupportLog::rows(const Snapshot&, Rows& to) { to.insert(to.end(), rows_.begin(), rows_.end()); }

std::vector<Finding> SupportLog::findings(const std::vector<io::SummaryRow>&, const Audit&) {
  std::vector<Finding> out;
  for (const std::string& w : warnings_) out.push_back({w});
  const model::Case& c = subject_.model;
  for (size_t k = 0; k < lowest_.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    double diameter = 0;
    for (const model::Section& s : c.line(b.line).sections)
      diameter = std::max(diameter, c.line_type(s.type).outer_diameter);
    bool first = true, any = false, further = false;  // of the line's boxes
    for (size_t j = 0; j < lowest_.size(); ++j) {
      if (c.supports[j].line != b.line) continue;
      first = first && j >= k;
      any = any || carried_[j];
      further = further || (j > k && carried_[j]);
    }
    // What lies clear of the last ones is laid as it is meant to be; by less than a diameter over one
    // between, the next have been set a little high.
    if (further && !carried_[k] && lowest_[k] > diameter)
      out.push_back({advice::never_carries(b, lowest_[k])});
    if (first && !any) out.push_back({advice::none_carries(b.line)});
  }
  return out;
}

}  // namespace hawser::record
