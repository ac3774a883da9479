// A free floating body falls and tumbles as in closed form.
#include <gtest/gtest.h>

#include "hawser/base/mpi.hpp"
#include "hawser/kernels/coupled_mass.hpp"
#include "hawser/model/mass_matrix.hpp"
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

// `what` of the body at the end of the run, on all ranks.
template <class What>
double at_end(const model::Case& c, const What& what) {
  run::Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  integrate(d, 1, 1, [](const StepInfo&) {});
  const int node = s.local().find(s.mesh().body_node(0));
  double value =
      node >= 0 && node < s.local().owned ? what(d.committed_kinematics(), static_cast<size_t>(node)) : 0;
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return value;
}

// Free fall, z = -g t²/2, for 60 masses: weight and inertia cancel to round-off, which differs from mass to
// mass.
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

// A body that rotates about no principal axis keeps its angular momentum.
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

// A thrown and rotating body with a full mass matrix that is not the matrix of a rigid body. Momentum and
// angular momentum about a fixed point are constant at any step, with and without numerical damping; the
// energy without damping has an error of second order in the step.
TEST(BodyFree, CoupledMassKeepsMomentum) {
  double before = 0;
  for (const auto& [step, rho] : {std::pair(0.02, 1.0), std::pair(0.01, 1.0), std::pair(0.05, 0.8)}) {
    model::Case c = box(1000);
    model::BodyMass& m = *c.bodies[0].mass;
    Mat6 rows = Mat6::Zero();
    rows.diagonal() << 1500, 2600, 4000, 700, 900, 600;
    rows(0, 4) = rows(4, 0) = 400;
    rows(1, 3) = rows(3, 1) = -250;
    rows(2, 5) = rows(5, 2) = 300;
    rows(0, 1) = rows(1, 0) = 200;
    m.matrix = model::MassMatrix{rows, Vec3(0.2, 0.1, -0.3)};
    m.centre_given = true;
    model::use_mass_matrix(m);
    m.velocity = Vec3(1, -0.5, 0.3);
    m.angular_velocity = Vec3(0.6, -0.4, 0.8);
    c.dynamics.step = step;
    c.dynamics.rho_infinity = rho;
    Vec6 first = Vec6::Zero();
    double energy = 0, off = 0, lost = 0;
    const Mat6 M = rigid_mass(m.mass, m.tensor()) + m.coupled;
    const auto momentum = [&](const Kinematics& k, int n) {
      Vec6 rate, P, out;
      rate << k.q[n].conjugate() * k.v[n], k.w[n];
      P = M * rate;
      const Vec3 p = k.q[n] * P.head<3>();
      out << p, k.x[n].cross(p) + k.q[n] * P.tail<3>();
      return std::pair(out, 0.5 * rate.dot(P));
    };
    run::Simulation s(PETSC_COMM_WORLD, c);
    Dynamics& d = s.dynamics();
    d.start(s.state());
    const int node = s.local().find(s.mesh().body_node(0));
    const bool here = s.local().owns(node);
    if (here) std::tie(first, energy) = momentum(d.committed_kinematics(), node);
    integrate(d, 4, 4, [&](const StepInfo&) {
      if (!here) return;
      const auto [P, T] = momentum(d.committed_kinematics(), node);
      off = std::max(off, (P - first).norm() / first.norm());
      lost = std::max(lost, std::abs(T / energy - 1));
    });
    std::vector<double> both = {off, lost};
    all_reduce(PETSC_COMM_WORLD, MPI_MAX, both);
    printf("coupled mass, steps of %g s: momentum off by %.1e, energy by %.1e\n", step, both[0], both[1]);
    EXPECT_LT(both[0], 1e-9);
    if (rho < 1) continue;
    EXPECT_LT(both[1], 6e-5 * (step / 0.01) * (step / 0.01));
    if (before > 0) {
      EXPECT_NEAR(before / both[1], 4, 0.3);
    }
    before = both[1];
  }
}

}  // namespace
}  // namespace hawser::test::body_free
