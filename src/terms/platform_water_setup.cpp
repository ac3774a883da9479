// The class PlatformWater: construction. Groups of bodies by their files, stiffness and buoyancy of each.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/kernels/table_places.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/math/heading.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/mass_matrix.hpp"
#include "hawser/model/waterplane.hpp"
#include "hawser/terms/platform_water.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {

PlatformWater::PlatformWater(const model::Case& c, const LocalMesh& mesh)
    : mesh_(mesh), sea_(sea_of(c)), on_body_(c.bodies.size(), false) {
  // To the fourth order the scheme's acceleration of x = exp(i omega t) is -omega² (1 + c omega² h²) x with
  //   c = 1/6 + 3 delta²,   delta = (1 - rho)/(2 (1 + rho)).
  const double rho = c.dynamics.rho_infinity;
  const double delta = 0.5 * (1 - rho) / (1 + rho);
  period_error_ = 1.0 / 6 + 3 * delta * delta;
  const auto is_owned = [&](int body) { return mesh_.owns_node(mesh_.mesh->body_node(body)); };
  model::PlatformMemories memories;
  for (const std::vector<int>& bodies : model::radiating_groups(c)) {
    for (const int body : bodies) on_body_[static_cast<size_t>(body)] = true;
    if (std::any_of(bodies.begin(), bodies.end(), is_owned)) add_group(c, bodies, memories.of(c, bodies));
  }
  renumber();
}

namespace {

// The centre of the waterplane from the body's origin, m. If there is hardly a waterplane, its stiffness is
// noise, and the centre of buoyancy takes its place. weight_density: rho g, N/m³.
Eigen::Vector2d phase_point(const PlatformHydrostatics& h, double weight_density) {
  constexpr double kSmall = 1e-3;  // of the area of a cube with the displaced volume
  const double side = std::cbrt(h.buoyancy / weight_density);
  if (h.stiffness(0, 0) > kSmall * weight_density * side * side) return model::waterplane_centre(h.stiffness);
  return {h.arm_x, h.arm_y};
}

}  // namespace

PlatformWater::Platform PlatformWater::platform(const model::Case& c, int body) const {
  const model::Body& b = c.bodies[body];
  const model::BodyMass& m = *b.mass;
  const model::BodyHydrodynamics& h = *m.hydrodynamics;
  const double heading = model::hydrodynamic_heading(b);
  Platform p;
  p.node = mesh_.mesh->body_node(body);
  p.arm = -m.centre;
  p.file_origin = -h.in_file;
  p.body = body;
  p.potential.axes = p.axes = heading_axes(heading);
  p.follow_period = h.follow_period;
  p.slow = WavePose::at({b.position.x(), b.position.y(), heading});
  p.potential.place = model::hydrodynamic_place(b, sea_.surface);
  p.potential.stiffness = h.stiffness;
  // A hull has its own hydrostatics (terms/hulls.hpp).
  const PlatformHydrostatics of_files = model::hydrostatics(m, sea_.density, sea_.gravity);
  if (!m.hull) p.hydrostatics = of_files;
  p.hydrostatics.level = p.potential.place.z();
  p.added_damping = h.damping + model::wave_drift_damping(h, sea_.waves.components());
  p.added_quadratic_damping = h.quadratic_damping;
  p.coefficients = m.hydrodynamics;
  p.phase_point = h.in_file.head<2>() + phase_point(of_files, sea_.density * sea_.gravity);
  if (h.waves_act() && !sea_.waves.none()) p.waves = platform_waves(p, heading);
  return p;
}

namespace {

WaveForceTable of_body(const model::BodyHydrodynamics& h, const std::vector<WaveForceTable>& tables) {
  return tables.empty() ? WaveForceTable() : tables[static_cast<size_t>(h.body) - 1];
}

}  // namespace

// Wave forces are interpolated with their phases at the phase point: those at an origin far from it change
// too much from one frequency or direction to the next.
WaveForceTable PlatformWater::first_order_table(const Platform& p) const {
  const model::BodyHydrodynamics& h = *p.coefficients;
  if (!h.wave_forces()) return {};
  const WaveForceTable& first = *h.wave_forces();
  std::vector<double> numbers;
  for (const double omega : first.omega())
    numbers.push_back(wave_number(omega, sea_.waves.depth(), sea_.gravity));
  return first.with_phases_at(p.phase_point, numbers);
}

PlatformWaves PlatformWater::platform_waves(const Platform& p, double heading) const {
  const model::BodyHydrodynamics& h = *p.coefficients;
  const WaveForceTable first = first_order_table(p);
  const std::vector<WaveComponent>& sea = sea_.waves.components();
  if (h.second_order != SecondOrder::full)
    return {sea, heading, first, p.phase_point, of_body(h, h.data->drift), {}, h.second_order};
  const model::DifferenceForces& difference = model::difference_forces(h, sea, heading);
  return {sea, heading, first, p.phase_point, of_body(h, difference.drift), difference.pairs, h.second_order};
}

