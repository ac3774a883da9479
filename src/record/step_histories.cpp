// Columns and rows of the histories of touchdown, terms, feeders and steps. Rank 0 adds values that
// every rank has.
#include "hawser/record/step_histories.hpp"

#include <fmt/format.h>

#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {
namespace {

void add_on_first(const Subject& subject, std::vector<double> row, Rows& to) {
  to.add(rank_of(subject.comm()) == 0 ? std::move(row) : std::vector<double>{});
}

}  // namespace

void TouchdownHistory::declare(Declarations& to) {
  io::ResultSeries series{"touchdown",
                          {{"end_a_arc_length", "m", 1},
                           {"end_a_position", "m", 3},
                           {"end_b_arc_length", "m", 1},
                           {"end_b_position", "m", 3},
                           {"laid_length", "m", 1}}};
  series.by_line = true;
  to.contents.series.push_back(std::move(series));
}

void TouchdownHistory::rows(const Snapshot& s, Rows& to) {
  std::vector<double> row;
  for (const Touchdown& t : s.touchdowns()) {
    if (!owns_line(subject_.local(), t.line)) continue;
    for (const auto& p : {t.from_a, t.from_b}) {
      row.push_back(p ? p->arc : std::nan(""));
      for (int k = 0; k < 3; ++k) row.push_back(p ? p->position[k] : std::nan(""));
    }
    row.push_back(t.laid);
  }
  to.add(std::move(row));
}

TermHistory::TermHistory(const Subject& subject) : terms_(subject.system.with<HasSeries>()) {}

void TermHistory::declare(Declarations& to) {
  for (const HasSeries* term : terms_)
    for (Series& s : term->series()) to.contents.series.push_back({std::move(s.name), std::move(s.columns)});
}

void TermHistory::rows(const Snapshot& s, Rows& to) {
  for (const HasSeries* term : terms_)
    for (std::vector<double>& row : term->rows(s.at)) to.add(std::move(row));
}

FeederHistory::FeederHistory(const Subject& subject) : subject_(subject), feeders_(subject.term<Feeders>()) {}

void FeederHistory::declare(Declarations& to) {
  if (!feeders_) return;
  for (const Feeder& f : feeders_->all())
    to.contents.series.push_back(
        {fmt::format("{} {} feed", subject_.model.lines[f.line].name, end_key(f.line_end)),
         {{"paid_out", "m", 1}, {"feed_speed", "m/s", 1}, {"tension", "N", 1}, {"mouth_length", "m", 1}}});
}

void FeederHistory::rows(const Snapshot& s, Rows& to) {
  if (!feeders_) return;
  for (size_t k = 0; k < feeders_->all().size(); ++k) {
    const Feeder& f = feeders_->all()[k];
    add_on_first(subject_,
                 {feeders_->outside(f) - f.outside_at_start, f.speed, s.end_forces.at_feeders()[k], f.length},
                 to);
  }
}

void StepHistory::declare(Declarations& to) {
  to.contents.series.push_back(
      {"solver", {{"step", "s", 1}, {"newton_iterations", "1", 1}, {"rejected", "1", 1}}});
}

void StepHistory::rows(const Snapshot& s, Rows& to) {
  add_on_first(subject_,
               {s.step.h, static_cast<double>(s.step.iterations), static_cast<double>(s.step.rejected)}, to);
}

}  // namespace hawser::record
