// The tangent of a time step: its product with a direction against finite differences of the residual of a
// trial.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "hawser/solve/generalized_alpha.hpp"
#include "support/taylor.hpp"

namespace hawser::test {

class StepTangent {
 public:
  // A step h from the state `from`, for which the system is prepared, with increments u of its unknowns.
  StepTangent(System& system, AlphaState from, double h, std::vector<double> u)
      : system_(system),
        from_(std::move(from)),
        to_(from_),
        h_(h),
        u_(std::move(u)),
        J_(system.create_matrix()) {
    linearise();
  }

  // A step from the shape of the simulation with random velocities and increments. The increments have the
  // size `place` [m] and `angle` [rad].
  static StepTangent by_chance(System& system, State& shape, double h, double place, double angle) {
    system.update_couplings(shape.at_start(h), h);
    system.update_ghosts(shape);
    const LocalMesh& mesh = system.mesh();
    AlphaState from;
    from.s = shape;
    for (size_t i = 0; i < from.s.x.size(); ++i) {
      const int g = mesh.global[i];
      from.s.v[i] = 0.4 * noise3(g, 1);
      if (mesh.rotates(static_cast<int>(i))) from.s.w[i] = 0.5 * noise3(g, 2);
    }
    system.tied_nodes().rates(0, from.s);
    system.tied_nodes().move_with_frames(from.s);
    alpha_start(mesh, from);
    system.prepare(from.s.after_step(h), h);
    std::vector<double> u(3 * static_cast<size_t>(mesh.blocks()), 0);
    for (int n = 0; n < mesh.nodes(); ++n)
      for (int k = 0; k <= mesh.rotates(n); ++k)
        for (int i = 0; i < 3; ++i)
          u[static_cast<size_t>(3 * (mesh.block[static_cast<size_t>(n)] + k) + i)] =
              (k ? angle : place) * noise(mesh.global[static_cast<size_t>(n)], 3 * k + i, 5);
    system.tied_nodes().increments(from.s, h, u.data());
    return {system, std::move(from), h, std::move(u)};
  }

  // The trial itself, evaluated; and accepted by the terms.
  const State& trial() {
    residual_at(0, std::vector<double>(u_.size(), 0));
    return to_.s;
  }
  void commit() { system_.commit(trial().after_step(h_)); }
  void prepare() {
    system_.prepare(from_.s.after_step(h_), h_);
    linearise();  // the preceding commit may have changed the step
  }

  // Largest difference of J d and fourth-order differences of the residual, over the largest component of J
  // d, on all ranks. The differences use the increments ±e d and ±2 e d.
  double error(const std::vector<double>& d, double e) {
    const auto Jd = multiply(system_, J_.get(), d);
    const auto a = residual_at(e, d);
    const auto b = residual_at(-e, d);
    const auto p = residual_at(2 * e, d);
    const auto q = residual_at(-2 * e, d);
    double both[2] = {0, 0};
    for (size_t i = 0; i < Jd.size(); ++i) {
      both[0] = std::max(both[0], std::abs((8 * (a[i] - b[i]) - (p[i] - q[i])) / (12 * e) - Jd[i]));
      both[1] = std::max(both[1], std::abs(Jd[i]));
    }
    MPI_Allreduce(MPI_IN_PLACE, both, 2, MPI_DOUBLE, MPI_MAX, system_.comm());
    return both[0] / both[1];
  }
  // Largest error over several directions of this size.
  double worst(double length, double angle) {
    Trial t;
    t.length = length;
    t.angle = angle;
    double out = 0;
    for (int k = 0; k < 4; ++k) out = std::max(out, error(direction(system_, t, 100 + k), 0.08));
    return out;
  }

 private:
  inline static const AlphaCoefficients kAlpha{0.8};

  void linearise() {
    residual_at(0, std::vector<double>(u_.size(), 0));
    system_.tangent(to_.s.after_step(h_), alpha_weights(kAlpha, h_), u_, false, J_.get());
  }

  std::vector<double> residual_at(double step, const std::vector<double>& d) {
    std::vector<double> moved = u_;
    for (size_t i = 0; i < u_.size(); ++i) moved[i] += step * d[i];
    alpha_trial(system_.mesh(), system_.tied_nodes(), kAlpha, h_, from_, moved, to_);
    return residual(system_, to_.s, h_);
  }

  System& system_;
  AlphaState from_, to_;
  double h_;
  std::vector<double> u_;
  MatHandle J_;
};

}  // namespace hawser::test