void PlatformWater::add_group(const model::Case& c, const std::vector<int>& bodies,
                              std::shared_ptr<const model::PlatformMemory> radiation) {
  Group g;
  g.radiation = std::move(radiation);
  for (const int body : bodies) g.platforms.push_back(platform(c, body));
  g.data = c.bodies[bodies.front()].mass->hydrodynamics->data;
  g.added_mass = g.data->infinite(g.radiation->rows, g.radiation->rows);
  find_modes(c, g);
  groups_.push_back(std::move(g));
}

// C v = omega² M v, with C from both potentials at rest, for displacements along H and rotations. Unstable
// modes have no period and get omega² = 0.
void PlatformWater::find_modes(const model::Case& c, Group& g) {
  Eigen::MatrixXd M = 0.5 * (g.added_mass + g.added_mass.transpose());
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(M.rows(), M.cols());
  for (size_t i = 0; i < g.platforms.size(); ++i) {
    const Platform& p = g.platforms[i];
    const model::BodyMass& m = *c.bodies[p.body].mass;
    if (m.hull) return;
    RigidBodyState start;
    start.q = Quat(p.axes);
    start.x = p.potential.place - start.q * p.arm;
    const Mat6 back = platform_motion_by_heading(p.axes, p.arm, start).G.inverse();
    const Mat6 K =
        hydrostatic_gradient(p.hydrostatics, p.arm, start).K + platform_gradient(p.potential, p.arm, start).K;
    const Mat6 by_rates = back.transpose() * K * back;
    M.block<6, 6>(6 * i, 6 * i) += model::mass_matrix_about(m, Vec3::Zero());
    C.block<6, 6>(6 * i, 6 * i) = 0.5 * (by_rates + by_rates.transpose());
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(C, M);
  if (eigen.info() != Eigen::Success) return;
  g.modes = M * eigen.eigenvectors();
  g.squares = eigen.eigenvalues().array().max(0);
}

// The scheme replaces -omega² x by -omega² (1 + c h² omega²) x in M a + C x = 0. With M - c h² C in place of
// M, the frequency is that of M and C to the fourth order. For a mode with v . M v = 1 this is 1 - c h²
// omega², here in the form 1/(1 + c h² omega²), which is a positive mass for any step length.
Eigen::MatrixXd PlatformWater::period_mass(const Group& g, double h) const {
  if (g.modes.size() == 0) return Eigen::MatrixXd::Zero(g.added_mass.rows(), g.added_mass.cols());
  const Eigen::ArrayXd error = period_error_ * h * h * g.squares;
  return -g.modes * (error / (1 + error)).matrix().asDiagonal() * g.modes.transpose();
}

void PlatformWater::set_frequency(std::optional<double> omega) {
  for (Group& g : groups_) {
    const model::HydrodynamicData& data = *g.data;
    if (!omega) {
      g.added_mass = data.infinite(g.radiation->rows, g.radiation->rows);
      g.harmonic_damping.resize(0, 0);
      continue;
    }
    const auto [low, high, fraction] = frequency_place(data.omega, *omega);
    const auto between = [&, low = low, high = high,
                          fraction = fraction](const std::vector<Eigen::MatrixXd>& matrices) {
      return Eigen::MatrixXd((1 - fraction) * matrices[low](g.radiation->rows, g.radiation->rows) +
                             fraction * matrices[high](g.radiation->rows, g.radiation->rows));
    };
    g.added_mass = between(data.added_mass);
    g.harmonic_damping = between(data.damping);
    if (*omega < data.omega.front()) g.harmonic_damping *= *omega / data.omega.front();
    if (*omega > data.omega.back()) g.harmonic_damping.setZero();
    for (size_t i = 0; i < g.platforms.size(); ++i)
      g.harmonic_damping.block<6, 6>(6 * i, 6 * i) += g.platforms[i].added_damping;
  }
}

std::vector<DependsOnFrequency::Excitation> PlatformWater::excitation(const std::vector<WaveComponent>& waves,
                                                                      const Kinematics& state) const {
  std::vector<Excitation> out;
  for (const Group& g : groups_)
    for (const Platform& p : g.platforms) {
      if (!p.owned) continue;
      const WaveForceTable first = first_order_table(p);
      if (first.none()) continue;
      const double heading = std::atan2(p.axes(1, 0), p.axes(0, 0));
      const PlatformWaves forces(waves, heading, first, p.phase_point, {}, {}, SecondOrder::none);
      const Vec3 origin = wave_origin(g, p, state.time);
      const Mat6 G = platform_motion_by_heading(p.axes, p.arm, floating_state(state, p.local)).G;
      Excitation e{p.block, forces.first_order(origin.x(), origin.y())};
      for (ComplexVec6& F : e.by_wave) F = G.transpose() * F;
      out.push_back(std::move(e));
    }
  return out;
}

}  // namespace hawser
