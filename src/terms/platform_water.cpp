// The class PlatformWater: forces and tangents of a group of platforms, memory, slow poses and energy.
#include "hawser/terms/platform_water.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/kernels/motion.hpp"
#include "hawser/math/heading.hpp"
#include "hawser/terms/force_round_off.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {

void PlatformWater::list_couplings(Couplings& to) const {
  for (const Group& g : groups_)
    for (const Platform& a : g.platforms)
      for (const Platform& b : g.platforms)
        if (a.node < b.node) to.add({a.node, a.node}, {b.node, b.node});
}

void PlatformWater::renumber() {
  for (Group& g : groups_) {
    g.is_complete = true;
    for (Platform& p : g.platforms) {
      p.local = mesh_.find(p.node);
      p.block = p.local < 0 ? -1 : mesh_.block[p.local];
      p.owned = mesh_.owns(p.local);
      g.is_complete &= p.local >= 0;
    }
  }
}

Eigen::VectorXd PlatformWater::rates(const Group& g, const Kinematics& state) const {
  Eigen::VectorXd out(6 * g.platforms.size());
  for (size_t i = 0; i < g.platforms.size(); ++i) {
    const Platform& p = g.platforms[i];
    out.segment<6>(6 * i) = platform_rate_by_heading(p.axes, p.arm, floating_state(state, p.local));
  }
  return out;
}

void PlatformWater::add_past(Group& g, double time, Eigen::VectorXd rate) {
  if (g.past.empty()) {
    g.accelerations.assign(2 * g.radiation->entries.size(), 0);
  } else {
    const Eigen::VectorXd a = (rate - g.past.back().rate) / (time - g.past.back().time);
    for (const auto& [i, j] : g.radiation->entries) g.accelerations.push_back(a[j]);
    for (const auto& [i, j] : g.radiation->entries) g.accelerations.push_back(i != j ? a[i] : 0);
  }
  g.past.push_back({time, std::move(rate)});
}

namespace {

// A lag that differs from a multiple of the step by less than this [s] takes the row of that multiple. The
// error of S is then no larger than that of the interpolation in RadiationMemory.
double lag_tolerance(const RadiationMemory& memory) { return 1e-8 * memory.spacing(); }

}  // namespace

void PlatformWater::tabulate_lags(Group& g) {
  if (g.past.size() < 2 || g.radiation->entries.empty()) return g.lags.clear();
  const double end = g.past.back().time;
  const double last = end - g.past[g.past.size() - 2].time;
  if (std::abs(last - g.lag_step) > lag_tolerance(g.radiation->memory)) {
    g.lags.clear();
    g.lag_step = last;
  }
  size_t rows = 2;  // of the trial, and of the last accepted state
  for (size_t k = g.past.size() - 1; k-- > 0; ++rows) {
    const double lag = static_cast<double>(rows - 1) * g.lag_step;
    if (std::abs(end - g.past[k].time - lag) > lag_tolerance(g.radiation->memory)) break;
  }
  const size_t n = g.radiation->entries.size();
  // The history and lag_step alone determine the number of rows, so that it is the same after a restart.
  g.lags.resize(std::min(g.lags.size(), rows * n));
  for (size_t m = g.lags.size() / n; m < rows; ++m) {
    g.lags.resize((m + 1) * n);
    g.radiation->memory.integrals(static_cast<double>(m) * g.lag_step, &g.lags[m * n], nullptr);
  }
}

const double* PlatformWater::integrals_at(const Group& g, double lag, double* buffer, double* dS) {
  const size_t n = g.radiation->entries.size();
  const double m = std::round(lag / g.lag_step);
  const size_t tabulated = g.lags.size() / n;
  if (!dS && m < static_cast<double>(tabulated) &&
      std::abs(lag - m * g.lag_step) <= lag_tolerance(g.radiation->memory))
    return &g.lags[static_cast<size_t>(m) * n];
  g.radiation->memory.integrals(lag, buffer, dS);
  return buffer;
}

