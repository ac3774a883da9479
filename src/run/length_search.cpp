// The class LengthSearch: value of the target quantity at rest, and start and end of the search.
#include "hawser/run/length_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/mpi.hpp"
#include "hawser/math/declination.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::run {
namespace {

using model::LengthTarget;
using Kind = LengthTarget::Kind;

constexpr double kTolerance = 1e-7;  // of the tension, of the length, rad
// Final width of a search relative to the length, and the error accepted there, which statics cannot resolve.
constexpr double kNarrow = 1e-10, kCoarse = 1e-5;
constexpr double kFirstStep = 0.02, kNextStep = 1e-3;  // of the length

}  // namespace

AtRest at_rest(MPI_Comm comm, Simulation& sim) {
  const Kinematics at = sim.state().at_rest();
  const LocalMesh& local = sim.local();
  std::vector<Vec3> support_forces(static_cast<size_t>(local.nodes()), Vec3::Zero());
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources()) {
    if (!f.is_support_force) continue;
    std::vector<double> values(3 * static_cast<size_t>(local.owned));
    f.fill(at, values);
    for (size_t n = 0; n < static_cast<size_t>(local.owned); ++n)
      support_forces[n] += Eigen::Map<const Vec3>(values.data() + 3 * n).cwiseAbs();
  }
  sim.system().update_ghosts(support_forces);
  record::EndForces ends(sim.system(), sim.feeders());
  ends.evaluate(at, support_forces);
  AtRest out;
  out.ends.assign(4 * sim.mesh().lines.size(), 0);
  for (const record::EndForces::SectionNode& p : ends.places()) {
    if (!p.line_end) continue;
    const record::SectionForce& s = p.at_line_end();
    double* end = &out.ends[4 * static_cast<size_t>(p.line) + 2 * end_index(*p.line_end)];
    end[0] = s.tension();
    end[1] = declination(s.direction);
  }
  all_reduce(comm, MPI_SUM, out.ends);
  out.feeders = ends.at_feeders();
  out.down = record::Touchdowns(comm, sim.model(), sim.local()).of_all_lines(at);
  return out;
}

LengthSearch::LengthSearch(const model::Case& c, size_t line)
    : line_(line),
      t_(*c.lines[line].target),
      key_(fmt::format("lines.{}.sections[{}]", c.lines[line].name, t_.section)),
      given_(c.lines[line].sections[t_.section].length),
      other_sections_(model::length_of(c.lines[line]) - given_) {
  begin(given_, kFirstStep * given_);
}

LengthSearch::LengthSearch(const model::Case& c, size_t line, LineEnd line_end, int feeder)
    : line_(line), feeder_(feeder), other_sections_(0) {
  const model::Line& l = c.lines[line];
  const model::Feed& feed = *l.end(line_end).feed;
  key_ = fmt::format("lines.{}.{}.feed.stock", l.as_given().name, end_key(line_end));
  t_.value = feed.tension;
  t_.line_end = line_end;
  t_.max_length = model::length_of(l);
  given_ = feed.stock;
  begin(given_, kNextStep * (t_.max_length - given_));
}

void LengthSearch::begin(double from, double step) {
  // A longer line is expected to have lower tension, to hang more steeply and to lie more; a longer stock
  // leaves less outside.
  const bool falls = feeder_ < 0 && (t_.kind == Kind::tension ||
                                     (t_.kind == Kind::declination && t_.line_end == LineEnd::B) ||
                                     (t_.kind == Kind::touchdown && t_.line_end == LineEnd::A));
  length_ = from;
  search_ = RootSearch(from, falls ? -step : step, t_.min_length, t_.max_length);
}

void LengthSearch::restart() { begin(last_solved_, kNextStep * last_solved_); }

bool LengthSearch::narrow() const { return search_.bracketed() && search_.width() < kNarrow * length_; }

double LengthSearch::reached(const AtRest& now) const {
  if (feeder_ >= 0) return now.feeders[feeder_];
  if (t_.kind == Kind::tension || t_.kind == Kind::declination)
    return now.ends[4 * line_ + 2 * end_index(t_.line_end) + (t_.kind == Kind::tension ? 0 : 1)];
  const record::Touchdown& down = now.down[line_];
  if (t_.kind == Kind::laid_length) return down.laid;
  const auto& point = t_.line_end == LineEnd::A ? down.from_a : down.from_b;
  // A fully hanging line touches down at its other end, a fully lying line at this end.
  if (!point) return (down.laid > 0) == (t_.line_end == LineEnd::A) ? 0 : other_sections_ + length_;
  return point->arc;
}

double LengthSearch::error() const {
  const double scale = t_.kind == Kind::tension       ? t_.value
                       : t_.kind == Kind::declination ? 1
                                                      : other_sections_ + length_;
  return given_kept_ ? 0 : std::abs(value_ - t_.value) / scale;
}

bool LengthSearch::update(const AtRest& now) {
  if (given_kept_) return false;
  const bool met_before = met_;
  value_ = reached(now);
  last_solved_ = length_;
  near_ = error() <= kCoarse;
  met_ = error() <= kTolerance || (narrow() && near_);
  return met_before && !met_;
}

advice::LengthSearched LengthSearch::searched(const model::Case& c) const {
  return {.line = c.lines[line_].name,
          .target = t_,
          .in_feeder = feeder_ >= 0,
          .given = given_,
          .length = length_,
          .value = value_};
}

std::string LengthSearch::now(const model::Case& c) const { return advice::length_tried(searched(c)); }

std::string LengthSearch::solved_sentence(const model::Case& c, int trials) const {
  return given_kept_ ? advice::feeder_not_at_rest(searched(c), tried())
                     : advice::length_solved(searched(c), trials);
}

// Trials as pairs of length and deviation from the target.
advice::LengthsTried LengthSearch::tried() const {
  advice::LengthsTried out;
  out.why = why_;
  const auto& values = search_.values();
  if (values.empty()) return out;
  const auto [low, high] = std::minmax_element(
      values.begin(), values.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto trial = [&](const auto& v) { return advice::LengthsTried::Trial(v.first, v.second + t_.value); };
  out.range = {trial(values.front()), trial(values.back()), trial(*low), trial(*high)};
  if (narrow()) out.jumps = length_;
  return out;
}

void LengthSearch::end_without_length(const model::Case& c) {
  if (feeder_ < 0)
    c.refuse(fmt::format("lines.{}.target", c.lines[line_].name),
             advice::length_not_solved(searched(c), tried()));
  given_kept_ = met_ = true;
  length_ = given_;
}

}  // namespace hawser::run
