// Lower bounds of strain and tension from the distance of the ends, loads and weight, compared with breaking
// loads; lines far longer than the distance of their ends, or hanging with too few elements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/count_of.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"

namespace hawser::advice {

using namespace model;

namespace {

// Strains far above those of designs: steel wire and chain break at 1 to 2 %, polyester at 10 %, nylon at 40
// % (ISO 18692, ISO 19901-7).
constexpr double kMetalStrain = 0.01, kFibreStrain = 0.1;
constexpr double kMetal = 20e9;  // Pa, smallest modulus of a metal
constexpr double kLong = 10;     // length over distance of the ends
constexpr int kFew = 5;          // elements of a hanging line; with fewer the tension error is 10 % or more
constexpr double kSlack = 1.01;  // length over distance of the ends, for a sagging line
constexpr double kDeepLong = 5;  // and over that plus the heights of both ends above the bed

double allowed_strain(const LineType& t) {
  return t.EA / (M_PI / 4 * t.outer_diameter * t.outer_diameter) > kMetal ? kMetalStrain : kFibreStrain;
}

// Adds one warning for a section that a tension [N] overstretches or overloads.
void warn_if_overloaded(const Case& c, const Section& s, double tension, const std::string& key,
                        const std::string& why, std::vector<InputWarning>& out) {
  const LineType& t = c.line_type(s.type);
  if (t.breaking_load > 0 && tension > t.breaking_load) {
    add_warning(out, key, Effect::all,
                "{} requires a tension of at least {:.4g} kN, and the breaking load of '{}' is {:.4g} kN",
                why, tension / 1000, t.name, t.breaking_load / 1000);
  } else if (const double strain = tension / t.EA; !t.tension_table && strain > allowed_strain(t)) {
    add_warning(out, key, Effect::all,
                "{} requires a tension of at least {:.4g} kN, which stretches '{}' (EA {:.4g} kN) by {:.3g} "
                "%; usual is less than {:g} %",
                why, tension / 1000, t.name, t.EA / 1000, 100 * strain, 100 * allowed_strain(t));
  }
}

void warn_of_span(const Case& c, const Line& line, std::vector<InputWarning>& out) {
  if (!is_held(line.end_a) || !is_held(line.end_b)) return;
  const double chord = (end_position(c, line.end_b) - end_position(c, line.end_a)).norm();
  double length = length_of(line);  // outside the feeders
  for (const End* e : {&line.end_a, &line.end_b})
    if (e->feed) length -= e->feed->stock;
  const double loose = length + expansion_of(c, line);
  double compliance = 0;
  for (const Section& s : line.sections) compliance += s.length / c.line_type(s.type).EA;
  const std::string key = "lines." + line.name + ".sections";
  const Section& weakest = *std::min_element(
      line.sections.begin(), line.sections.end(),
      [&](const Section& a, const Section& b) { return c.line_type(a.type).EA < c.line_type(b.type).EA; });
  // A body with mass yields to the line.
  const auto yields_to_line = [&](const End& e) {
    return e.kind == EndKind::body && c.floats(c.body_index(e.carrier));
  };
  if (chord > loose && !yields_to_line(line.end_a) && !yields_to_line(line.end_b))
    warn_if_overloaded(
        c, weakest, (chord - loose) / compliance, key,
        fmt::format("a length of {:.6g} m over a distance of {:.6g} m between its ends", loose, chord), out);
  int elements = 0;
  for (const Section& s : line.sections) elements += s.elements;
  if (line.starts_by_itself() && elements < kFew && chord > 0 && length > kSlack * chord)
    add_warning(out, key, Effect::resolution,
                "{} for a line that is {:.2g} % longer than the distance between its ends: its "
                "curved shape needs twenty elements or more",
                count_of(elements, "element"), 100 * (length / chord - 1));
  double room = chord;
  if (const Seabed& bed = c.environment.seabed; bed.present)
    for (const End* e : {&line.end_a, &line.end_b})
      room += std::max(height_above_bed(bed, end_position(c, *e)), 0.0);
  if (line.starts_by_itself() && chord > 0 && length > kLong * chord && length > kDeepLong * room)
    add_warning(out, key, Effect::all,
                "the line is {:.6g} m long, {:.3g} times the distance between its ends ({:.6g} m); is so "
                "much slack intended?",
                length, length / chord, chord);
}

// The higher end carries at least the weight between the heights of the ends; the end of a freely hanging
// line carries all that is not on the bed.
void warn_of_weight(const Case& c, const Line& line, std::vector<InputWarning>& out) {
  const bool a = is_held(line.end_a);
  const bool b = is_held(line.end_b);
  if ((!a && !b) || line.start == Start::points || line.start == Start::other_run) return;
  const Vec3 top = a && (!b || end_position(c, line.end_a).z() >= end_position(c, line.end_b).z())
                       ? end_position(c, line.end_a)
                       : end_position(c, line.end_b);
  double height = length_of(line);
  if (a && b)
    height = std::min(height, std::abs(end_position(c, line.end_a).z() - end_position(c, line.end_b).z()));
  if (const Seabed& bed = c.environment.seabed; bed.present)
    height = std::min(height, std::max(height_above_bed(bed, top), 0.0));
  const LineType* lightest = nullptr;  // any of the types may hang there
  for (const Section& s : line.sections)
    if (const LineType& t = c.line_type(s.type);
        !lightest || mass_in_water(c, t, -HUGE_VAL) < mass_in_water(c, *lightest, -HUGE_VAL))
      lightest = &t;
  const double weight = c.environment.gravity * mass_in_water(c, *lightest, -HUGE_VAL) * height;
  const Section& strongest = *std::max_element(
      line.sections.begin(), line.sections.end(),
      [&](const Section& x, const Section& y) { return c.line_type(x.type).EA < c.line_type(y.type).EA; });
  if (weight > 0)
    warn_if_overloaded(c, strongest, weight, "lines." + line.name,
                       fmt::format("its own weight over {:.4g} m of height", height), out);
}

void warn_of_loads(const Case& c, const Line& line, std::vector<InputWarning>& out) {
  for (const PointLoad& p : line.point_loads) {
    double end = 0;
    for (const Section& s : line.sections) {
      end += s.length;
      if (p.at > end && &s != &line.sections.back()) continue;
      // A beam carries transverse loads by bending.
      const bool pulled = (p.at <= 0 && !is_held(line.end_a)) || (p.at >= end && !is_held(line.end_b));
      if (c.line_type(s.type).kind == LineKind::cable && pulled)
        warn_if_overloaded(c, s, p.force.norm(), fmt::format("lines.{}.loads[{}]", line.name, p.order),
                           "its force", out);
      break;
    }
  }
}

}  // namespace

void warn_of_lines(const Case& c, std::vector<InputWarning>& out) {
  for (const Line& line : c.lines) {
    warn_of_span(c, line, out);
    warn_of_weight(c, line, out);
    warn_of_loads(c, line, out);
  }
}

}  // namespace hawser::advice
