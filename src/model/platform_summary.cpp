// Summary of a platform for `hawser check`: weight and buoyancy, stability, added mass and periods.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/model/body_motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/platform.hpp"
#include "hawser/model/platform_memory.hpp"
#include "hawser/model/platform_periods.hpp"
#include "hawser/model/waterplane.hpp"

namespace hawser::model {
std::string platform_text(const Case& c, const Body& b) {
  const BodyMass& m = *b.mass;
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const HydrodynamicData& data = *h.data;
  const double g = c.environment.gravity;
  const double density = c.environment.water.density;
  const PlatformHydrostatics in_still_water = hydrostatics(m, density, g);
  const double weight = m.mass * g;
  const double heave = (in_still_water.buoyancy - weight) / in_still_water.stiffness(0, 0);
  std::string s =
      fmt::format("    displaced volume {:.6g} m³{}, buoyancy {:.5g} kN, weight {:.5g} kN\n",
                  in_still_water.buoyancy / (density * g), h.volume > 0 ? "" : " (that of its mass)",
                  in_still_water.buoyancy / 1000, weight / 1000);
  if (h.volume > 0 && in_still_water.stiffness(0, 0) > 0)
    s += fmt::format(
        "    without lines it would float {:.3g} m {}; lines that pull {:.5g} kN {} keep it in place\n",
        std::abs(heave), heave > 0 ? "higher" : "lower", std::abs(in_still_water.buoyancy - weight) / 1000,
        heave > 0 ? "down" : "up");
  const double above = b.position.z() - hydrodynamic_place(b, c.environment.water.surface).z();
  if (std::abs(above) >= 0.01)
    s += fmt::format("    starts {:.4g} m {} the height of its files\n", std::abs(above),
                     above > 0 ? "above" : "below");
  const Eigen::Vector2d heights = metacentric_heights(restoring(m, in_still_water, g), weight);
  s += fmt::format("    metacentric heights {:.4g} m (roll), {:.4g} m (pitch)\n", heights[0], heights[1]);
  const Eigen::Index first = h.first_row();
  std::string added;
  for (int k = 0; k < 6; ++k)
    added += fmt::format("{}{:.4g}", k > 0 ? ", " : "", data.infinite(first + k, first + k));
  s += fmt::format("    added mass at infinite frequency{}: {} (kg, kg m²)\n",
                   data.infinite_estimated ? ", estimated" : "", added);
  const PlatformPeriods periods = platform_periods(c, b);
  const auto text = [](double T) { return T > 0 ? fmt::format("{:.4g} s", T) : std::string("none"); };
  s += fmt::format("    periods afloat without lines: heave {}, roll {}, pitch {}\n", text(periods.heave),
                   text(periods.roll), text(periods.pitch));
  s += fmt::format("    coefficients of {} frequencies, {:.4g} to {:.4g} s{}\n", data.omega.size(),
                   2 * M_PI / data.omega.back(), 2 * M_PI / data.omega.front(),
                   data.excitation.empty() ? ", no wave forces"
                                           : fmt::format(", wave forces of {} directions",
                                                         data.excitation.front().directions().size()));
  for (const std::vector<int>& group : radiating_groups(c)) {
    if (std::find(group.begin(), group.end(), c.body_index(b.name)) == group.end()) continue;
    const PlatformMemory memory = platform_memory(c, group);
    s += fmt::format("    memory of the waves that it makes: {:.3g} s\n", memory.memory.length());
    const OgilvieCheck check = ogilvie_check(data, memory);
    if (check.omega > 0)
      s += fmt::format(
          "    added mass by the damping (Ogilvie's relation): within {:.2g} % of what that of the files "
          "varies "
          "by ({}, at {:.3g} s)\n",
          100 * check.difference, freedom_name(c, group, check.freedom), 2 * M_PI / check.omega);
  }
  return s;
}

}  // namespace hawser::model