const PlatformWater::KnownForces& PlatformWater::known_forces(const Group& g, double time) const {
  KnownForces& now = g.cache;
  if (g.is_cached && now.time == time) return now;
  const Eigen::Index n = 6 * static_cast<Eigen::Index>(g.platforms.size());
  now.time = time;
  now.memory_force = Eigen::VectorXd::Zero(n);
  now.first_order = now.second_order = Eigen::VectorXd::Zero(n);
  now.memory_damping = Eigen::MatrixXd::Zero(n, n);
  g.is_cached = true;
  if (!g.past.empty() && !g.radiation->entries.empty()) memory_forces(g, now);
  wave_forces(g, now);
  return now;
}

// F(t) = v_0 S'(t - t_0) + sum_k a_k [S(t - t_k) - S(t - t_k+1)]
//      = v_0 S'(t - t_0) + sum_k (a_k - a_k-1) S(t - t_k),   a_-1 = a_n = 0,
// with S the second integral of the retardation function, v_0 the first velocity of the bodies, a_k their
// mean acceleration from t_k to t_k+1, up to t_n. The trial step adds S(t - t_n) (v - v_n)/(t - t_n). Each
// entry of S acts on its row, and by symmetry on its column.
void PlatformWater::memory_forces(const Group& g, KnownForces& now) {
  const auto entries = static_cast<Eigen::Index>(g.radiation->entries.size());
  Eigen::ArrayXd buffer(entries);
  Eigen::ArrayXd dS(entries);  // S'(t - t_0)
  const std::vector<double> no_acceleration(2 * g.radiation->entries.size(), 0);
  Eigen::ArrayX2d force = Eigen::ArrayX2d::Zero(entries, 2);
  using Accelerations = Eigen::Map<const Eigen::ArrayX2d>;
  const double* integrals_of_step = buffer.data();  // S(t - t_n), by entry
  for (size_t k = 0; k < g.past.size(); ++k) {
    const bool is_last = k + 1 == g.past.size();
    const Accelerations before(k > 0 ? &g.accelerations[k * no_acceleration.size()] : no_acceleration.data(),
                               entries, 2);
    const Accelerations after(
        is_last ? no_acceleration.data() : &g.accelerations[(k + 1) * no_acceleration.size()], entries, 2);
    const double* S = integrals_at(g, now.time - g.past[k].time, buffer.data(), k > 0 ? nullptr : dS.data());
    force += (after - before).colwise() * Eigen::Map<const Eigen::ArrayXd>(S, entries);
    if (is_last) integrals_of_step = S;
  }
  const double step = now.time - g.past.back().time;
  const Eigen::VectorXd& first = g.past.front().rate;
  for (Eigen::Index e = 0; e < entries; ++e) {
    const auto [i, j] = g.radiation->entries[static_cast<size_t>(e)];
    now.memory_force[i] += force(e, 0) + dS[e] * first[j];
    if (i != j) now.memory_force[j] += force(e, 1) + dS[e] * first[i];
    if (step > 0) now.memory_damping(i, j) = now.memory_damping(j, i) = integrals_of_step[e] / step;
  }
}

void PlatformWater::wave_forces(const Group& g, KnownForces& now) const {
  const double ramp = sea_.wave_ramp > 0 ? quintic_ramp(now.time, sea_.wave_ramp).value : 1;
  for (size_t i = 0; i < g.platforms.size(); ++i) {
    const Platform& p = g.platforms[i];
    if (p.waves.none()) continue;
    const Vec3 origin = wave_origin(g, p, now.time);
    const PlatformWaves::Forces f = p.waves.at(now.time, origin.x(), origin.y());
    const auto first = 6 * static_cast<Eigen::Index>(i);
    now.first_order.segment<6>(first) = ramp * f.first;
    // Slow drift is quadratic in the height of waves. The mean drift acts in statics already and has no ramp.
    now.second_order.segment<6>(first) = ramp * ramp * f.slow + p.waves.mean_drift();
  }
}

