// Settings outside the range of platform coefficients, impossible inertia, and wind without an exposed body.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/math/angle_gap.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/math/heading.hpp"
#include "hawser/math/symmetric.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/positioning.hpp"
#include "hawser/model/waterplane.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::advice {

using namespace model;

namespace {

void warn_of_inertia(const Body& b, std::vector<InputWarning>& out) {
  if (b.mass->matrix) return;
  const Vec3 moments = eigenpairs(b.mass->tensor()).values;
  const double sum = moments[0] + moments[1];
  if (moments[2] > (1 + 1e-9) * sum)
    add_warning(out, "bodies." + b.name + ".floating.inertia", Effect::all,
                "the largest principal moment, {:.6g} kg m², is {:.2g} % above the sum of the other two, "
                "which is impossible for a rigid body: are the radii of gyration those of the ship?",
                moments[2], 100 * (moments[2] / sum - 1));
}

void warn_of_sea_of_platform(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const std::string key = "bodies." + b.name + ".floating.hydrodynamics";
  const auto flows = [](const CurrentRow& row) { return row.speed != 0; };
  if (!b.mass->current && std::any_of(w.current.profile.begin(), w.current.profile.end(), flows))
    add_warning(out, key, Effect::all,
                "the current acts on lines but not on this body, which has wave coefficients only: add its "
                "current coefficients, 'floating.current'");
  if (w.waves.stokes() && b.mass->hydrodynamics->waves_act())
    add_warning(out, key, Effect::all,
                "its coefficients are those of linear waves: the wave of 'stokes' acts on it as a linear "
                "one of the same height and period");
  if (w.waves.none() && !b.mass->hydrodynamics->drift_damping.empty())
    add_warning(
        out, key + ".wave_drift_damping", Effect::part,
        "has no effect, since it is multiplied by the squared amplitudes of the waves and the case has none: "
        "'damping' acts in still water, too");
}

// Forces of all difference frequencies are those of the mean direction of the waves.
void warn_of_crossing_waves(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kMost = 0.1;  // of the energy
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  if (h.second_order != SecondOrder::full) return;
  const double far = mean_direction(wave_field(c.environment).components()).far;
  if (far <= kMost) return;
  add_warning(out, "bodies." + b.name + ".floating.hydrodynamics.second_order", Effect::all,
              "{:.3g} % of the sea's energy goes to directions more than {:g} deg from the mean, and 'full' "
              "takes the forces of the mean direction for all waves: compare with 'newman', which uses all "
              "directions",
              100 * far, kFarFromMean * 180 / M_PI);
}

void warn_of_directions(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kWide = 60;  // deg
  const auto& h = *b.mass->hydrodynamics;
  if (!(h.follow_period > 0) || !h.wave_forces() || c.environment.water.waves.none()) return;
  const std::vector<double>& directions = h.wave_forces()->directions();
  const double gap = directions.size() < 2 ? 0 : widest_gap(directions, 2 * M_PI).width() * 180 / M_PI;
  if (gap <= kWide) return;
  add_warning(out, "bodies." + b.name + ".floating.hydrodynamics.follow_period", Effect::all,
              "the wave forces turn with the slow heading of the body, but the files have no direction "
              "within {:.0f} deg: give files with all directions if the body yaws towards that gap, or "
              "'follow_period: 0'",
              gap);
}

void warn_of_hull(const Body& b, std::vector<InputWarning>& out) {
  const BodyMass& m = *b.mass;
  if (m.hull && m.members.empty() && !m.hydrodynamics)
    add_warning(out, "bodies." + b.name + ".floating.hull", Effect::all,
                "only the water pressure acts on this body, without drag and added mass: add 'members', or "
                "the 'hydrodynamics' of a diffraction program");
}

// Members alone have no buoyancy.
void warn_of_missing_buoyancy(const Body& b, std::vector<InputWarning>& out) {
  const BodyMass& m = *b.mass;
  if (m.members.empty() || !m.weight || m.hull || m.in_water || m.hydrodynamics ||
      m.spring_stiffness().z() > 0)
    return;
  add_warning(
      out, "bodies." + b.name + ".floating.members", Effect::all,
      "have drag and added mass, but no buoyancy, and the pressure of waves does not act on them: add "
      "'hull' with the volumes of the body");
}

// Members much larger than the body, and added mass that is counted twice, by the files and by members.
void warn_of_members(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kLarge = 5;   // of the volume of water of the body's mass
  constexpr double kReach = 10;  // in sides of a cube of that volume; the tower of a wind turbine is at 6
  const BodyMass& m = *b.mass;
  for (size_t i = 0; i < m.members.size(); ++i) {
    const BodyMember& member = m.members[i];
    const double volume = 0.25 * M_PI * member.diameter * member.diameter * (member.to - member.from).norm();
    const double displaced = m.mass / std::max(c.environment.water.density, 1e-300);
    if (volume > kLarge * displaced)
      add_warning(out, fmt::format("bodies.{}.floating.members[{}]", b.name, i), Effect::all,
                  "has a volume of {:.3g} m³, and the body's mass is that of {:.3g} m³ of water: are "
                  "its ends and its diameter in metres?",
                  volume, displaced);
    const double reach = std::max((member.from - m.centre).norm(), (member.to - m.centre).norm());
    const double size = std::cbrt(std::max(volume, displaced));
    if (reach > kReach * size)
      add_warning(out, fmt::format("bodies.{}.floating.members[{}]", b.name, i), Effect::all,
                  "reaches {:.4g} m from the centre of mass, and a cube of the body's volume has sides of "
                  "{:.3g} m: are its ends in metres, and in the body's frame?",
                  reach, size);
    if (!m.hydrodynamics) continue;
    if (member.added > 0 || member.axial_added > 0)
      add_warning(
          out, fmt::format("bodies.{}.floating.members[{}]", b.name, i), Effect::all,
          "has added mass beside that of 'hydrodynamics', so that it counts twice unless the files are "
          "without this member: give it neither 'Ca' nor 'axial_Ca'");
  }
}

// A negative additional stiffness makes the body unstable in the horizontal plane, which has no hydrostatic
// stiffness. In heave, roll and pitch it may reduce the hydrostatic stiffness (free surfaces of tanks).
void warn_of_stiffness(const Body& b, const char* key, const Mat6& C, std::vector<InputWarning>& out) {
  constexpr double kRounded = 1e-6;
  const double size = std::cbrt(b.mass->mass);
  Mat3 plane;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double scale = (i == 2 ? size : 1) * (j == 2 ? size : 1);
      plane(i, j) = C(kHorizontalFreedoms[i], kHorizontalFreedoms[j]) / scale;
    }
  if (eigenpairs(plane).values[0] < -kRounded * plane.cwiseAbs().maxCoeff())
    add_warning(out, fmt::format("bodies.{}.floating.{}", b.name, key), Effect::all,
                "pushes the body away from its position in surge, sway or yaw: a restoring stiffness has "
                "positive diagonal entries");
}

