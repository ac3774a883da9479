// Height and normal of a plane or measured seabed, and the rules for lines that are laid on it or held by
// friction; used by start shapes, checks and statics.
#include "hawser/model/bed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/geometry/surface.hpp"
#include "hawser/model/check.hpp"

namespace hawser::model {

Vec3 bed_normal(const Seabed& bed) {
  return {std::sin(bed.slope) * std::cos(bed.direction), std::sin(bed.slope) * std::sin(bed.direction),
          std::cos(bed.slope)};
}

double height_above_bed(const Seabed& bed, const Vec3& x) {
  if (!bed.surface) return bed_normal(bed).dot(x + Vec3(0, 0, bed.depth));
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const auto nearest = bed.surface->query(x, kNowhere);
  return nearest ? nearest->distance : kNowhere;
}

Vec3 below_on_bed(const Seabed& bed, const Vec3& x) {
  if (!bed.surface) return x - Vec3(0, 0, height_above_bed(bed, x) / bed_normal(bed).z());
  constexpr int kProjections = 5;
  Vec3 at = x;
  for (int i = 0; i < kProjections; ++i) {
    const auto nearest = bed.surface->query(at, std::numeric_limits<double>::infinity());
    if (!nearest) return x;
    if (!(nearest->normal.z() > 0)) return at;
    at.z() -= nearest->distance / nearest->normal.z();
  }
  return at;
}

double penetration_under(const Seabed& bed, double force, double diameter) {
  const double factor = bed.basis == StiffnessBasis::per_length ? 1 : diameter;
  if (!bed.force_table) return force / (factor * bed.normal_stiffness);
  constexpr double kDeep = 1e3;
  double low = 0, high = kDeep;
  for (int i = 0; i < 60; ++i) {
    const double d = 0.5 * (low + high);
    (factor * bed.force_table->at(d).force < force ? low : high) = d;
  }
  return high;
}

double submerged_weight(const Case& c, const LineType& type) {
  const Water& water = c.environment.water;
  const double area = M_PI / 4 * type.displaced() * type.displaced();
  return c.environment.gravity * (type.mass_per_length - (water.present ? water.density * area : 0));
}

double resting_height(const Case& c, const LineType& type) {
  const double weight = std::max(submerged_weight(c, type), 0.0);
  return 0.5 * type.contact_diameter - penetration_under(c.environment.seabed, weight, type.contact_diameter);
}

BedAtEnd bed_at_end(const Case& c, const Line& line, LineEnd line_end, double element) {
  // A line that descends to its end at angle a presses on the bed with T a; friction balances a tension
  // difference up to mu T a, 0.5 % of the tension T at this angle.
  constexpr double kSteepest = 0.005;
  BedAtEnd out;
  const Seabed& bed = c.environment.seabed;
  const End& end = line.end(line_end);
  if (!bed.present || end.kind != EndKind::anchor) return out;
  const double length = length_of(line);
  const double where = line_end == LineEnd::B ? length : 0;
  for (const Buried& s : line.buried)
    if (where >= s.from && where <= s.to) return out;
  const LineType& type = c.line_type(line.end_section(line_end).type);
  const double height = height_above_bed(bed, end_position(c, end));
  if (!std::isfinite(height)) return out;
  const double resting = resting_height(c, type);
  const double radius = 0.5 * type.contact_diameter;
  // With an end at the height of first contact the line would sink next to the end; above that height the
  // line hangs from its end.
  out.depth = height <= radius ? resting - height : std::min(0.0, resting - 2 * radius + height);
  // The difference vanishes within the line: from a joint on, the bed of the next line is unchanged.
  out.length = std::max(std::min(std::abs(out.depth) / kSteepest, length), element);
  return out;
}

bool static_bed_friction(const Case& c) {
  const Seabed& bed = c.environment.seabed;
  return bed.present && bed.as_laid && (bed.friction.axial > 0 || bed.friction.lateral > 0);
}

// A line spans hollows of an uneven bed between its points.
double laying_reach(const Case& c, const Line& line) {
  return std::max(contact_diameter_of(c, line), 1e-3 * length_of(line));
}

bool laid_with_friction(const Case& c, const Line& line) {
  const Seabed& bed = c.environment.seabed;
  if (!bed.present || !bed.as_laid || !(bed.friction.axial > 0) || !(bed.friction.lateral > 0)) return false;
  const double reach = laying_reach(c, line);
  return line.start == Start::points &&
         std::all_of(line.points.begin(), line.points.end(),
                     [&](const Vec3& x) { return height_above_bed(bed, x) < reach; });
}

bool held_by_friction(const Case& c, const Line& line) {
  return laid_with_friction(c, line) ||
         (c.statics.contact_friction.value_or(false) && !line.starts_by_itself());
}

}  // namespace hawser::model