Vec3 PlatformWater::wave_origin(const Group& g, const Platform& p, double time) {
  const Vec3 place =
      p.follow_period > 0 ? Vec3(p.slow.place + (time - g.slow_time) * p.slow.drift) : p.potential.place;
  return place + p.axes * p.file_origin;
}

void PlatformWater::damping_and_memory(const Group& g, const KnownForces& now, const Eigen::VectorXd& rate,
                                       Eigen::VectorXd& force, Eigen::MatrixXd* slope) const {
  force = now.memory_force;
  if (!g.past.empty()) force += now.memory_damping * (rate - g.past.back().rate);
  if (slope) *slope = now.memory_damping;
  for (size_t i = 0; i < g.platforms.size(); ++i) {
    const Platform& p = g.platforms[i];
    const auto first = 6 * static_cast<Eigen::Index>(i);
    const Vec6 body_rate = rate.segment<6>(first);
    const Vec6 abs_rate = body_rate.cwiseAbs();
    force.segment<6>(first) +=
        p.added_damping * body_rate + p.added_quadratic_damping * abs_rate.cwiseProduct(body_rate);
    if (!slope) continue;
    slope->block<6, 6>(first, first) +=
        p.added_damping + p.added_quadratic_damping * (2 * abs_rate).asDiagonal();
  }
}

void PlatformWater::turn(Platform& p) {
  const double heading = p.slow.place.z();
  p.axes = heading_axes(heading);
  if (!p.waves.none()) p.waves.turn_to(heading);
}

void PlatformWater::rest_at(Platform& p, const RigidBodyState& s) {
  if (!(p.follow_period > 0)) return;
  p.slow = WavePose::at(place_and_heading(p.arm, s));
  turn(p);
}

// Without a previous step, the memory begins with the present velocity.
void PlatformWater::prepare(const Kinematics& from, double) {
  for (Group& g : groups_) {
    g.is_cached = false;
    if (!g.is_complete) continue;
    if (!from.ends_step())
      for (Platform& p : g.platforms) p.last_iterate = floating_state(from, p.local);
    if (from.phase == Phase::start && g.past.size() <= 1) begin_memory(g, from);
    tabulate_lags(g);
  }
}

void PlatformWater::begin_memory(Group& g, const Kinematics& start) const {
  for (Platform& p : g.platforms) rest_at(p, floating_state(start, p.local));
  g.slow_time = start.time;
  const Eigen::VectorXd rate = rates(g, start);
  g.past.clear();
  add_past(g, start.time, rate);
  const std::vector<Power> power = powers(g, start.time, rate);
  for (size_t i = 0; i < power.size(); ++i) g.platforms[i].power = power[i];
}