// Bodies that float elsewhere by more than their size, or not upright.
void warn_of_floating(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const BodyMass& m = *b.mass;
  const double g = c.environment.gravity;
  const double density = c.environment.water.density;
  const double weight = m.mass * g;
  if (m.hull || !(g > 0)) return;
  const PlatformHydrostatics in_still_water = hydrostatics(m, density, g);
  const double size = std::cbrt(in_still_water.buoyancy / (density * g));
  const double rise = (in_still_water.buoyancy - weight) / std::max(in_still_water.stiffness(0, 0), 1e-300);
  if (in_still_water.stiffness(0, 0) > 0 && std::abs(rise) > size)
    add_warning(out, "bodies." + b.name + ".floating.mass", Effect::all,
                "its weight of {:.5g} kN and its buoyancy of {:.5g} kN mean that without lines it "
                "floats {:.3g} m {}, which is more than its size ({:.3g} m, the side of a cube of "
                "its volume): is 'mass' or 'displaced_volume' that of another body, or in other "
                "units?",
                weight / 1000, in_still_water.buoyancy / 1000, std::abs(rise), rise > 0 ? "higher" : "lower",
                size);
  const double level = hydrodynamic_place(b, c.environment.water.surface).z();
  const double above = b.position.z() - level;
  if (std::abs(above) > size)
    add_warning(out, "bodies." + b.name + ".position", Effect::all,
                "z is {:.4g} m, {:.4g} m {} the height of its files, {:.4g} m, which is more than its size "
                "({:.3g} m, the side of a cube of its volume): the origin of the body is at the water line "
                "unless 'origin_in_file' or 'place' state another height",
                b.position.z(), std::abs(above), above > 0 ? "above" : "below", level, size);
  const Eigen::Vector2d added =
      m.hydrodynamics->stiffness.diagonal().segment<2>(3) + m.spring_turning_stiffness().head<2>();
  const Eigen::Vector2d heights =
      metacentric_heights(restoring(m, in_still_water, g), weight) + added / weight;
  const bool roll = heights[0] < 0;
  const bool pitch = heights[1] < 0;
  const bool lines = !line_ends_at(c, b).empty();
  if (roll || pitch)
    add_warning(out, "bodies." + b.name + ".floating.centre_of_mass", Effect::all,
                "{} its metacentric height in {} is {:.3g} m; {}is the centre of mass in the body's "
                "frame, and has the stiffness of the files its weight ('gravity_in_stiffness')?",
                lines ? "without its lines" : "capsizes:",
                roll && pitch ? "roll and pitch"
                : roll        ? "roll"
                              : "pitch",
                heights.minCoeff(),
                lines ? "its lines must keep it upright, as tendons do; if that is not intended, " : "");
}

