// Checks of feeders at line ends.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hawser/base/count_of.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/increasing.hpp"

namespace hawser::model {
namespace {

// Time at which the speed rows have paid out the whole stock, s; larger than `end` if they do not.
double runs_out(const Feed& f, double end) {
  std::vector<double> times;  // breakpoints; the speed is linear between them
  for (const auto& [t, v] : f.speed)
    if (t > 0 && t < end) times.push_back(t);
  times.push_back(end);
  double from = 0;
  for (const double to : times) {
    // The largest length within an interval is at its ends or at a zero of the speed.
    const Fed a = fed_by(f, from);
    const Fed b = fed_by(f, to);
    const double slope = (b.speed - a.speed) / (to - from);
    const double top = a.speed > 0 && b.speed < 0 ? from - a.speed / slope : to;
    if (fed_by(f, top).length > f.stock) {
      double low = from;
      double high = top;
      for (int i = 0; i < 60; ++i)
        (fed_by(f, 0.5 * (low + high)).length > f.stock ? high : low) = 0.5 * (low + high);
      return high;
    }
    from = to;
  }
  return HUGE_VAL;
}

// Reason why a line cannot be fed at an end; empty: it can.
std::string why_not_fed(const Case& c, const Line& line, const End& end) {
  if (end.kind == EndKind::joint) return "a joint cannot feed a line; the end must be at an anchor or a body";
  if (end.kind == EndKind::body &&
      (c.floats(c.body_index(end.carrier)) || c.rides(c.body_index(end.carrier))))
    return fmt::format(
        "body '{}' moves by its own equations or rides on a line, and a line can be fed only from an anchor "
        "or a body whose motion is prescribed",
        end.carrier);
  for (const Section& s : line.sections)
    if (const LineType& t = c.line_type(s.type); t.kind != LineKind::cable) {
      if (!end.clamped)
        return fmt::format(
            "line type '{}' resists bending, and such a line must be clamped at a feeder: give the end "
            "'clamped: true' and a 'direction', or the line type 'bending: false'",
            s.type);
      const char* cannot = t.moment_table            ? "bends by a table"
                           : t.stiffness_damping > 0 ? "has 'stiffness_damping'"
                                                     : nullptr;
      if (cannot)
        return fmt::format(
            "line type '{}' {}, and a line that resists bending can be fed only if its bending is linear or "
            "has 'plasticity', without damping",
            s.type, cannot);
    }
  const auto yields = [&](const Section& s) { return c.line_type(s.type).plastic_bending != nullptr; };
  if (std::any_of(line.sections.begin(), line.sections.end(), yields) &&
      std::any_of(line.sections.begin(), line.sections.end(),
                  [&](const Section& s) { return s.type != line.sections.front().type; }))
    return "a line that yields ('plasticity') can be fed only if all its sections are of one type";
  return "";
}

// Checks the minimum number of elements inside the feeder and outside at the start.
void check_elements(const Line& line, LineEnd line_end, const Issues& issue) {
  const Feed& f = *line.end(line_end).feed;
  const Shared<Feed>& beyond = line.end(opposite(line_end)).feed;
  const double other = beyond ? beyond->stock : 0;
  double at = 0;
  int inside = 0, outside = 0;  // number of elements
  for (const Section& s : line.sections)
    for (int i = 0; i < s.elements; ++i) {
      const double middle = at + (i + 0.5) / s.elements * s.length;
      const double from = line_end == LineEnd::B ? length_of(line) - middle : middle;
      if (from < f.stock)
        ++inside;
      else if (length_of(line) - from > other)
        ++outside;
      if (i + 1 == s.elements) at += s.length;
    }
  constexpr int kLeastInside = 2, kLeastOutside = 3;
  if (inside < kLeastInside)
    issue("stock",
          "{:g} m are {} of this line, and a stock needs at least {}: make the stock longer or the "
          "elements shorter",
          f.stock, count_of(inside, "element"), kLeastInside);
  if (outside < kLeastOutside)
    issue("stock", "leaves {} of the line, which is {:g} m long, outside; it must leave at least {}",
          count_of(outside, "element"), length_of(line), kLeastOutside);
}

void check_speed_table(const Feed& f, const Issues& issue) {
  for (std::size_t i = 0; i < f.speed.size(); ++i) {
    if (f.speed[i].first < 0)
      issue(fmt::format("speed_table[{}]", i), "the time {:g} s is before the start of the run",
            f.speed[i].first);
    if (i == 0) continue;
    const std::string fault = increase_fault("times", "s", f.speed[i - 1].first, f.speed[i].first);
    if (!fault.empty()) issue(fmt::format("speed_table[{}]", i), "{}", fault);
  }
}

// Checks other items of the line that cannot enter a feeder.
void check_surroundings(const Case& c, const Line& line, LineEnd line_end, const Issues& issue) {
  const Vec3 place = end_position(c, line.end(line_end));
  const Section& fed = line.end_section(line_end);
  if (c.environment.seabed.present &&
      height_above_bed(c.environment.seabed, place) < c.line_type(fed.type).outer_diameter)
    issue("", "the feeder is on or below the seabed; move it above");
  if (!line.buried.empty()) issue("", "a line with 'buried' stretches cannot be fed");
  if (line.target) issue("", "a line with a 'target' cannot be fed: give the length that meets it");
  if (line.start == Start::other_run) issue("", "a line that starts from another run cannot be fed");
  if (!line.loads.empty()) issue("", "a line with distributed loads cannot be fed");
  for (const Body& b : c.bodies)
    if (b.ride && b.ride->line == line.name)
      issue("", "body '{}' rides on line {}, and a line that carries bodies cannot be fed", b.name,
            line.name);
}

void check_stock(const Case& c, const Feed& f, const Issues& issue) {
  const double end = c.dynamics.duration;
  if (f.speed.empty() || !c.dynamics.enabled || !(end > 0)) return;
  if (const double t = runs_out(f, end); t < end)
    issue("stock",
          "{:g} m are paid out by t = {:.4g} s, and the run goes on to {:g} s: make the line and its stock "
          "that much longer, or stop the feeder before",
          f.stock, t, end);
}

// Cuts of the line by events must not enter the feeder.
void check_cuts(const Case& c, const Line& line, const Feed& f, LineEnd line_end, const Issues& issue) {
  const double end = c.dynamics.duration;
  if (f.speed.empty() || !c.dynamics.enabled || !(end > 0)) return;
  Feed inwards = f;
  for (auto& [t, speed] : inwards.speed) speed = -speed;
  for (std::size_t k = 0; k < c.events.size(); ++k) {
    const Action& a = c.events[k].action;
    if (a.cut < 0 || a.given_line != line.name) continue;
    inwards.stock = (line_end == LineEnd::B ? length_of(line) - a.cut : a.cut) - f.stock;
    if (!(inwards.stock > 0)) continue;  // reported elsewhere
    if (const double t = runs_out(inwards, end); t < end)
      issue(fmt::format("events[{}].cut.at", k),
            "arc length {:.6g} m of line '{}' is hauled in at its end {} by t = {:.4g} s, and a feeder "
            "cannot take in the place of a cut: cut the line further away, or stop the feeder before",
            a.cut, line.name, end_letter(line_end), t);
  }
}

}  // namespace

void check_law(const Feed& f, const Issues& issue) {
  if (f.max_tension == 0 && f.min_tension == 0) return;
  if (!(f.min_tension < f.max_tension))
    issue("dead_band", "[{:g} N, {:g} N] is not a band; the first must be the smaller", f.min_tension,
          f.max_tension);
  else if (!(f.min_tension < f.tension && f.tension < f.max_tension))
    issue("dead_band", "from {:g} N to {:g} N does not hold the 'tension' of {:g} N between its ends",
          f.min_tension, f.max_tension, f.tension);
  if (!(f.speed_per_tension > 0))
    issue("dead_band", "needs 'speed_per_tension', which returns the feeder to its 'tension'");
}

void check_feed(const Case& c, const Line& line, LineEnd line_end, const Issues& all) {
  const End& end = line.end(line_end);
  if (!end.feed) return;
  const Feed& f = *end.feed;
  const Issues issue = all.below(fmt::format("lines.{}.{}.feed", line.name, end_key(line_end)));
  if (const std::string why = why_not_fed(c, line, end); !why.empty()) return issue("", "{}", why);
  check_elements(line, line_end, issue);
  check_speed_table(f, issue);
  const bool changes = std::any_of(c.events.begin(), c.events.end(), [&](const Event& e) {
    return e.action.kind == Action::Kind::feed && e.action.line == line.name && e.action.line_end == line_end;
  });
  if (!changes) {
    check_stock(c, f, issue);
    check_cuts(c, line, f, line_end, all);
  }
  check_law(f, issue);
  for (const PointMass& m : line.masses)
    if ((line_end == LineEnd::B ? length_of(line) - m.at : m.at) < f.stock)
      issue("stock",
            "a mass or buoy at arc length {:g} m is inside the feeder at the start, and only those outside "
            "can be; they must not be hauled in either",
            m.at);
  check_surroundings(c, line, line_end, issue);
}

}  // namespace hawser::model
