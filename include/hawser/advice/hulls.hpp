// Messages about hulls that displace water by their volumes: refusals, and the hydrostatics that `hawser
// check` prints.
#pragma once

#include <array>
#include <string>

#include "hawser/model/platform_periods.hpp"

namespace hawser::advice {

// A surface whose volume [m³] depends on the axis of integration.
std::string hull_is_open(const Vec3& volumes);
// A body heavier than its largest buoyancy: water displaced by the submerged hull, and mass of the body, kg.
std::string hull_cannot_float(double displaced, double mass);

// State of a hull at its position in the case.
struct HullAtStart {
  std::string body;
  size_t triangles = 0;
  double displaced = 0, volume = 0;          // m³, wetted part; whole hull
  double buoyancy = 0, weight = 0;           // N
  double waterplane = 0;                     // m²
  double roll_height = 0, pitch_height = 0;  // m, metacentric; meaningless without buoyancy
  double rise = 0;                           // m, to the position where buoyancy alone balances weight
  std::string held_by = {};                  // "lines" or "springs"; empty: not held
};
// Several lines, with a warning if the body would float elsewhere and nothing holds it (a note if something
// does) or if a metacentric height is negative.
std::string hull_at_start(const HullAtStart& hull);

// For a body that statics raises by `rise` [m] at the water surface: weight, buoyancy and line forces are not
// balanced at the position in the case. Empty up to 0.1 m.
std::string equilibrium_differs(const std::string& body, double rise);

// For a body that statics turns over, by `tilt` [rad] from its initial attitude.
std::string turned_over(const std::string& body, double tilt);
// For a body with linear coefficients that rests `tilt` [rad] from upright.
std::string tilted(const std::string& body, double tilt);

// Vertical force on a body at rest [N, upwards] other than its weight and the water: lines and contact.
std::string held_at_rest(const std::string& body, double up);
// Natural periods of a body held by lines.
std::string periods_on_lines(const std::string& body, const std::array<model::PlatformMode, 6>& modes);
// Printed instead of the periods if the stiffness of the lines is not known, with the reason.
std::string no_periods_on_lines(const std::string& body, const std::string& reason);
// For a volume of a floating body whose lowest point is `depth` [m] below the seabed, which does not hold it.
std::string below_seabed(const std::string& volume, const std::string& body, double depth);
// The same by the depth of the water, in a case without a seabed. below: m.
std::string below_water(const std::string& volume, const std::string& body, double below, double water_depth);

}  // namespace hawser::advice