// Bodies that radiate on each other but lie elsewhere relative to each other than in their files.
void warn_of_arrangement(const Case& c, const std::vector<int>& group, std::vector<InputWarning>& out) {
  constexpr double kNear = 0.05;  // of their distance in the files; of an angle, rad
  const Body& first = c.bodies[static_cast<size_t>(group.front())];
  const auto place = [&](const Body& b) { return hydrodynamic_place(b, c.environment.water.surface); };
  for (const int other : group) {
    const Body& b = c.bodies[static_cast<size_t>(other)];
    const Vec3 in_files = b.mass->hydrodynamics->in_file - first.mass->hydrodynamics->in_file;
    if (in_files.head<2>().isZero()) continue;  // not given
    const double heading = hydrodynamic_heading(first);
    const Vec3 here = heading_rotation(-heading) * (place(b) - place(first));
    const double turned = std::remainder(hydrodynamic_heading(b) - heading, 2 * M_PI);
    const double moved = (here - in_files).head<2>().norm();
    if (moved > kNear * in_files.head<2>().norm() || std::abs(turned) > kNear)
      add_warning(
          out, "bodies." + b.name + ".floating.hydrodynamics", Effect::all,
          "lies at ({:.4g}, {:.4g}) m from body {} and heads {:.3g} deg to its left, and in the files "
          "at ({:.4g}, {:.4g}) m with the same heading: the forces of the waves that they radiate and "
          "diffract are those of the files",
          here.x(), here.y(), first.name, turned * 180 / M_PI, in_files.x(), in_files.y());
  }
}

// A damping matrix that is not positive semidefinite: it dissipates for single velocities but adds energy for
// some combinations.
void warn_of_damping(const Case& c, const Body& b, const char* key, const Mat6& B,
                     std::vector<InputWarning>& out) {
  constexpr double kRounded = 1e-6;
  const double size = std::cbrt(b.mass->mass / c.environment.water.density);
  Vec6 scale;
  scale << 1, 1, 1, 1 / size, 1 / size, 1 / size;
  const Mat6 scaled = 0.5 * scale.asDiagonal() * (B + B.transpose()) * scale.asDiagonal();
  if (eigenpairs(scaled).values[0] < -kRounded * scaled.cwiseAbs().maxCoeff())
    add_warning(out, fmt::format("bodies.{}.floating.{}", b.name, key), Effect::all,
                "adds energy to the motion for some combination of velocities: its off-diagonal entries are "
                "too large for the diagonal, or have the wrong sign");
}

// Line ends far from the body that holds them.
void warn_of_fairleads(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kFar = 5;  // in sides of a cube; the bow of a ship is at 3
  const BodyMass& m = *b.mass;
  if (!m.hydrodynamics && !m.hull) return;
  const bool given = m.hydrodynamics && m.hydrodynamics->volume > 0;
  const double size =
      std::cbrt(given ? m.hydrodynamics->volume : m.mass / std::max(c.environment.water.density, 1e-300));
  for (const EndAtBody& e : line_ends_at(c, b)) {
    const double off = (e.end.at - m.centre).norm();
    if (off > kFar * size)
      add_warning(out, "lines." + e.line.name + (&e.end == &e.line.end_a ? ".end_a.at" : ".end_b.at"),
                  Effect::all,
                  "is {:.4g} m from the centre of mass of body {}, of which the displaced volume "
                  "is that of a cube of {:.3g} m: is it in metres, and in the body's frame?",
                  off, b.name, size);
  }
}

