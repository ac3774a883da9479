// Checks of contact settings against each other and against the lines.
#include <fmt/format.h>

#include <algorithm>

#include "hawser/math/ordered.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::model {
namespace {

// Smallest contact diameter [m] of the participating lines that satisfy which(line); 0: no such line.
template <class Which>
double thinnest(const Case& c, const Which& which) {
  double smallest = 0;
  for (const Line& l : c.lines)
    if (c.contact.takes_part(l) && which(l))
      for (const Section& s : l.sections)
        if (const double d = c.line_type(s.type).contact_diameter; d > 0)
          smallest = smallest > 0 ? std::min(smallest, d) : d;
  return smallest;
}

void check_smoothing(std::optional<double> smoothing, double thickness, const std::string& key,
                     const Issues& issue) {
  if (thickness > 0 && smoothing && *smoothing > thickness)
    issue(
        key,
        "a ramp of {:g} m is wider than the thinnest line; at most its contact diameter of {:g} m is allowed",
        *smoothing, thickness);
}

void check_kinetic(const Volume& v, const Issues& issue) {
  const Friction& f = v.friction;
  if (!(f.blend_speed > 0)) return;
  const auto below = [&](const char* which, double kinetic_friction, double static_friction) {
    if (kinetic_friction > static_friction)
      issue("volumes." + v.name + ".friction.kinetic",
            "{} friction of {:g} in motion is above that at rest; at most {:g} is allowed", which,
            kinetic_friction, static_friction);
  };
  below("axial", f.axial_kinetic, f.axial);
  if (!(f.axial_kinetic > f.axial)) below("lateral", f.lateral_kinetic, f.lateral);
}

// If no line takes part in contact, friction of a volume has an effect only if a volume of another body
// that it can touch has friction, too.
void check_friction_of_bodies(const Case& c, const Issues& issue) {
  if (std::any_of(c.lines.begin(), c.lines.end(), [&](const Line& l) { return c.contact.takes_part(l); }))
    return;
  const std::vector<BodyPair> pairs = body_pairs(c);
  for (size_t i = 0; i < c.volumes.size(); ++i) {
    const Volume& v = c.volumes[i];
    const auto is_in = [i](const BodyPair& p) { return p.a == i || p.b == i; };
    const auto pair = std::find_if(pairs.begin(), pairs.end(), is_in);
    if (!(std::min(v.friction.axial, v.friction.lateral) > 0) || pair == pairs.end() ||
        std::any_of(pair, pairs.end(), [&](const BodyPair& p) { return is_in(p) && p.friction.axial > 0; }))
      continue;
    return issue(
        "volumes." + v.name + ".friction",
        "has no effect: between bodies the lower coefficient counts, and {} has none; give it friction, "
        "too",
        quote(c.volumes[pair->a == i ? pair->b : pair->a].name));
  }
}

// Lines of equal length between the same places, each started as a catenary, would coincide, and their
// relative position is undefined.
void check_separation(const Case& c, const Issues& issue) {
  struct Span {
    const Line* line;
    Vec3 a, b;
    double length;
  };
  std::vector<Span> spans;
  for (const Line& l : c.lines)
    if (c.contact.takes_part(l) && l.end_a.kind != EndKind::free && l.end_b.kind != EndKind::free &&
        l.starts_by_itself() && contact_diameter_of(c, l) > 0) {
      Vec3 a = end_position(c, l.end_a);
      Vec3 b = end_position(c, l.end_b);
      if (b.x() < a.x()) std::swap(a, b);
      spans.push_back({&l, a, b, length_of(l)});
    }
  std::stable_sort(spans.begin(), spans.end(),
                   [](const Span& p, const Span& q) { return p.a.x() < q.a.x(); });
  constexpr double kSame = 1e-6;
  for (std::size_t i = 0; i < spans.size(); ++i)
    for (std::size_t j = i + 1; j < spans.size(); ++j) {
      const Span& p = spans[i];
      const Span& q = spans[j];
      const double near = kSame * p.length;
      if (q.a.x() - p.a.x() > near) break;
      const auto& [one, other] = ordered(p.line->name, q.line->name);
      const auto same = [&](const auto& e) { return ordered(e.first, e.second) == std::pair(one, other); };
      const auto& exclude = c.contact.between_lines.exclude;
      if ((p.a - q.a).norm() <= near && (p.b - q.b).norm() <= near && std::abs(p.length - q.length) <= near &&
          std::none_of(exclude.begin(), exclude.end(), same))
        issue("lines." + q.line->name,
              "it has the same ends and length as line {}, so they would start in the same place; move an "
              "end, or exclude their contact by 'contact: {{between_lines: {{exclude: [[{}, {}]]}}}}'",
              quote(p.line->name), one, other);
    }
}

// No line is above itself, and no two lines are above each other.
void check_order(const BetweenLines& b, const Issues& issue) {
  for (std::size_t i = 0; i < b.crossings.size(); ++i) {
    const auto& [upper, lower] = b.crossings[i];
    const std::string key = fmt::format("contact.between_lines.over[{}]", i);
    if (upper == lower)
      issue(key, "names line {} twice; give the upper line and the lower one", quote(upper));
    const auto reversed = std::pair(lower, upper);
    if (upper != lower && std::find(b.crossings.begin(), b.crossings.begin() + static_cast<std::ptrdiff_t>(i),
                                    reversed) != b.crossings.begin() + static_cast<std::ptrdiff_t>(i))
      issue(key, "line {} is to lie over line {} and under it; give one of the two", quote(upper),
            quote(lower));
  }
}

}  // namespace

void check_contact(const Case& c, const Issues& issue) {
  const double thickness = thinnest(c, [](const Line&) { return true; });
  for (const Volume& v : c.volumes) {
    if (c.contact.takes_part(v))
      check_smoothing(v.smoothing, thickness, "volumes." + v.name + ".smoothing", issue);
    check_kinetic(v, issue);
  }
  check_friction_of_bodies(c, issue);
  const BetweenLines& b = c.contact.between_lines;
  if (!b.enabled) return;
  check_separation(c, issue);
  check_order(b, issue);
  check_smoothing(b.general.smoothing, thickness, "contact.between_lines.smoothing", issue);
  for (std::size_t i = 0; i < b.pairs.size(); ++i) {
    const BetweenLines::Tuned& p = b.pairs[i];
    const std::string key = fmt::format("contact.between_lines.pairs[{}]", i);
    for (const std::string& name : {p.first, p.second}) {
      const int line = c.line_index(name);
      if (line < 0 || c.contact.takes_part(c.lines[line])) continue;
      issue(key + ".lines", "{} takes no part in contact; 'contact.lines' has {}", quote(name),
            fmt::join(c.contact.lines, ", "));
      break;
    }
    const auto same = [&](const auto& e) { return ordered(e.first, e.second) == ordered(p.first, p.second); };
    if (std::any_of(b.exclude.begin(), b.exclude.end(), same))
      issue(key + ".lines",
            "lines {} and {} are in 'exclude', so these settings have no effect; remove one of the two",
            quote(p.first), quote(p.second));
    if (p.settings.smoothing != b.general.smoothing)
      check_smoothing(p.settings.smoothing,
                      thinnest(c, [&](const Line& l) { return l.name == p.first || l.name == p.second; }),
                      key + ".smoothing", issue);
  }
}

}  // namespace hawser::model
