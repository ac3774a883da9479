// A floating body that nothing holds, on its own: it falls, and tumbles.
#include <gtest/gtest.h>

#include "hawser/run/simulation.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::body_free {
namespace {

model::Case box(double mass) {
  model::Case c;
  c.statics.enabled = false;
  c.bodies.emplace_back();
  c.bodies[0].name = "box";
  c.bodies[0].position = {0, 0, 2};
  c.bodies[0].mass.emplace();
  c.bodies[0].mass->mass = mass;
  c.bodies[0].mass->inertia = Vec3(0.5, 0.6, 0.4) * mass;
  c.dynamics.enabled = true;
  c.dynamics.duration = 1;
  return c;
}

// What of a body is there at the end, on all ranks alike.
template <class What>
double at_end(const model::Case& c, const What& what) {
  run::Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, 1, 1, [](const StepInfo&) {});
  const int node = s.local().find(s.mesh().body_node(0));
  double value = node >= 0 && node < s.local().owned ? what(d.kinematics(), static_cast<size_t>(node)) : 0;
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return value;
}

// Weight and inertia cancel to the last bits, which are other for each mass.
TEST(BodyFree, Falls) {
  double worst = 0;
  for (int i = 1; i <= 60; ++i) {
    model::Case c = box(i < 60 ? 37.1 * i : 1000);
    c.bodies[0].mass->weight = true;
    const double g = c.environment.gravity;
    const double z = at_end(c, [](const Kinematics& k, size_t n) { return k.x[n].z(); });
    worst = std::max(worst, std::abs(z - (2 - 0.5 * g)));
  }
  printf("falls: %.1e m off\n", worst);
  EXPECT_LT(worst, 1e-9);
}

// So do the moments of a body that turns about no axis of its own.
TEST(BodyFree, Tumbles) {
  double worst = 0;
  for (const double mass : {1.0, 371.0, 1000.0}) {
    model::Case c = box(mass);
    const Vec3 spin(0.3, -0.2, 0.5);
    c.bodies[0].mass->angular_velocity = spin;
    const auto momentum = [&](const Vec3& w) { return c.bodies[0].mass->inertia.cwiseProduct(w).norm(); };
    const double end = at_end(c, [&](const Kinematics& k, size_t n) { return momentum(k.w[n]); });
    worst = std::max(worst, std::abs(end / momentum(spin) - 1));
  }
  printf("tumbles: angular momentum %.1e off\n", worst);
  EXPECT_LT(worst, 1e-5);
}

}  // namespace
}  // namespace hawser::test::body_free
