// Checks of hulls by their volumes, and their hydrostatics in words.
#include "hawser/run/hull_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/kernels/hull_pressure.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/terms/hulls.hpp"

namespace hawser::run {
namespace {

// Of the volume: the largest difference between its three fluxes that small gaps of a mesh make.
constexpr double kGaps = 1e-3;
constexpr double kOffWater = 0.1;  // m

RigidBodyState start_of(const model::Body& b) {
  RigidBodyState s;
  s.q = exp_so3(b.rotation);
  s.x = b.position + s.q * b.mass->centre;
  return s;
}

double top_of(const HullSurface& hull, const RigidBodyState& s) {
  double top = -HUGE_VAL;
  for (const Vec3& y : hull.corners) top = std::max(top, (s.x + s.q * y).z());
  return top;
}

template <class Case, class Visit>
void for_each_hull(Case& c, const std::vector<LoadedVolume>& volumes, const Visit& visit) {
  const VolumeFacets facets = volume_facets(volumes);
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (auto& body = c.bodies[b]; body.mass && body.mass->hull)
      visit(body, hull_surface(c, static_cast<int>(b), facets, HUGE_VAL));
}

// m, by which the body rises to where its buoyancy carries its weight alone, at the same rotation. Buoyancy
// falls as it rises: by bisection between dry and wholly wet.
double rise_to_float(const HullSurface& hull, const RigidBodyState& at, double weight, double weight_density,
                     double level) {
  const double height = top_of(hull, at) - level;
  double depth = 0;
  for (const Vec3& y : hull.corners) depth = std::max(depth, level - (at.x + at.q * y).z());
  double low = -std::max(height, 0.0) - 1;
  double high = depth + 1;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    RigidBodyState s = at;
    s.x.z() += middle;
    const double buoyancy = -hull_pressure(hull, weight_density, level, {}, s, false).f[2];
    (buoyancy > weight ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

void set_hydrostatics(model::Case& c, const std::vector<LoadedVolume>& volumes) {
  const double density = c.environment.water.density;
  for_each_hull(c, volumes, [&](model::Body& b, const HullSurface& hull) {
    const std::string key = "bodies." + b.name + ".floating.hull.volumes";
    const RigidBodyState s = start_of(b);
    const Vec3 whole = displaced_volumes(hull, top_of(hull, s), s);
    const double volume = whole.mean();
    if (!(volume > 0) || whole.maxCoeff() - whole.minCoeff() > kGaps * volume)
      c.refuse(
          key,
          "the surface is not closed: its volume is {:.5g}, {:.5g} or {:.5g} m³ when it is integrated along "
          "x, y or z; close its deck and bottom in the mesh",
          whole.x(), whole.y(), whole.z());
    const bool carried =
        b.mass->stiffness.z() > 0 || !line_ends_at(c, b).empty() || b.mass->mass <= density * volume;
    if (!carried)
      c.refuse(
          key,
          "it cannot float: the hull displaces {:.5g} kg of water when it is wholly under water, and its "
          "mass is {:.5g} kg",
          density * volume, b.mass->mass);
    const Mat6 K =
        hull_pressure(hull, density * c.environment.gravity, c.environment.water.surface, {}, s, true).K;
    b.mass->hull->restoring = K.diagonal().segment<3>(2);
  });
}

std::string hulls_text(const model::Case& c, const std::vector<LoadedVolume>& volumes) {
  std::string out;
  const double g = c.environment.gravity;
  const double density = c.environment.water.density;
  const double level = c.environment.water.surface;
  for_each_hull(c, volumes, [&](const model::Body& b, const HullSurface& hull) {
    const RigidBodyState s = start_of(b);
    const HullPressure p = hull_pressure(hull, density * g, level, {}, s, true);
    const double buoyancy = -p.f[2];
    const double weight = b.mass->mass * g;
    out += fmt::format("hull of {}: {} triangles, displaces {:.6g} m³ where it starts, {:.6g} m³ in all\n",
                       b.name, hull.triangles.size(), buoyancy / (density * g),
                       displaced_volumes(hull, top_of(hull, s), s).mean());
    out += fmt::format("  buoyancy {:.5g} kN, weight {:.5g} kN, waterplane {:.5g} m²\n", buoyancy / 1000,
                       weight / 1000, p.K(2, 2) / (density * g));
    if (buoyancy > 0)
      out += fmt::format("  metacentric heights {:.4g} m (roll), {:.4g} m (pitch)\n", p.K(3, 3) / buoyancy,
                         p.K(4, 4) / buoyancy);
    const double rise = rise_to_float(hull, s, weight, density * g, level);
    if (std::abs(rise) > kOffWater && p.K(2, 2) > 0)
      out += fmt::format(
          "  warning: without lines it would float {:.3g} m {}; lines that pull {:.5g} kN {} keep it where "
          "it "
          "starts\n",
          std::abs(rise), rise > 0 ? "higher" : "lower", std::abs(buoyancy - weight) / 1000,
          rise > 0 ? "down" : "up");
  });
  return out;
}

}  // namespace hawser::run