// Wind and current coefficients that are too large to be dimensionless: those of ships and platforms are
// below 3.
void warn_of_flow(const Body& b, std::vector<InputWarning>& out) {
  constexpr double kLargest = 10;
  const auto warn = [&](const Shared<FlowOnBody>& flow, const char* name) {
    if (!flow || flow->coefficients.largest() <= kLargest) return;
    add_warning(
        out, fmt::format("bodies.{}.floating.{}", b.name, name), Effect::all,
        "has a coefficient of {:.3g}, and those of ships and platforms are below 3: are its rows forces "
        "and moments in place of F / (rho/2 v² A) and M / (rho/2 v² A L)?",
        flow->coefficients.largest());
  };
  warn(b.mass->wind, "wind");
  warn(b.mass->current, "current");
}

// A constant force on a platform that is negligible, or larger than its mooring and its buoyancy can hold.
// Thrust of turbines is 0.002 to 0.01 of the weight, and a buoy is pulled down by up to several times its
// weight.
void warn_of_loads(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kSmallest = 1e-5, kLargest = 10;  // of the weight
  const BodyMass& m = *b.mass;
  const double weight = m.mass * c.environment.gravity;
  if ((!m.hydrodynamics && !m.hull) || !(weight > 0)) return;
  for (size_t i = 0; i < m.loads.size(); ++i) {
    const double force = m.loads[i].force.norm();
    if (force == 0 || !m.loads[i].moment.isZero(0) || !m.loads[i].table.empty()) continue;
    if (force < kSmallest * weight || force > kLargest * weight)
      add_warning(out, fmt::format("bodies.{}.floating.loads[{}]", b.name, i), Effect::all,
                  "a force of {:.3g} N is {:.2g} times the weight of the body, {:.3g} N: is it in N?", force,
                  force / weight, weight);
  }
}

// Dynamic positioning with an unstable control loop.
void warn_of_positioning(const Body& b, std::vector<InputWarning>& out) {
  const Vec3 growth = model::loop_growth(b);
  const std::string key = "bodies." + b.name + ".floating.positioning";
  for (int k = 0; k < 3; ++k)
    if (growth[k] > 0)
      add_warning(
          out, key, Effect::all,
          "the control loop is unstable in {}: without other forces the motion grows by a factor of e in "
          "{:.3g} s; reduce 'proportional' or 'integral', increase 'derivative', or take a "
          "shorter 'filter_period'",
          kFreedomNames[kHorizontalFreedoms[k]], 1 / growth[k]);
}

}  // namespace

void warn_of_platforms(const Case& c, std::vector<InputWarning>& out) {
  const auto in_wind = [](const Body& b) { return b.mass && b.mass->wind; };
  if (c.environment.wind.speed > 0 && std::none_of(c.bodies.begin(), c.bodies.end(), in_wind))
    add_warning(out, "environment.wind", Effect::all,
                "acts on no body (and never on lines): add wind coefficients to a body, 'floating.wind'");
  for (const std::vector<int>& group : radiating_groups(c)) warn_of_arrangement(c, group, out);
  for (const Body& b : c.bodies) {
    if (!b.mass) continue;
    warn_of_hull(b, out);
    warn_of_missing_buoyancy(b, out);
    warn_of_members(c, b, out);
    warn_of_fairleads(c, b, out);
    warn_of_flow(b, out);
    warn_of_loads(c, b, out);
    if (b.mass->positioning) warn_of_positioning(b, out);
    warn_of_stiffness(b, "stiffness_matrix", b.mass->stiffness_matrix, out);
    warn_of_damping(c, b, "damping_matrix", b.mass->damping_matrix, out);
    if (!b.mass->hydrodynamics) continue;
    warn_of_inertia(b, out);
    warn_of_hydrodynamics(c, b, out);
    warn_of_floating(c, b, out);
    warn_of_damping(c, b, "hydrodynamics.damping", b.mass->hydrodynamics->damping, out);
    warn_of_stiffness(b, "hydrodynamics.stiffness", b.mass->hydrodynamics->stiffness, out);
    warn_of_sea_of_platform(c, b, out);
    warn_of_directions(c, b, out);
    warn_of_crossing_waves(c, b, out);
  }
}

}  // namespace hawser::advice
