// Second order of the time integrator with finite rotations: a fast heavy top against its own equations
// solved by Runge-Kutta, and a tumbling flexible beam against a run with finer steps.
#include <algorithm>
#include <array>
#include <span>

#include "verification/energy_free_beam.hpp"

namespace hawser::test::order_rotations_test {
namespace {

// The top of Brüls & Cardona (2010), section 5.2: 15 kg at (0, 1, 0) m of the body, gravity 9.81 m/s² along
// -z, angular velocity (0, 150, -4.61538) rad/s. Here a support holds its point.
struct Top {
  Vec3 arm{0, 1, 0}, inertia{15.234375, 0.46875, 15.234375};  // m; kg m², about the point
  double mass = 15, gravity = 9.81;
  Vec3 spin{0, 150, -4.61538};
  Vec3 weight(const Quat& q) const { return q.conjugate() * Vec3(0, 0, -mass * gravity); }
  Vec3 acceleration(const Quat& q, const Vec3& w) const {
    const Vec3 moment = arm.cross(weight(q)) - w.cross(inertia.cwiseProduct(w));
    return moment.cwiseQuotient(inertia);
  }
};

class TopTerm final : public ForceTerm {
 public:
  std::string_view checkpoint_key() const override { return "top"; }
  void evaluate(const Kinematics& k, Assembler& assembler) override {
    const Vec3 w = k.w[0];
    const Vec3 weight = top_.weight(k.q[0]);
    const Vec3 Jw = top_.inertia.cwiseProduct(w);
    // Added in three pieces, because the residual is relative to the size of the contributions.
    const Vec3 inertia = top_.inertia.cwiseProduct(k.alpha[0]);
    const Vec3 turn = w.cross(Jw);
    const Vec3 load = -top_.arm.cross(weight);
    const Mat3 M = top_.inertia.asDiagonal();
    const Mat3 K = -hat(top_.arm) * hat(weight);
    const Mat3 C = hat(w) * M - hat(Jw);
    assembler.add(1, inertia, nullptr, nullptr, &M);
    assembler.add(1, turn, nullptr, &C);
    assembler.add(1, load, &K);
  }

 private:
  Top top_;
};

struct End {
  Quat q;
  Vec3 w;
};

// Runge-Kutta of fourth order on the quaternion, normalised: error 1e-11 with 2e5 steps in 1 s.
End reference(double until, int steps) {
  const Top top;
  using Y = Eigen::Matrix<double, 7, 1>;
  auto rate = [&](const Y& y) {
    const Quat q = Quat(y[0], y[1], y[2], y[3]).normalized();
    const Vec3 w = y.tail<3>();
    const Quat dq = q * Quat(0, w.x(), w.y(), w.z());
    Y d;
    d << 0.5 * dq.w(), 0.5 * dq.vec(), top.acceleration(q, w);
    return d;
  };
  Y y;
  y << 1, 0, 0, 0, top.spin;
  const double h = until / steps;
  for (int i = 0; i < steps; ++i) {
    const Y a = rate(y);
    const Y b = rate(y + 0.5 * h * a);
    const Y c = rate(y + 0.5 * h * b);
    const Y d = rate(y + h * c);
    y += h / 6 * (a + 2 * b + 2 * c + d);
    y.head<4>().normalize();
  }
  return {Quat(y[0], y[1], y[2], y[3]), y.tail<3>()};
}

End top_run(double until, double h, double rho) {
  Mesh mesh;
  mesh.add(Node{0, 0, 0, true});
  mesh.lines.emplace_back();
  mesh.lines[0].nodes = 1;
  System system(PETSC_COMM_SELF, local_mesh(mesh, NodeRanks::all_of(1), 0, 1));
  system.add(std::make_unique<TopTerm>());
  system.tie({TiedNode{}}, {});
  DynamicsSettings settings;
  settings.rho_infinity = rho;
  settings.tolerance = 1e-13;
  settings.step.fixed = h;
  Dynamics d(system, settings);
  State s(1);
  s.w[0] = Top{}.spin;
  d.start(s);
  integrate(d, until, until, [](const StepInfo&) {});
  return {d.committed().s.q[0], d.committed().s.w[0]};
}

void expect_second_order(const char* what, double rho, std::span<const double> error) {
  printf("%s, rho = %.1f: errors", what, rho);
  for (double e : error) printf(" %.3e", e);
  printf(", orders");
  for (size_t i = 0; i + 1 < error.size(); ++i) {
    const double order = std::log2(error[i] / error[i + 1]);
    printf(" %.3f", order);
    EXPECT_NEAR(order, 2, 0.1) << what << ", rho " << rho << ", halving " << i + 1;
  }
  printf("\n");
}

TEST(Order, HeavyTop) {
  constexpr double until = 1;
  const End exact = reference(until, 200000);
  const End check = reference(until, 100000);
  ASSERT_LT(log_so3(exact.q.conjugate() * check.q).norm(), 1e-8);
  for (const double rho : {0.8, 1.0}) {
    std::array<double, 5> rotation{}, velocity{};
    for (size_t i = 0; i < 5; ++i) {
      const End e = top_run(until, 5e-4 / (1 << i), rho);
      rotation[i] = log_so3(exact.q.conjugate() * e.q).norm();
      velocity[i] = (e.w - exact.w).norm() / exact.w.norm();
    }
    expect_second_order("top, rotation [rad]", rho, rotation);
    expect_second_order("top, angular velocity [-]", rho, velocity);
  }
}

// Reference: a run with steps eight times finer than the finest.
TEST(Order, TumblingBeam) {
  constexpr double until = 0.5;
  for (const double rho : {0.8, 1.0}) {
    auto run = [&](int steps) {
      model::Case c = free_line(true, 4);
      model::LineType& t = c.line_types[0];  // soft: all its waves are slow relative to the step
      t.EA = 1e4;
      t.EI2 = t.EI3 = t.GJ = 100;
      c.dynamics.duration = until;
      c.dynamics.step = until / steps;
      c.dynamics.rho_infinity = rho;
      c.dynamics.tolerance = 1e-14 * steps;  // the round-off of accelerations grows as 1 / h
      Simulation s(PETSC_COMM_SELF, c);
      throw_line(s.state(), true);
      for (size_t i = 0; i < s.state().w.size(); ++i) s.state().w[i].x() += 3;  // rotation about its own axis
      Dynamics& d = s.dynamics();
      d.start(s.state());
      integrate(d, until, until, [](const StepInfo&) {});
      return d.committed().s;
    };
    constexpr int first = 500;
    const State exact = run(first * 16 * 8);
    std::array<double, 5> place{}, rotation{}, velocity{};
    for (size_t i = 0; i < 5; ++i) {
      const State s = run(first << i);
      for (size_t n = 0; n < s.x.size(); ++n) {
        place[i] = std::max(place[i], (s.x[n] - exact.x[n]).norm());
        rotation[i] = std::max(rotation[i], log_so3(exact.q[n].conjugate() * s.q[n]).norm());
        velocity[i] = std::max(velocity[i], (s.v[n] - exact.v[n]).norm());
      }
    }
    expect_second_order("beam, position [m]", rho, place);
    expect_second_order("beam, rotation [rad]", rho, rotation);
    expect_second_order("beam, velocity [m/s]", rho, velocity);
  }
}

}  // namespace
}  // namespace hawser::test::order_rotations_test
