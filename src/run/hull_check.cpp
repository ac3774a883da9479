// Checks of hulls by their volumes, and hydrostatics for `hawser check`.
#include "hawser/run/hull_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "hawser/advice/hulls.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/kernels/hull_pressure.hpp"
#include "hawser/math/angle_between.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/waterplane.hpp"
#include "hawser/terms/hulls.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser::run {
namespace {

// Largest relative difference between the volume integrals along three axes that small gaps of a mesh cause.
constexpr double kGaps = 1e-3;

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

// Volumes of other bodies may be in the seabed on purpose, such as piles and mattresses. Without a seabed the
// depth of the water counts.
void note_below_seabed(model::Case& c, const model::Volume& volume, const LoadedVolume& loaded) {
  constexpr double kDeep = 0.1;  // m
  const model::Seabed& bed = c.environment.seabed;
  const model::Water& water = c.environment.water;
  const int body = volume.body.empty() ? -1 : c.body_index(volume.body);
  const bool has_depth = water.present && water.depth > 0;
  if (!(bed.present || has_depth) || body < 0 || !c.bodies[body].mass || !loaded.facets) return;
  const model::Body& b = c.bodies[body];
  const Quat turn = exp_so3(b.rotation);
  double lowest = HUGE_VAL;
  for (const Vec3& y : loaded.facets->vertices) {
    const Vec3 x = b.position + turn * y;
    lowest =
        std::min(lowest, bed.present ? model::height_above_bed(bed, x) : x.z() - water.surface + water.depth);
  }
  if (!(lowest < -kDeep)) return;
  c.notes.push_back(bed.present ? advice::below_seabed(volume.name, b.name, -lowest)
                                : advice::below_water(volume.name, b.name, -lowest, water.depth));
}

std::string held_by(const model::Case& c, const model::Body& b) {
  if (!line_ends_at(c, b).empty()) return "lines";
  return b.mass->spring_stiffness().z() > 0 ? "springs" : "";
}

template <class Case, class Visit>
void for_each_hull(Case& c, const std::vector<LoadedVolume>& volumes, const Visit& visit) {
  const VolumeFacets facets = volume_facets(volumes);
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (auto& body = c.bodies[b]; body.mass && body.mass->hull)
      visit(body, hull_surface(c, static_cast<int>(b), facets, HUGE_VAL));
}

bool is_platform(const model::Body& b) { return b.mass && (b.mass->hull || b.mass->hydrodynamics); }

// Attitude and height of a platform at rest. Angles in rad.
struct PlatformAtRest {
  int body = 0;
  double turned = 0;   // from its initial attitude, about any horizontal axis
  double upright = 0;  // of its vertical axis from the vertical
  double rise = 0;     // m, from its initial position
};

// Rise [m] of a platform from its initial position. A heel alone raises neither the centre of the waterplane
// of a floating body nor the centre of mass of a submerged one. The centre of the waterplane is assumed on
// the vertical through the centre of mass or through the body's origin; the smallest rise of the three
// counts.
double rise_of(const model::Body& b, const RigidBodyState& start, const RigidBodyState& at, double surface) {
  double rise = at.x.z() - start.x.z();
  const Mat3 turn = (at.q * start.q.conjugate()).toRotationMatrix();
  for (Vec3 point : {start.x, b.position}) {
    point.z() = surface;
    const double of_surface = at.x.z() + (turn * (point - start.x)).z() - surface;
    if (std::abs(of_surface) < std::abs(rise)) rise = of_surface;
  }
  return rise;
}

PlatformAtRest platform_at_rest(const model::Case& c, int body, const RigidBodyState& at) {
  const model::Body& b = c.bodies[body];
  const RigidBodyState start = start_of(b);
  // Upward vertical in body axes.
  const Vec3 up = at.q.conjugate() * Vec3::UnitZ();
  const Vec3 up_at_start = start.q.conjugate() * Vec3::UnitZ();
  return {body, angle_between(up, up_at_start), angle_between(up, Vec3::UnitZ()),
          rise_of(b, start, at, c.environment.water.surface)};
}

// Platforms of all ranks, once each, by body. Collective.
std::vector<PlatformAtRest> platforms_at_rest(MPI_Comm comm, const model::Case& c, const Bodies& bodies,
                                              const Kinematics& state) {
  std::vector<PlatformAtRest> local;
  for (int b = 0; b < static_cast<int>(c.bodies.size()); ++b)
    if (const int node = bodies.local_node(b); node >= 0 && is_platform(c.bodies[b]))
      local.push_back(platform_at_rest(c, b, floating_state(state, node)));
  std::map<int, PlatformAtRest> once;  // a body may be on several ranks
  for (const PlatformAtRest& p : gather_all(comm, local)) once.emplace(p.body, p);
  std::vector<PlatformAtRest> out;
  for (const auto& [b, platform] : once) out.push_back(platform);
  return out;
}

// Rise [m] of the body to the position where buoyancy balances its weight, at constant rotation: bisection
// between dry and submerged, since buoyancy decreases with height.
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
  for (size_t i = 0; i < volumes.size(); ++i) note_below_seabed(c, c.volumes[i], volumes[i]);
  const double density = c.environment.water.density;
  for_each_hull(c, volumes, [&](model::Body& b, const HullSurface& hull) {
    const std::string key = "bodies." + b.name + ".floating.hull.volumes";
    const RigidBodyState s = start_of(b);
    const Vec3 displaced = displaced_volumes(hull, top_of(hull, s), s);
    const double volume = displaced.mean();
    if (!(volume > 0) || displaced.maxCoeff() - displaced.minCoeff() > kGaps * volume)
      c.refuse(key, "{}", advice::hull_is_open(displaced));
    if (held_by(c, b).empty() && b.mass->mass > density * volume)
      c.refuse(key, "{}", advice::hull_cannot_float(density * volume, b.mass->mass));
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
    const double weight = b.mass->mass * g;
    advice::HullAtStart start{.body = b.name, .triangles = hull.triangles.size(), .weight = weight};
    start.buoyancy = -p.f[2];
    start.displaced = start.buoyancy / (density * g);
    start.volume = displaced_volumes(hull, top_of(hull, s), s).mean();
    start.waterplane = p.K(2, 2) / (density * g);
    const Eigen::Vector2d heights = model::metacentric_heights(p.K.block<3, 3>(2, 2), start.buoyancy);
    start.roll_height = heights[0];
    start.pitch_height = heights[1];
    start.rise = rise_to_float(hull, s, weight, density * g, level);
    start.held_by = held_by(c, b);
    out += advice::hull_at_start(start);
  });
  return out;
}

