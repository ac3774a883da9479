// The class SupportLog: rows of boxes, and warnings on their lines.
#include "hawser/record/support_log.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/supports.hpp"
#include "hawser/base/mpi.hpp"

namespace hawser::record {

SupportLog::SupportLog(const Subject& subject)
    : subject_(subject),
      rollers_(subject),
      reported_(subject.model.supports.size(), false),
      loaded_(reported_.size(), 0),
      lowest_(reported_.size(), HUGE_VAL) {}

void SupportLog::declare(Declarations& to) {
  for (const model::SupportBox& b : subject_.model.supports) {
    io::ResultSeries& s = to.contents.series.emplace_back(io::ResultSeries{b.name, {{"force", "N", 3}}});
    for (const std::string& roller : b.rollers) s.columns.push_back({roller + "_force", "N", 3});
    for (const char* name : {"height", "offset", "arc_length"}) s.columns.push_back({name, "m", 1});
  }
}

void SupportLog::step(const Snapshot& s) {
  const model::Case& c = subject_.model;
  crossings_ = rollers_.crossings(s);
  forces_ = rollers_.forces(s.at);
  for (size_t k = 0; k < c.supports.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    const SupportCrossing& x = crossings_[k];
    for (size_t i = 0; i < b.rollers.size(); ++i)
      if (forces_[rollers_.first(k) + i] != Vec3::Zero()) loaded_[k] = 1;
    if (x.known) lowest_[k] = std::min(lowest_[k], x.height);
    if (reported_[k] || !x.known || std::abs(x.offset) <= b.half_width || x.height >= b.rise) continue;
    reported_[k] = true;
    warnings_.push_back(advice::off_rollers(b, x, s.at.time));
  }
}

void SupportLog::rows(const Snapshot&, Rows& to) {
  const model::Case& c = subject_.model;
  const bool first = rank_of(subject_.comm()) == 0;
  for (size_t k = 0; k < c.supports.size(); ++k) {
    std::vector<double> row(3, 0.0);  // sum over the rollers
    for (size_t i = 0; i < c.supports[k].rollers.size(); ++i) {
      const Vec3& of_roller = forces_[rollers_.first(k) + i];
      for (int n = 0; n < 3; ++n) row[n] += of_roller[n];
      row.insert(row.end(), of_roller.begin(), of_roller.end());
    }
    const SupportCrossing& x = crossings_[k];  // equal on all ranks
    for (const double value : {x.height, x.offset, x.arc})
      row.push_back(!first ? 0 : x.known ? value : std::nan(""));
    to.add_part(std::move(row));
  }
}

std::vector<Warning> SupportLog::warnings(const std::vector<io::SummaryRow>&) {
  std::vector<Warning> out;
  for (const std::string& w : warnings_) out.push_back({w});
  all_reduce(subject_.comm(), MPI_MAX, loaded_);
  if (rank_of(subject_.comm()) != 0) return {};
  const model::Case& c = subject_.model;
  for (size_t k = 0; k < lowest_.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    double diameter = 0;
    for (const model::Section& s : c.line(b.line).sections)
      diameter = std::max(diameter, c.line_type(s.type).outer_diameter);
    bool first = true, any_loaded = false, later_loaded = false;  // of the line's boxes
    for (size_t j = 0; j < lowest_.size(); ++j) {
      if (c.supports[j].line != b.line) continue;
      first = first && j >= k;
      any_loaded = any_loaded || loaded_[j] != 0;
      later_loaded = later_loaded || (j > k && loaded_[j] != 0);
    }
    // Being clear of the last boxes is the intended laying state; a clearance below one diameter over an
    // inner box means that the next are slightly high.
    if (later_loaded && loaded_[k] == 0 && lowest_[k] > diameter)
      out.push_back({advice::never_carries(b, lowest_[k])});
    if (first && !any_loaded) out.push_back({advice::none_carries(b.line)});
  }
  return out;
}

}  // namespace hawser::record
