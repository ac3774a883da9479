// Plain Newton iteration with the exact tangent and load increments: tests elements, loads and assembly
// without the globalisation of the statics solver.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "hawser/solve/linear_solver.hpp"
#include "support/rig.hpp"

namespace hawser::test {

// Equilibrium near `state` at state.time; returns the number of iterations. Throws std::runtime_error if it
// fails. residuals: those of all iterates, relative to the size of their contributions.
inline int newton(System& system, State& state, double tolerance = 1e-12,
                  std::vector<double>* residuals = nullptr) {
  VecHandle u = system.create_vector();
  VecHandle r = system.create_vector();
  MatHandle J = system.create_matrix();
  KspHandle ksp;
  check(KSPCreate(system.comm(), ksp.out()));
  configure_linear_solver(ksp.get(), system, "verification_");
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  std::vector<double> local;
  State next = state;
  bool last = false;
  for (int it = 0; it < 40; ++it) {
    system.prepare(state.at_rest(), 0);
    system.residual(state.at_rest(), r.get());
    if (residuals) residuals->push_back(system.norms(r.get()).relative());
    if (last) return it;
    last = it > 0 && system.norms(r.get()).small(tolerance);  // one more iteration for accuracy
    system.tangent(state.at_rest(), {}, zero, false, J.get());
    check(KSPSetOperators(ksp.get(), J.get(), J.get()));
    check(KSPSolve(ksp.get(), r.get(), u.get()));
    check(VecScale(u.get(), -1));
    PetscReal size = 0;
    check(VecNorm(u.get(), NORM_INFINITY, &size));
    if (!std::isfinite(size)) break;
    system.gather_with_ghosts(u.get(), local);
    retract(system.mesh(), state, local.data(), next);
    std::swap(state, next);
  }
  throw std::runtime_error("Newton does not converge");
}

// Measure of quadratic convergence: the largest r2/r1² of successive relative residuals with r1 below 1e-2
// and r2 above round-off. Linear convergence, even by a factor of a hundred, makes it as large as 1e3.
// Infinite if there is no such pair.
inline double newton_square(const std::vector<double>& r, double round_off = 1e-10) {
  double most = 0;
  for (size_t i = 1; i < r.size(); ++i)
    if (r[i - 1] < 1e-2 && r[i] > round_off) most = std::max(most, r[i] / (r[i - 1] * r[i - 1]));
  return most > 0 ? most : HUGE_VAL;
}
inline void print_residuals(const std::vector<double>& r) {
  printf("    residuals");
  for (const double x : r) printf(" %.1e", x);
  printf(": squared within %.2f\n", newton_square(r));
}

// Raises loads by a ramp of 1 s from time 0 to 1 in `steps`, halved where Newton fails, and follows the
// equilibrium.
inline void follow(run::Simulation& s, int steps) {
  const double whole = 1.0 / steps;
  State reached = s.state();
  reached.time = 0;
  for (double step = whole; reached.time < 1;) {
    s.state() = reached;
    s.state().time = std::min(reached.time + step, 1.0);
    try {
      newton(s.system(), s.state());
      reached = s.state();
      step = std::min(2 * step, whole);
    } catch (const std::runtime_error&) {
      if ((step /= 2) < 1e-4 * whole) throw;
    }
  }
}

// Force or moment (node axes) of the support on a node by the last residual, rank 0.
inline Vec3 reaction(run::Simulation& s, int node, int which = 0) {
  const size_t b = 3 * static_cast<size_t>(s.local().block[static_cast<size_t>(node)] + which);
  return Eigen::Map<const Vec3>(s.system().reactions().data() + b);
}

// Observed order of convergence of errors on meshes with doubled numbers of elements.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

// A cantilever along x from the origin; the loads at its tip rise within 1 s. The case must outlive the
// simulation.
inline model::Case cantilever(const model::LineType& type, double length, int elements, const Vec3& force,
                              const Vec3& moment = Vec3::Zero()) {
  model::Case c = one_line(type, length, elements, clamp(Vec3::Zero(), Vec3::UnitX()), {});
  c.lines[0].start = model::Start::straight;
  c.lines[0].point_loads.push_back({length, force, moment, 1, 0});
  return c;
}

}  // namespace hawser::test
