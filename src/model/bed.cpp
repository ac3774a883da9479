// Height and normal of a plane or measured seabed, and the rules by which a start shape counts as laid on it
// or a line as held by friction; for start shapes, checks and statics.
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

// Between points a line spans the hollows of a bed that is not even.
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
  return laid_with_friction(c, line) || (c.statics.contact_friction && !line.starts_by_itself());
}

}  // namespace hawser::model
