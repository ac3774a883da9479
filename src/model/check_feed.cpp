// Checks of what feeds a line at one of its ends.
#include <fmt/format.h>

#include <algorithm>

#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"

namespace hawser::model {
namespace {

// Whether contact lets this line touch lines, itself among them.
bool touches_lines(const Case& c, const Line& line) {
  const BetweenLines& b = c.contact.between_lines;
  if (!b.enabled || !c.contact.takes_part(line)) return false;
  const auto excluded = [&](const Line& other) {
    return std::any_of(b.exclude.begin(), b.exclude.end(), [&](const auto& pair) {
      return (pair.first == line.name && pair.second == other.name) ||
             (pair.second == line.name && pair.first == other.name);
    });
  };
  return std::any_of(c.lines.begin(), c.lines.end(), [&](const Line& other) {
    return c.contact.takes_part(other) && (&other != &line || b.self) && !excluded(other);
  });
}

}  // namespace

std::vector<Issue> law_issues(const Feed& f) {
  std::vector<Issue> out;
  const auto issue = [&out](const char* key, std::string text) { out.push_back({key, std::move(text)}); };
  if (f.most > 0 || f.least > 0) {
    if (!(f.least < f.most))
      issue("dead_band",
            fmt::format("from {:g} N to {:g} N is no band; the first must be the smaller", f.least, f.most));
    else if (!(f.least < f.tension && f.tension < f.most))
      issue("dead_band",
            fmt::format("from {:g} N to {:g} N does not hold the 'tension' of {:g} N between its ends",
                        f.least, f.most, f.tension));
    if (!(f.speed_per_tension > 0))
      issue("dead_band", "needs 'speed_per_tension', by which the feeder comes back to its 'tension'");
  }
  return out;
}

void check_feed(const Case& c, const Line& line, bool at_b, std::vector<Issue>& issues) {
  const End& end = at_b ? line.end_b : line.end_a;
  if (!end.feed) return;
  const Feed& f = *end.feed;
  const std::string key = fmt::format("lines.{}.end_{}.feed", line.name, at_b ? 'b' : 'a');
  const auto issue = [&](const std::string& of, std::string text) {
    issues.push_back({of.empty() ? key : key + "." + of, std::move(text)});
  };
  if (end.kind == EndKind::joint)
    return issue("", "a joint cannot feed a line; the end must be at an anchor or a body");
  if (end.kind == EndKind::body && (c.floats(c.body_index(end.body)) || c.rides(c.body_index(end.body))))
    return issue("",
                 fmt::format("body '{}' moves by its own equations or rides on a line, and a line can be fed "
                             "only from an anchor or a body whose motion is prescribed",
                             end.body));
  for (const Section& s : line.sections)
    if (const LineType& t = c.line_type(s.type); t.kind != LineKind::cable) {
      if (!end.clamped)
        return issue(
            "",
            fmt::format("line type '{}' resists bending, and a feeder holds such a line clamped: give the "
                        "end 'clamped: true' and a 'direction', or the line type 'bending: false'",
                        s.type));
      const char* cannot = t.plastic_bending         ? "yields ('plasticity')"
                           : t.moment_table          ? "bends by a table"
                           : t.stiffness_damping > 0 ? "has 'stiffness_damping'"
                                                     : nullptr;
      if (cannot)
        return issue("",
                     fmt::format("line type '{}' {}, and what resists bending can be fed only where it bends "
                                 "linearly and without damping",
                                 s.type, cannot));
    }
  double at = 0,
         other = (at_b ? line.end_a : line.end_b).feed ? (at_b ? line.end_a : line.end_b).feed->stock : 0;
  int inside = 0, outside = 0;  // elements
  for (const Section& s : line.sections)
    for (int i = 0; i < s.elements; ++i) {
      const double middle = at + (i + 0.5) / s.elements * s.length,
                   from = at_b ? length_of(line) - middle : middle;
      if (from < f.stock)
        ++inside;
      else if (length_of(line) - from > other)
        ++outside;
      if (i + 1 == s.elements) at += s.length;
    }
  constexpr int kLeastInside = 2, kLeastOutside = 3;
  if (inside < kLeastInside)
    issue("stock",
          fmt::format("{:g} m are {} element{} of this line, and a stock needs {} at least: make it longer "
                      "or the elements shorter",
                      f.stock, inside, inside == 1 ? "" : "s", kLeastInside));
  if (outside < kLeastOutside)
    issue("stock",
          fmt::format("leaves {} elements of the line, which is {:g} m long, outside; {} are the least",
                      outside, length_of(line), kLeastOutside));
  for (std::size_t i = 0; i < f.speed.size(); ++i) {
    if (f.speed[i].first < 0)
      issue(fmt::format("speed_table[{}]", i),
            fmt::format("the time {:g} s is before the start of the run", f.speed[i].first));
    if (i > 0 && !(f.speed[i].first > f.speed[i - 1].first))
      issue(fmt::format("speed_table[{}]", i),
            fmt::format("the time {:g} s does not follow {:g} s; times must grow from row to row",
                        f.speed[i].first, f.speed[i - 1].first));
  }
  for (Issue& i : law_issues(f)) issue(i.key, std::move(i.text));
  for (const PointMass& m : line.masses)
    if ((at_b ? length_of(line) - m.at : m.at) < f.stock)
      issue(
          "stock",
          fmt::format("a mass or buoy at arc length {:g} m is inside the feeder at the start, and only those "
                      "outside can be; they must not be hauled in either",
                      m.at));
  const Vec3 place = end_position(c, end);
  if (c.environment.seabed.present &&
      height_above_bed(c.environment.seabed, place) < c.line_type(line.sections.front().type).outer_diameter)
    issue("", "the feeder is on the seabed or below it, where what is inside would lie; put it above");
  if (!line.buried.empty()) issue("", "a line with 'buried' stretches cannot be fed");
  if (line.target) issue("", "a line with a 'target' cannot be fed: give the length that meets it");
  if (line.start == Start::other_run) issue("", "a line that starts from another run cannot be fed");
  if (!line.loads.empty()) issue("", "a line with distributed loads cannot be fed");
  if (touches_lines(c, line))
    issue("", fmt::format("what is inside the feeder would touch itself there: leave line {} out of contact "
                          "between lines ('contact: {{between_lines: false}}', or 'exclude' under it)",
                          line.name));
}

}  // namespace hawser::model