// Residual of each body: f_i = G_i^T F_i and hydrostatics, with the forces on all bodies of the group
//   F = (A_inf + A_h) a + D(r) + memory - waves,
// r, a: rates and accelerations of the bodies in axes H and J; A_h of period_mass(), D of added
// and harmonic damping. With D_r = dF/dr the tangent by position, velocity and acceleration of body j is
//   K_ij = G_i^T ((A_inf + A_h)_ij da_j/dq + D_r,ij dr_j/dq) + [i = j] d(G_i^T)/dq F_i,
//   C_ij = G_i^T ((A_inf + A_h)_ij da_j/dq' + D_r,ij G_j),  M_ij = G_i^T (A_inf + A_h)_ij G_j.
// Harmonic damping is in the tangent only (DependsOnFrequency), for modes and responses.
void PlatformWater::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Group& g : groups_) {
    if (!g.is_complete) continue;
    const size_t n = g.platforms.size();
    std::vector<PlatformMotion> motion(n);
    Eigen::VectorXd rate(6 * n);
    Eigen::VectorXd acceleration(6 * n);
    Eigen::VectorXd F = Eigen::VectorXd::Zero(6 * static_cast<int>(n));
    Eigen::MatrixXd by_rate = Eigen::MatrixXd::Zero(F.size(), F.size());
    for (size_t i = 0; i < n; ++i) {
      const Platform& p = g.platforms[i];
      motion[i] = platform_motion_by_heading(p.axes, p.arm, floating_state(trial, p.local));
      rate.segment<6>(6 * i) = motion[i].rate;
      acceleration.segment<6>(6 * i) = motion[i].acceleration;
    }
    const Eigen::MatrixXd mass = g.added_mass + period_mass(g, trial.step);
    if (trial.moves()) {
      const KnownForces& now = known_forces(g, trial.time);
      damping_and_memory(g, now, rate, F, assembler.needs_tangent() ? &by_rate : nullptr);
      F -= now.first_order + now.second_order;
    } else {
      for (size_t i = 0; i < n; ++i)
        if (const Platform& p = g.platforms[i]; !(p.follow_period > 0))
          F.segment<6>(6 * i) -= p.waves.mean_drift();
      if (g.harmonic_damping.size() > 0) by_rate = g.harmonic_damping;
    }
    F += mass * acceleration;
    for (size_t i = 0; i < n; ++i) {
      const Platform& p = g.platforms[i];
      const int blocks[2] = {p.block, p.block + 1};
      const RigidBodyState s = floating_state(trial, p.local);
      const PotentialGradient hydrostatic = hydrostatic_gradient(p.hydrostatics, p.arm, s);
      const PotentialGradient added = platform_gradient(p.potential, p.arm, s);
      const Vec6 force = F.segment<6>(6 * static_cast<Eigen::Index>(i));
      const Vec6 f = motion[i].G.transpose() * force;
      const Mat6 slope = platform_force_slope(motion[i], p.arm, force);
      assembler.add(blocks, f, slope);
      assembler.add(blocks, hydrostatic.f, hydrostatic.K);
      assembler.add(blocks, added.f, added.K);
      if (!trial.moves() && p.follow_period > 0 && !p.waves.none()) {
        const PlatformWaves::MeanDrift mean = p.waves.mean_drift(heading_of(s.q).angle);
        const PlatformLoad drift = turning_load({mean.force, mean.by_heading}, p.arm, s);
        assembler.add(blocks, drift.f, drift.K);
      }
      if (!assembler.needs_tangent()) continue;
      for (size_t j = 0; j < n; ++j) {
        const Mat6 A = motion[i].G.transpose() * mass.block<6, 6>(6 * i, 6 * j);
        const Mat6 D = motion[i].G.transpose() * by_rate.block<6, 6>(6 * i, 6 * j);
        const Mat6 K = A * motion[j].acceleration_by_place + D * motion[j].rate_by_place;
        const Mat6 C = A * motion[j].acceleration_by_rate + D * motion[j].G;
        const Mat6 M = A * motion[j].G;
        const int other[2] = {g.platforms[j].block, g.platforms[j].block + 1};
        assembler.add(blocks, other, {}, K, C, M);
      }
    }
  }
}

void PlatformWater::commit(const Kinematics& accepted) {
  for (Group& g : groups_) {
    if (!g.is_complete) continue;
    if (!accepted.moves()) {
      g.past.clear();
      for (Platform& p : g.platforms) rest_at(p, floating_state(accepted, p.local));
      g.slow_time = accepted.time;
      continue;
    }
    Eigen::VectorXd rate = rates(g, accepted);
    const std::vector<Power> end = powers(g, accepted.time, rate);
    for (size_t i = 0; i < end.size(); ++i) {
      Platform& p = g.platforms[i];
      p.damping_work += 0.5 * accepted.step * (p.power.damping + end[i].damping);
      p.wave_work += 0.5 * accepted.step * (p.power.waves + end[i].waves);
      p.power = end[i];
    }
    add_past(g, accepted.time, std::move(rate));
    // Velocities older than the memory have no effect; they are deleted in blocks.
    constexpr size_t kOver = 100;
    const double oldest = accepted.time - g.radiation->memory.length();
    if (g.past.size() > kOver + 1 && g.past[kOver].time < oldest) {
      g.past.erase(g.past.begin(), g.past.begin() + kOver);
      g.accelerations.erase(
          g.accelerations.begin(),
          g.accelerations.begin() + static_cast<int>(2 * kOver * g.radiation->entries.size()));
    }
    for (Platform& p : g.platforms) {
      if (!(p.follow_period > 0)) continue;
      const Vec3 pose = place_and_heading(p.arm, floating_state(accepted, p.local));
      p.slow = p.slow.after(pose, accepted.time - g.slow_time, p.follow_period);
      turn(p);
    }
    g.slow_time = accepted.time;
    g.is_cached = false;
  }
}

