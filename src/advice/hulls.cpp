// Messages about hulls that displace water by their volumes.
#include "hawser/advice/hulls.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "hawser/math/freedoms.hpp"

namespace hawser::advice {
namespace {

constexpr double kOffWater = 0.1;  // m

const char* higher(double rise) { return rise > 0 ? "higher" : "lower"; }

std::string flotation_differs(const HullAtStart& h) {
  if (!(std::abs(h.rise) > kOffWater) || !(h.waterplane > 0)) return {};
  if (h.held_by.empty())
    return fmt::format(
        "  warning: body {} floats {:.3g} m {} than its initial position: there its weight and buoyancy "
        "differ by {:.5g} kN, and no line or spring carries the difference\n",
        h.body, std::abs(h.rise), higher(h.rise), std::abs(h.buoyancy - h.weight) / 1000);
  return fmt::format("  note: without its {} body {} would float {:.3g} m {}: they must carry {:.5g} kN {}\n",
                     h.held_by, h.body, std::abs(h.rise), higher(h.rise),
                     std::abs(h.buoyancy - h.weight) / 1000, h.rise > 0 ? "down" : "up");
}

std::string capsizes(const HullAtStart& h) {
  const bool roll = h.roll_height < 0;
  if (!roll && !(h.pitch_height < 0)) return {};
  return fmt::format("  warning: body {} {}: its metacentric height in {} is negative\n", h.body,
                     h.held_by.empty() ? "capsizes" : "would capsize without its " + h.held_by,
                     !roll                ? "pitch"
                     : h.pitch_height < 0 ? "roll and pitch"
                                          : "roll");
}

}  // namespace

std::string hull_is_open(const Vec3& volumes) {
  return fmt::format(
      "the surface is not closed: its volume is {:.5g}, {:.5g} or {:.5g} m³ when it is integrated along x, y "
      "or z; close the mesh at its deck and bottom",
      volumes.x(), volumes.y(), volumes.z());
}

std::string hull_cannot_float(double displaced, double mass) {
  return fmt::format(
      "it cannot float: the fully submerged hull displaces {:.5g} kg of water, and the mass of the body is "
      "{:.5g} kg",
      displaced, mass);
}

std::string hull_at_start(const HullAtStart& h) {
  std::string out = fmt::format(
      "hull of {}: {} triangles, displaces {:.6g} m³ in its initial position, {:.6g} m³ fully submerged\n",
      h.body, h.triangles, h.displaced, h.volume);
  out += fmt::format("  buoyancy {:.5g} kN, weight {:.5g} kN, waterplane {:.5g} m²\n", h.buoyancy / 1000,
                     h.weight / 1000, h.waterplane);
  if (h.buoyancy > 0) {
    out += fmt::format("  metacentric heights {:.4g} m (roll), {:.4g} m (pitch)\n", h.roll_height,
                       h.pitch_height);
    out += capsizes(h);
  }
  return out + flotation_differs(h);
}

std::string equilibrium_differs(const std::string& body, double rise) {
  if (!(std::abs(rise) > kOffWater)) return {};
  return fmt::format(
      "body {} comes to rest {:.3g} m {} than its initial position: there its weight, its buoyancy and the "
      "forces of its lines are not in balance",
      body, std::abs(rise), higher(rise));
}

std::string turned_over(const std::string& body, double tilt) {
  return fmt::format(
      "body {} comes to rest turned over, {:.0f} deg from its initial attitude: it is unstable there, or "
      "statics passed a heel at which it is stable; `hawser check` prints its metacentric heights; lower "
      "its centre of mass, or start it near its heel by `rotation_deg`",
      body, tilt * 180 / M_PI);
}

std::string tilted(const std::string& body, double tilt) {
  return fmt::format(
      "body {} comes to rest {:.3g} deg from upright, and the hydrostatics and wave forces of its files are "
      "linear, for angles up to about 10 deg: check its loads and their units, its lines and its centre of "
      "mass",
      body, tilt * 180 / M_PI);
}

std::string held_at_rest(const std::string& body, double up) {
  return fmt::format("body {} at rest: its lines and what touches it pull it {:.5g} kN {}", body,
                     std::abs(up) / 1000, up < 0 ? "down" : "up");
}

std::string periods_on_lines(const std::string& body, const std::array<model::PlatformMode, 6>& modes) {
  std::vector<std::string> parts;
  for (const model::PlatformMode& mode : modes)
    parts.push_back(fmt::format("{} {}", kFreedomNames[static_cast<size_t>(mode.freedom)],
                                mode.period > 0 ? fmt::format("{:.4g} s", mode.period) : "none"));
  return fmt::format("body {} on its lines, without their mass: periods {}", body, fmt::join(parts, ", "));
}

std::string no_periods_on_lines(const std::string& body, const std::string& reason) {
  return fmt::format("body {} on its lines: periods not known: {}", body, reason);
}

std::string below_seabed(const std::string& volume, const std::string& body, double depth) {
  return fmt::format(
      "volumes.{}: reaches {:.4g} m below the seabed where body '{}' starts, and the seabed does not hold "
      "bodies: raise the body, or check the depth and the origin and the unit of the mesh",
      volume, depth, body);
}

std::string below_water(const std::string& volume, const std::string& body, double below,
                        double water_depth) {
  return fmt::format(
      "volumes.{}: reaches {:.4g} m below the bottom of the water, whose depth is {:.4g} m, where body '{}' "
      "starts: raise the body, or check 'environment.water.depth' and the origin and the unit of the mesh",
      volume, below, water_depth, body);
}

}  // namespace hawser::advice