std::vector<std::string> platforms_off_start(MPI_Comm comm, const model::Case& c, const Bodies& bodies,
                                             const Kinematics& equilibrium) {
  std::vector<std::string> out;
  for (const PlatformAtRest& p : platforms_at_rest(comm, c, bodies, equilibrium))
    if (std::string text = advice::equilibrium_differs(c.bodies[p.body].name, p.rise); !text.empty())
      out.push_back(std::move(text));
  return out;
}

std::vector<std::string> platforms_tilted(MPI_Comm comm, const model::Case& c, const Bodies& bodies,
                                          const Kinematics& equilibrium) {
  constexpr double kSmall = 10 * M_PI / 180;
  std::vector<std::string> out;
  for (const PlatformAtRest& p : platforms_at_rest(comm, c, bodies, equilibrium)) {
    const model::Body& body = c.bodies[p.body];
    if (p.turned > M_PI / 2)
      out.push_back(advice::turned_over(body.name, p.turned));
    else if (body.mass->hydrodynamics && !body.mass->hull && p.upright > kSmall)
      out.push_back(advice::tilted(body.name, p.upright));
  }
  return out;
}

std::vector<std::string> platforms_held(const model::Case& c, const System& system,
                                        const Kinematics& equilibrium) {
  std::vector<std::string> out;
  const RigidBodies* floating = system.find<RigidBodies>();
  for (size_t b = 0; floating && b < c.bodies.size(); ++b) {
    const model::Body& body = c.bodies[b];
    if (!is_platform(body)) continue;
    double up = floating->force_on(static_cast<int>(b), equilibrium)[0].z();
    for (const ReportsBodyForces* term : system.with<ReportsBodyForces>())
      for (const BodyForce& f : term->forces_on(static_cast<int>(b), equilibrium)) up -= f.force.z();
    constexpr double kRounding = 1e-6;  // of the weight
    if (std::abs(up) > kRounding * body.mass->mass * c.environment.gravity)
      out.push_back(advice::held_at_rest(body.name, up));
  }
  return out;
}

}  // namespace hawser::run
