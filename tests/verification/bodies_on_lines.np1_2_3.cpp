// Bodies that hang on lines against closed forms: position at rest and periods of pendulums; results do not
// depend on the number of ranks.
#include <gtest/gtest.h>

#include <cstdlib>

#include "hawser/math/symmetric.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::bodies_on_lines {
namespace {

constexpr double kG = 9.80665;

// A few nodes on more ranks than cores take half a minute.
bool too_many_ranks() { return runs::size_of(MPI_COMM_WORLD) > 2 && !std::getenv("HAWSER_FULL"); }

model::End on(const std::string& body, const Vec3& at) {
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = body;
  e.at = at;
  return e;
}

// A load on nearly weightless slings with EA of 10^5 times the weight of the load.
struct Sling {
  Vec3 from, at;  // m: in space, in the load's frame
  double length;
};
model::Case load(double mass, const Vec3& inertia, const Vec3& position, const std::vector<Sling>& slings,
                 int elements) {
  model::Case c;
  c.environment.gravity = kG;
  c.line_types = {cable_type(1e5 * mass * kG, 1e-7 * mass)};
  model::Body& b = c.bodies.emplace_back();
  b.name = "load";
  b.position = position;
  model::BodyMass& m = b.mass.emplace();
  m.mass = mass;
  m.inertia = inertia;
  m.weight = true;
  for (size_t i = 0; i < slings.size(); ++i) {
    model::Line l;
    l.name = "sling " + std::to_string(i);
    l.sections.push_back({"cable", slings[i].length, elements, 1});
    l.end_a = anchor(slings[i].from);
    l.end_b = on("load", slings[i].at);
    c.lines.push_back(l);
  }
  c.dynamics.enabled = true;
  c.dynamics.rho_infinity = 1;
  return c;
}

// A load with an eccentric centre of mass on two slings: the centre of mass is below the hook, and the load
// is tilted.
TEST(BodiesOnLines, LoadOnTwoSlingsAtRest) {
  // Slings of 5 m lead from one hook to two eyes 6 m apart, 1 m above the centre of mass and 0.5 m to its
  // side.
  model::Case c = load(2000, {3000, 4000, 5000}, {0.4, 0, -5},
                       {{{0, 0, 0}, {-3, 0, 1}, 5}, {{0, 0, 0}, {3, 0, 1}, 5}}, 4);
  c.bodies[0].mass->centre = {0.5, 0, 0};
  Simulation s(PETSC_COMM_WORLD, c);
  const StaticsReport report = s.solve_statics();
  const auto& rest = s.state();
  // In the load's frame the hook is at (0, 5) (x, z) and the centre of mass at (0.5, 0); the line between
  // them is vertical.
  const double tilt = std::atan2(0.5, 5.0);
  const double x = from_owner(s, [&](size_t n) { return rest.x[n].x(); });
  const double z = from_owner(s, [&](size_t n) { return rest.x[n].z(); });
  const double turned = from_owner(s, [&](size_t n) {
    const Vec3 axis = rest.q[n] * Vec3::UnitX();
    return std::atan2(axis.z(), axis.x());
  });
  printf("two slings: centre at %.2e, %.6f m, tilt %.6f rad (closed form 0, %.6f, -%.6f), %d iterations\n", x,
         z, turned, -std::hypot(5.0, 0.5), tilt, report.iterations);
  EXPECT_NEAR(x, 0, 2e-5);
  EXPECT_NEAR(z, -std::hypot(5.0, 0.5), 1e-4);
  EXPECT_NEAR(turned, -tilt, 2e-5);
}

// Bifilar pendulum: T = 2 pi sqrt(J L / (m g b²)), slings of length L at the distance b on either side of the
// centre.
TEST(BodiesOnLines, BifilarPendulum) {
  if (too_many_ranks()) GTEST_SKIP() << "long on more than two ranks; set HAWSER_FULL";
  const double L = 4, b = 0.8, J = 60, m = 100;
  model::Case c =
      load(m, {30, 30, J}, {0, 0, -L}, {{{-b, 0, 0}, {-b, 0, 0}, L}, {{b, 0, 0}, {b, 0, 0}, L}}, 1);
  const double T = 2 * M_PI * std::sqrt(J * L / (m * kG * b * b));
  c.bodies[0].mass->angular_velocity = {0, 0, 0.01 * 2 * M_PI / T};
  c.dynamics.duration = 5 * T;
  c.dynamics.step = T / 400;
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  std::vector<std::pair<double, double>> yaw;
  integrate(d, 5 * T, 5 * T, [&](const StepInfo& i) {
    yaw.emplace_back(i.time, from_owner(s, [&](size_t n) {
                       const Vec3 axis = d.committed_kinematics().q[n] * Vec3::UnitX();
                       return std::atan2(axis.y(), axis.x());
                     }));
  });
  const double found = period(yaw);
  printf("bifilar pendulum: %.5f s, closed form %.5f s (%.3f %%)\n", found, T, 100 * (found / T - 1));
  EXPECT_NEAR(found, T, 1e-3 * T);
}

// A compound pendulum on a line: the slower mode of M y'' + K y = 0 in the angles of line and body.
TEST(BodiesOnLines, CompoundPendulumOnALine) {
  if (too_many_ranks()) GTEST_SKIP() << "long on more than two ranks; set HAWSER_FULL";
  const double L = 3, d0 = 1.2, m = 50, J = 20;  // line, eye above the centre
  Eigen::Matrix2d M;
  M << m * L * L, m * L * d0, m * L * d0, m * d0 * d0 + J;
  // With y = S u, S² the inverse of the diagonal stiffness: S M S u = (T / 2 pi)² u.
  const Eigen::Vector2d S = Eigen::Vector2d(m * kG * L, m * kG * d0).cwiseSqrt().cwiseInverse();
  const Eigenpairs modes = eigenpairs(S.asDiagonal() * M * S.asDiagonal());
  const double T = 2 * M_PI * std::sqrt(modes.values[1]);
  const Eigen::Vector2d slow = S.cwiseProduct(modes.vectors.col(1));
  const Eigen::Vector2d mode = slow / slow[0];
  model::Case c = load(m, {J, J, J}, {0, 0, -L - d0}, {{{0, 0, 0}, {0, 0, d0}, L}}, 1);
  // Initial velocities of the centre and the body in that mode; the line turns at 0.01 times the angular
  // frequency.
  const double rate = 0.01 * 2 * M_PI / T;
  c.bodies[0].mass->velocity = {rate * (L + d0 * mode[1]), 0, 0};
  c.bodies[0].mass->angular_velocity = {0, -rate * mode[1], 0};
  c.dynamics.duration = 5 * T;
  c.dynamics.step = T / 400;
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  Dynamics& dyn = s.dynamics();
  dyn.start(s.state());
  std::vector<std::pair<double, double>> swing;
  integrate(dyn, 5 * T, 5 * T, [&](const StepInfo& i) {
    swing.emplace_back(i.time, from_owner(s, [&](size_t n) { return dyn.committed_kinematics().x[n].x(); }));
  });
  const double found = period(swing);
  printf("compound pendulum on a line: %.5f s, closed form %.5f s (%.3f %%)\n", found, T,
         100 * (found / T - 1));
  EXPECT_NEAR(found, T, 1e-3 * T);
}

}  // namespace
}  // namespace hawser::test::bodies_on_lines
