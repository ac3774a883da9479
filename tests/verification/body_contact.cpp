// Contact of bodies with mass: collisions against closed forms, thin plates, springs, conservation of
// momentum.
#include "hawser/terms/body_contact.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::body_contact_test {
namespace {

model::Body floater(const char* name, double mass, const Vec3& at, const Vec3& velocity) {
  model::Body b;
  b.name = name;
  b.position = at;
  b.mass.emplace();
  b.mass->mass = mass;
  b.mass->inertia = Vec3(40, 50, 60) * mass;
  b.mass->velocity = velocity;
  return b;
}

model::Volume volume(const char* name, const char* body, Primitive shape, model::StiffnessBasis basis,
                     double stiffness) {
  model::Volume v;
  v.name = name;
  v.body = body;
  v.shape = std::move(shape);
  v.basis = basis;
  v.normal_stiffness = stiffness;
  return v;
}

struct Collision {
  explicit Collision(const model::Case& c)
      : volumes(run::load_volumes(c)),
        sim(PETSC_COMM_SELF, c, run::surfaces(volumes), run::skeletons(c, volumes)) {
    sim.dynamics().start(sim.state());
  }
  size_t node(int body) { return static_cast<size_t>(sim.local().find(sim.mesh().body_node(body))); }
  std::vector<run::LoadedVolume> volumes;
  run::Simulation sim;
};

// Head-on collision of two floaters: m1 = 1e7 kg at 0.5 m/s, m2 = 2.5e7 kg at -0.1 m/s, fender 5e6 N/m.
// Depth, force, duration and speeds are those of the closed forms of a linear spring and of a Kelvin-Voigt
// spring without tension.
model::Case floaters(double zeta) {
  model::Case c;
  c.statics.enabled = false;
  c.bodies = {floater("north", 1e7, {-31, 0, 0}, {0.5, 0, 0}),
              floater("south", 2.5e7, {31, 0, 0}, {-0.1, 0, 0})};
  c.volumes = {
      volume("fender", "north", SphereShape{{29.95, 0, 0}, 1}, model::StiffnessBasis::per_point, 5e6),
      volume("hull", "south", BoxShape{{0, 0, 0}, {60, 40, 20}}, model::StiffnessBasis::per_length, 1e9)};
  c.volumes[0].relative_damping = zeta;
  c.dynamics.enabled = true;
  c.dynamics.duration = 8;
  c.dynamics.rho_infinity = 1;
  c.dynamics.step = 0.005;
  return c;
}

struct Bump {
  double depth = 0, force = 0, duration = 0, v1 = 0, v2 = 0, momentum = 0, audit = 0;
};
Bump bump(double zeta) {
  const model::Case c = floaters(zeta);
  Collision run(c);
  Dynamics& d = run.sim.dynamics();
  const size_t a = run.node(0);
  const size_t b = run.node(1);
  Bump out;
  const double p0 = 1e7 * 0.5 - 2.5e7 * 0.1;
  const double e0 = total(run.sim.system().energy(d.committed_kinematics()));
  integrate(d, 8, 8, [&](const StepInfo& i) {
    const Kinematics k = d.committed_kinematics();
    const double F = run.sim.system().find<RigidBodies>()->force_on(1, k)[0].x();
    out.force = std::max(out.force, F);
    out.duration += F > 1 ? i.h : 0;
    out.momentum =
        std::max(out.momentum, std::abs(1e7 * k.v[a].x() + 2.5e7 * k.v[b].x() - p0) / std::abs(p0));
    const Energy e = run.sim.system().energy(k);
    out.audit = std::max(out.audit, std::abs(total(e) + e.damping - e0) / e0);
    out.v1 = k.v[a].x();
    out.v2 = k.v[b].x();
  });
  out.depth = run.sim.system().find<BodyContact>()->largest_penetration();
  printf("zeta %g: penetration %.6f m, force %.4e N, %.4f s, v %.6f %.6f m/s; momentum %.1e, energy %.1e\n",
         zeta, out.depth, out.force, out.duration, out.v1, out.v2, out.momentum, out.audit);
  return out;
}

TEST(BodyContact, FloatersWithAFender) {
  const Bump r = bump(0);
  EXPECT_NEAR(r.depth, 0.7171371656, 0.002 * 0.7171371656);
  EXPECT_NEAR(r.force, 3585685.828, 0.002 * 3585685.828);
  EXPECT_NEAR(r.duration, 3.754921418, 0.01);
  EXPECT_NEAR(r.v1, -0.3571428571, 0.002 * 0.357);
  EXPECT_NEAR(r.v2, 0.2428571429, 0.002 * 0.243);
  EXPECT_LT(r.momentum, 1e-9);
  EXPECT_LT(r.audit, 1e-3);
}

TEST(BodyContact, FloatersWithADampedFender) {
  const Bump r = bump(0.03346640106);  // c = 4e5 N s/m
  EXPECT_NEAR(r.depth, 0.6811548054, 0.002 * 0.6811548054);
  EXPECT_NEAR(r.duration, 3.676966155, 0.01);
  EXPECT_NEAR(r.v1, -0.3152146527, 0.002 * 0.3152);
  EXPECT_NEAR(r.v2, 0.2260858611, 0.002 * 0.2261);
  EXPECT_LT(r.momentum, 1e-9);
  EXPECT_LT(r.audit, 2e-3);
}

// A fender with a softening table: its largest potential energy is the energy of the relative motion.
TEST(BodyContact, FloatersWithAFenderByTable) {
  model::Case c = floaters(0);
  const std::vector<ContactForceTable::Row> rows{{0.1, 4e5}, {0.3, 9e5}, {1.5, 2e6}};
  const auto table = std::make_shared<ContactForceTable>(rows);
  c.volumes[0].force_table = table;
  c.volumes[0].normal_stiffness = table->largest_slope();
  Collision run(c);
  integrate(run.sim.dynamics(), 8, 8, [](const StepInfo&) {});
  const double mass = 1 / (1 / 1e7 + 1 / 2.5e7);
  const double energy = 0.5 * mass * 0.6 * 0.6;
  const double depth = run.sim.system().find<BodyContact>()->largest_penetration();
  EXPECT_NEAR(table->at(depth).potential, energy, 1e-3 * energy) << depth;
  EXPECT_LT(table->at(depth).force, 0.9 * table->largest_slope() * depth);
}

// A block is thrown at a thin fixed plate at up to 50 m/s in steps of up to 0.1 s. It does not pass the
// plate, although its corners and edges may cross the plate within one step.
TEST(BodyContact, ThinPlatesAreNotPassed) {
  for (const model::StiffnessBasis basis :
       {model::StiffnessBasis::per_point, model::StiffnessBasis::per_length})
    for (const bool resolve : {true, false})
      for (const double step : {0.0, 0.02, 0.1}) {
        // The stiffness stops the block within half the thickness of the plate.
        const double stiffness = basis == model::StiffnessBasis::per_point ? 2e10 : 1e12;
        int passed = 0, steps = 0, rejected = 0;
        double depth = 0;
        for (const double speed : {1.0, 5.0, 10.0, 20.0, 50.0}) {
          model::Case c;
          c.statics.enabled = false;
          c.environment.gravity = 0;
          c.bodies = {floater("block", 1000, {-2.1, 0.1, 0.2}, {speed, 0, 0})};
          c.bodies[0].rotation = Vec3(0.1, 0.2, 0.3);
          c.volumes = {volume("block", "block", BoxShape{{0, 0, 0}, {2, 2, 2}}, basis, stiffness),
                       volume("plate", "", BoxShape{{0, 0, 0}, {0.05, 10, 10}}, basis, stiffness)};
          c.dynamics.enabled = true;
          c.dynamics.duration = 1;
          c.dynamics.step = step;
          c.dynamics.max_step = 0.1;
          c.dynamics.resolve_impacts = resolve;
          Collision run(c);
          const size_t n = run.node(0);
          run.sim.dynamics().run(
              3 / speed, [](double) { return 1e300; },
              [&](const StepInfo& i) {
                ++steps;
                rejected += i.rejected;
                return true;
              });
          passed += run.sim.dynamics().committed().s.x[n].x() > 0;
          depth = std::max(depth, run.sim.system().find<BodyContact>()->largest_penetration());
        }
        printf("%s, %s, step %g: %d of 5 passed, %d steps, %d rejected, deepest %.4f m\n",
               basis == model::StiffnessBasis::per_point ? "corners" : "edges",
               resolve ? "divided" : "undivided", step, passed, steps, rejected, depth);
        EXPECT_EQ(passed, 0);
      }
}

// A body on springs oscillates with 2 pi sqrt(m / k) and 2 pi sqrt(J / kr).
TEST(BodyContact, ABodyOnSpringsSwings) {
  model::Case c;
  c.statics.enabled = false;
  c.bodies = {floater("buoy", 200, {1, 2, 3}, {0.3, 0, 0})};
  c.bodies[0].mass->stiffness = Vec3(800, 500, 900);
  c.bodies[0].mass->turning_stiffness = Vec3(0, 0, 3000);
  c.bodies[0].mass->angular_velocity = Vec3(0, 0, 0.1);
  c.dynamics.enabled = true;
  c.dynamics.duration = 40;
  c.dynamics.rho_infinity = 1;
  c.dynamics.step = 0.01;
  Collision run(c);
  Dynamics& d = run.sim.dynamics();
  const double w = std::sqrt(800.0 / 200);
  const double turn = std::sqrt(3000 / (60.0 * 200));
  double off = 0, angle = 0;
  integrate(d, 40, 40, [&](const StepInfo& i) {
    const Kinematics k = d.committed_kinematics();
    off = std::max(off, std::abs(k.x[0].x() - 1 - 0.3 / w * std::sin(w * i.time)));
    angle = std::max(angle, std::abs(log_so3(k.q[0]).z() - 0.1 / turn * std::sin(turn * i.time)));
  });
  EXPECT_LT(off, 1e-3 * 0.15 * 5);  // period error h² w² / 12 of 40 s
  EXPECT_LT(angle, 1e-3 * 0.2);
}

// Two tumbling boxes collide edge on edge: linear and angular momentum are constant, and the energy is
// recovered after the impact.
TEST(BodyContact, TumblingBoxesKeepMomentum) {
  model::Case c;
  c.statics.enabled = false;
  c.bodies = {floater("a", 3, {-1.6, 0.1, 0.2}, {1, 0.1, 0}),
              floater("b", 5, {1.5, 0, -0.1}, {-0.6, 0, 0.1})};
  for (auto& b : c.bodies) b.mass->inertia = b.mass->mass * Vec3(0.4, 0.5, 0.6);
  c.bodies[0].rotation = Vec3(0.5, 0.9, -0.3);
  c.bodies[1].rotation = Vec3(-0.4, 0.3, 0.8);
  c.bodies[0].mass->angular_velocity = Vec3(0.4, -0.3, 0.5);
  c.bodies[1].mass->centre = Vec3(0.1, -0.05, 0.1);
  c.volumes = {volume("A", "a", BoxShape{{0, 0, 0}, {1.4, 1, 0.8}}, model::StiffnessBasis::per_length, 4000),
               volume("B", "b", BoxShape{{0, 0, 0}, {1, 1.2, 0.9}}, model::StiffnessBasis::per_length, 4000)};
  c.dynamics.enabled = true;
  c.dynamics.duration = 3;
  c.dynamics.rho_infinity = 1;
  c.dynamics.step = 0.002;
  Collision run(c);
  Dynamics& d = run.sim.dynamics();
  const size_t a = run.node(0);
  const size_t b = run.node(1);
  const auto angular = [&](const Kinematics& k) {
    Vec3 L = Vec3::Zero();
    for (const auto& [n, body] : {std::pair(a, 0), std::pair(b, 1)}) {
      const model::BodyMass& m = *c.bodies[static_cast<size_t>(body)].mass;
      L += m.mass * k.x[n].cross(k.v[n]) + k.q[n] * Vec3(m.inertia.cwiseProduct(k.w[n]));
    }
    return L;
  };
  const Kinematics k0 = d.committed_kinematics();
  const Vec3 p0 = 3 * k0.v[a] + 5 * k0.v[b];
  const Vec3 L0 = angular(k0);
  const double e0 = total(run.sim.system().energy(k0));
  double strain = 0, momentum = 0, turning = 0, energy = 0;
  integrate(d, 3, 3, [&](const StepInfo&) {
    const Kinematics k = d.committed_kinematics();
    const Energy e = run.sim.system().energy(k);
    strain = std::max(strain, e.strain / e0);
    energy = std::max(energy, std::abs(total(e) / e0 - 1));
    momentum = std::max(momentum, (3 * k.v[a] + 5 * k.v[b] - p0).norm() / 3);
    turning = std::max(turning, (angular(k) - L0).norm() / L0.norm());
  });
  printf("boxes: strain energy up to %.2f of all; momentum %.1e, angular momentum %.1e, energy %.1e\n",
         strain, momentum, turning, energy);
  EXPECT_GT(strain, 0.1);
  EXPECT_LT(momentum, 1e-9);
  EXPECT_LT(turning, 1e-9);
  EXPECT_LT(energy, 2e-3);
}

}  // namespace
}  // namespace hawser::test::body_contact_test
