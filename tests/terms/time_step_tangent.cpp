// The tangent of a time step equals finite differences of the residual with respect to the increments of the
// step alone, including all quantities that the integrator derives from them (velocities, accelerations, the
// directors' accelerations).
#include "hawser/solve/generalized_alpha.hpp"
#include "support/taylor_cases.hpp"

namespace hawser::test::step_tangent_test {
namespace {

// A committed state that no step could produce: every quantity has an independent value.
AlphaState committed(const LocalMesh& mesh, const Trial& t) {
  AlphaState from;
  from.s = t.from;
  alpha_start(mesh, from);
  for (size_t i = 0; i < from.ax.size(); ++i) {
    const int g = mesh.global[i];
    from.s.a[i] = 3 * noise3(g, 31);
    from.ax[i] = 3 * noise3(g, 32);
    if (!mesh.rotates(static_cast<int>(i))) continue;
    from.s.alpha[i] = 3 * noise3(g, 33);
    from.aw[i] = 3 * noise3(g, 34);
    for (int c = 0; c < 3; ++c) {
      from.s.directors[i].col(c) = 2 * noise3(g, 35 + c);
      from.ad[i].col(c) = 2 * noise3(g, 38 + c);
    }
  }
  return from;
}

TEST(StepTangent, IsTheDerivativeByTheIncrements) {
  for (const double rho : {1.0, 0.8, 0.0})
    for (const bool turned : {false, true}) {
      const auto model = held_model(PETSC_COMM_SELF, {});
      SuiteModel& m = *model;
      add_structure(m, 0.1, 200, turned);
      add_mass(m, {}, turned);
      add_loads(m, {}, true);
      System& system = *m.system;
      const LocalMesh& mesh = system.mesh();
      const AlphaCoefficients alpha(rho);
      const double h = m.trial.h;
      const AlphaState from = committed(mesh, m.trial);
      system.prepare(from.s.after_step(h), h);
      AlphaState to = from;
      const auto at = [&](double step, const std::vector<double>& d) {
        std::vector<double> u = m.trial.u;
        for (size_t i = 0; i < u.size(); ++i) u[i] += step * d[i];
        alpha_trial(mesh, system.tied_nodes(), alpha, h, from, u, to);
        return residual(system, to.s, h);
      };
      // The test includes mean forces, whose weight in the scheme differs from 1.
      EXPECT_GT(alpha_mean(alpha).weight, 1);
      alpha_trial(mesh, system.tied_nodes(), alpha, h, from, m.trial.u, to);
      MatHandle J = system.create_matrix();
      system.tangent(to.s.after_step(h), alpha_weights(alpha, h), m.trial.u, false, J.get());
      for (int k = 0; k < 4; ++k) {
        const auto d = direction(system, m.trial, 100 + k);
        const auto Jd = multiply(system, J.get(), d);
        constexpr double e = 0.01;
        const auto a = at(e, d);
        const auto b = at(-e, d);
        const auto c = at(2 * e, d);
        const auto g = at(-2 * e, d);
        double off = 0, size = 0;
        for (size_t i = 0; i < Jd.size(); ++i) {
          off = std::max(off, std::abs((8 * (a[i] - b[i]) - (c[i] - g[i])) / (12 * e) - Jd[i]));
          size = std::max(size, std::abs(Jd[i]));
        }
        EXPECT_LT(off, 1e-8 * size) << "rho " << rho << ", turned " << turned;
        printf("  rho %.1f%s: error %.1e\n", rho, turned ? ", turned axes" : "", off / size);
      }
    }
}

// A telescoping sum: over any sequence of steps, the directors' rates equal those integrated from their
// accelerations by the formulas of velocities. The accelerations agree with those of w and alpha to second
// order in the step. (For rho < 1 the algorithmic accelerations belong to another time, off by a fraction of
// the step; after a start and where steps change they, like those of positions, are first-order accurate
// only.)
TEST(StepTangent, DirectorsFollowTheirAccelerations) {
  Mesh mesh = suite_mesh();
  const LocalMesh l = local_mesh(mesh, NodeRanks::all_of(mesh.nodes()), 0, 1);
  const TiedNodes none(l, {}, {});
  for (const double rho : {1.0, 0.8}) {
    const AlphaCoefficients c(rho);
    double before = 0;
    for (const int steps : {100, 200, 400}) {
      // Node 0 rotates by 3 sin t about one material axis and at steady rates about the others.
      AlphaState from;
      from.s.resize(l.nodes());
      const auto motion = [](double t, Vec3& w, Vec3& alpha) {
        w = Vec3(0.7, 3 * std::cos(t), 0.4);
        alpha = Vec3(0, -3 * std::sin(t), 0);
      };
      motion(0, from.s.w[0], from.s.alpha[0]);
      alpha_start(l, from);
      AlphaState to = from;
      double worst = 0, telescoped = 0, t = 0;
      for (int i = 0; i < steps; ++i) {
        const double h = 2.0 / steps * (rho == 1 && i % 3 == 0 ? 0.5 : 1);
        t += h;
        // Increments for which the velocity of the scheme equals that of the motion.
        std::vector<double> u(3 * static_cast<size_t>(l.blocks()), 0);
        Vec3 w, alpha;
        motion(t, w, alpha);
        const Vec3 A = ((w - from.s.w[0]) / h - (1 - c.gamma) * from.aw[0]) / c.gamma;
        Eigen::Map<Vec3>(u.data() + 3 * (l.block[0] + 1)) =
            h * from.s.w[0] + h * h * ((0.5 - c.beta) * from.aw[0] + c.beta * A);
        alpha_trial(l, none, c, h, from, u, to);
        const auto rate = [](const State& s) { return Mat3(s.q[0].toRotationMatrix() * hat(s.w[0])); };
        const Mat3 made = rate(from.s) + h * ((1 - c.gamma) * from.ad[0] + c.gamma * to.ad[0]);
        telescoped = std::max(telescoped, (made - rate(to.s)).norm());
        const Mat3 balance = (1 - c.am) * to.ad[0] + c.am * from.ad[0] - (1 - c.af) * to.s.directors[0] -
                             c.af * from.s.directors[0];
        telescoped = std::max(telescoped, h * balance.norm());
        const Mat3 exact = director_acceleration(to.s.q[0], to.s.w[0], to.s.alpha[0]);
        if (i >= steps / 2) worst = std::max(worst, (to.s.directors[0] - exact).norm());
        std::swap(from, to);
      }
      EXPECT_LT(telescoped, 1e-13);
      EXPECT_LT(worst, 0.2);
      if (before > 0) {
        EXPECT_NEAR(std::log2(before / worst), 2, 0.3) << "rho " << rho << ", " << steps << " steps";
      }
      printf("  rho %.1f, %d steps: %.2e from those of w and alpha, telescopes to %.1e\n", rho, steps, worst,
             telescoped);
      before = worst;
    }
  }
}

}  // namespace
}  // namespace hawser::test::step_tangent_test
