// Description of lines for `hawser check`: size, sections, ends, start and loads. Lines that differ only in
// name and end positions are grouped.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "hawser/base/count_of.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/notes.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::model {
namespace {

// (x, y, z) of a single place; for several, the range of each coordinate.
class Places {
 public:
  void add(const Vec3& x) {
    low_ = low_.cwiseMin(x);
    high_ = high_.cwiseMax(x);
  }
  std::string text() const {
    return fmt::format("({}, {}, {})", range_text(low_.x(), high_.x()), range_text(low_.y(), high_.y()),
                       range_text(low_.z(), high_.z()));
  }

 private:
  static std::string range_text(double low, double high) {
    return low == high ? fmt::format("{:g}", low) : fmt::format("{:g} to {:g}", low, high);
  }
  Vec3 low_ = Vec3::Constant(HUGE_VAL), high_ = Vec3::Constant(-HUGE_VAL);
};

// at: position of the end in words.
std::string end_text(const End& e, const std::string& at) {
  if (e.kind == EndKind::free) return "free";
  if (e.kind == EndKind::joint) return "joined at " + e.carrier;
  const std::string where =
      e.kind == EndKind::anchor ? "anchored at " + at : "tied to " + e.carrier + " at " + at;
  return where + (e.clamped                    ? ", clamped"
                  : e.rotational_stiffness > 0 ? fmt::format(", {:g} N m/rad", e.rotational_stiffness)
                                               : "");
}

std::string start_text(Start s) {
  switch (s) {
    case Start::automatic:
      return "auto";
    case Start::catenary:
      return "catenary";
    case Start::hanging:
      return "hanging";
    case Start::straight:
      return "straight";
    case Start::points:
      return "along given points";
    case Start::other_run:
      return "as another run left it";
  }
  return {};
}

std::string temperature_change_text(const Case& c, const Line& l) {
  double lowest = l.temperature_change.front().second;
  double highest = lowest;
  for (const auto& [at, change] : l.temperature_change) {
    lowest = std::min(lowest, change);
    highest = std::max(highest, change);
  }
  const bool colder = lowest < 0 && highest <= 0;
  if (colder) std::tie(lowest, highest) = std::pair(0 - highest, 0 - lowest);
  const double expansion = expansion_of(c, l);
  return fmt::format(
      "{} by {} K, {:.6g} m {} without tension", colder ? "colder" : "warmer",
      lowest == highest ? fmt::format("{:g}", highest) : fmt::format("{:g} to {:g}", lowest, highest),
      std::abs(expansion), expansion < 0 ? "shorter" : "longer");
}

std::string target_text(const LengthTarget& t) {
  using Kind = LengthTarget::Kind;
  const std::string end = fmt::format("end {}", end_letter(t.line_end));
  const std::string target = t.kind == Kind::tension
                                 ? fmt::format("a tension of {:g} kN at {}", t.value / 1000, end)
                             : t.kind == Kind::declination
                                 ? fmt::format("a declination of {:g} deg at {}", t.value * 180 / M_PI, end)
                             : t.kind == Kind::touchdown
                                 ? fmt::format("a touchdown point at {:g} m, the first from {}", t.value, end)
                                 : fmt::format("a laid length of {:g} m", t.value);
  return fmt::format("{}, by the length of section {}, between {:g} and {:g} m", target, t.section + 1,
                     t.min_length, t.max_length);
}

// Description of lines with equal properties, preceded by `name`, and their end positions.
std::string line_text(const Case& c, const Line& l, const std::string& name, const std::string& at_a,
                      const std::string& at_b) {
  const LineSize z = size_of(c, l);
  std::string s = fmt::format("  {}: {:g} m, {}, {}, {}, {:.4g} kg, weight {:.4g} kN\n", name, z.length,
                              count_of(z.elements, "element"), count_of(z.nodes, "node"),
                              count_of(z.unknowns, "unknown"), z.mass, z.mass * c.environment.gravity / 1000);
  for (const Section& sec : l.sections) {
    const LineType& t = c.line_type(sec.type);
    s += fmt::format("    {:g} m of {} ({}, diameter {:g} m, {:g} kg/m), {}{}\n", sec.length, t.name,
                     t.kind == LineKind::beam ? "beam" : "cable", t.outer_diameter, t.mass_per_length,
                     count_of(sec.elements, "element"),
                     sec.grading == 1 ? "" : fmt::format(", last / first {:g}", sec.grading));
  }
  s += fmt::format("    end A {}; end B {}; start {}\n", end_text(l.end_a, at_a), end_text(l.end_b, at_b),
                   start_text(l.start));
  if (l.target) s += "    target: " + target_text(*l.target) + "\n";
  if (!l.bend_stiffeners.empty()) s += fmt::format("    {} bend stiffeners\n", l.bend_stiffeners.size());
  if (!l.temperature_change.empty()) s += "    " + temperature_change_text(c, l) + "\n";
  if (!l.masses.empty() || !l.loads.empty() || !l.point_loads.empty())
    s += fmt::format("    {} point masses, {} distributed loads, {} point loads\n", l.masses.size(),
                     l.loads.size(), l.point_loads.size());
  return s;
}

}  // namespace

LineSize size_of(const Case& c, const Line& line) {
  LineSize z;
  z.length = length_of(line);
  z.nodes = 1;
  bool beam_before = false;
  for (std::size_t i = 0; i < line.sections.size(); ++i) {
    const Section& s = line.sections[i];
    const LineType& t = c.line_type(s.type);
    const bool beam = t.kind == LineKind::beam;
    // The node between two sections has rotations if either is a beam.
    if (i == 0) z.unknowns += beam ? 6 : 3;
    if (i > 0 && beam && !beam_before) z.unknowns += 3;
    z.unknowns += (beam ? 6LL : 3LL) * s.elements;
    z.elements += s.elements;
    z.nodes += s.elements;
    z.mass += t.mass_per_length * s.length;
    beam_before = beam;
  }
  for (const PointMass& m : line.masses) z.mass += m.mass;
  return z;
}

std::string description_of(const Case& c, const Line& line) { return line_text(c, line, "", "", ""); }

std::string lines_text(const Case& c) {
  struct LikeLines {
    const Line* first = nullptr;
    std::vector<std::string> names;
    Places a, b;
  };
  std::vector<LikeLines> groups;
  std::map<std::string, std::size_t> known;
  for (const Line& l : c.lines) {
    if (is_repeated(c, l.name)) continue;
    const auto [at, is_new] = known.emplace(description_of(c, l), groups.size());
    if (is_new) groups.push_back({&l, {}, {}, {}});
    LikeLines& g = groups[at->second];
    g.names.push_back(l.name);
    g.a.add(l.end_a.at);
    g.b.add(l.end_b.at);
  }
  std::string s;
  for (const LikeLines& g : groups)
    s += line_text(c, *g.first, names_text(g.names) + (g.names.size() > 1 ? ", each" : ""), g.a.text(),
                   g.b.text());
  return s;
}

}  // namespace hawser::model