std::vector<PlatformWater::Power> PlatformWater::powers(const Group& g, double time,
                                                        const Eigen::VectorXd& rate) const {
  Eigen::VectorXd force;
  const KnownForces& now = known_forces(g, time);
  damping_and_memory(g, now, rate, force, nullptr);
  std::vector<Power> out;
  for (size_t i = 0; i < g.platforms.size(); ++i) {
    const auto first = 6 * static_cast<Eigen::Index>(i);
    const Vec6 body_rate = rate.segment<6>(first);
    out.push_back({force.segment<6>(first).dot(body_rate),
                   (now.first_order + now.second_order).segment<6>(first).dot(body_rate)});
  }
  return out;
}

Energy PlatformWater::energy(const Kinematics& state) const {
  Energy e;
  for (const Group& g : groups_) {
    if (!g.is_complete) continue;
    const Eigen::VectorXd rate = rates(g, state);
    const Eigen::VectorXd momentum = (g.added_mass + period_mass(g, state.last_step())) * rate;
    for (size_t i = 0; i < g.platforms.size(); ++i) {
      const Platform& p = g.platforms[i];
      if (!p.owned) continue;
      const auto first = 6 * static_cast<Eigen::Index>(i);
      e.kinetic += 0.5 * rate.segment<6>(first).dot(momentum.segment<6>(first));
      const RigidBodyState s = floating_state(state, p.local);
      e.potential += hydrostatic_gradient(p.hydrostatics, p.arm, s).potential;
      e.potential += platform_gradient(p.potential, p.arm, s).potential;
      if (!state.moves()) e.potential -= mean_work(p, s);
      e.damping += p.damping_work;
      e.work += p.wave_work;
      e.by_water += p.wave_work;
    }
  }
  return e;
}

double PlatformWater::dead_load() const {
  double sum = 0;
  for (const Group& g : groups_)
    for (const Platform& p : g.platforms)
      if (p.owned) sum += p.hydrostatics.buoyancy;
  return sum;
}

double PlatformWater::round_off(const Kinematics& state, double h) const {
  double sum = 0;
  for (const Group& g : groups_)
    for (size_t i = 0; i < g.platforms.size(); ++i) {
      const Platform& p = g.platforms[i];
      if (!p.owned) continue;
      const auto first = 6 * static_cast<Eigen::Index>(i);
      Vec6 stiff = p.potential.stiffness.diagonal();
      stiff.segment<3>(2) += p.hydrostatics.stiffness.diagonal();
      const double stiffness = stiff.head<3>().maxCoeff();
      const double turning = stiff.tail<3>().maxCoeff();
      sum += spring_round_off(stiffness, state.x[p.local].norm()) + spring_round_off(turning, 1);
      if (!(h > 0)) continue;
      const double mass = g.added_mass.block<3, 3>(first, first).diagonal().maxCoeff();
      const double inertia = g.added_mass.block<3, 3>(first + 3, first + 3).diagonal().maxCoeff();
      sum += inertia_round_off(mass, state.v[p.local].norm(), h);
      sum += inertia_round_off(inertia, state.w[p.local].norm(), h);
    }
  return sum;
}

}  // namespace hawser
