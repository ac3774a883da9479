// A load on a heave compensator under a crane tip that heaves: static stretch, and transmissibility of a
// single degree of freedom, |z|/A = sqrt((k² + (c w)²)/((k - m w²)² + (c w)²)) (any textbook, for example
// Thomson and Dahleh 1998, Theory of Vibration with Applications, section 3.5).
#include <gtest/gtest.h>

#include "verification/dynamics_rig.hpp"

namespace hawser::test::heave_compensator {
namespace {

constexpr double kG = 9.80665, kMass = 60e3, kStiffness = 60e3, kDamping = 24e3;  // kg, N/m, N s/m
constexpr double kAmplitude = 0.5;                                                // m

enum class Spring { linear, precharged };

// The precharged compensator carries the load at its initial length: a linear table.
model::Case compensator(Spring spring, double period) {
  model::Case c;
  c.environment.gravity = kG;
  model::Body& crane = c.bodies.emplace_back();
  crane.name = "crane";
  crane.position = {0, 0, 20};
  model::HarmonicMotion heave;
  heave.amplitude = {0, 0, kAmplitude};
  heave.period = period;
  crane.motion = heave;
  crane.ramp = period;
  model::Body& load = c.bodies.emplace_back();
  load.name = "load";
  load.position = {0, 0, 5};
  model::BodyMass& m = load.mass.emplace();
  m.mass = kMass;
  m.inertia = {1e5, 1e5, 1e5};
  m.weight = true;
  model::Link& l = c.links.emplace_back();
  l.name = "compensator";
  l.end_a.body = "crane";
  l.end_b.body = "load";
  l.end_b.at = {0, 0, 1};
  l.law.damping = kDamping;
  l.law.stiffness = kStiffness;
  l.law.rest_length = 14;
  l.rest_given = spring == Spring::linear;
  if (spring == Spring::precharged) {
    const double weight = kMass * kG, reach = 4;
    l.law.stiffness = 0;
    l.law.spring = std::make_shared<MonotoneCubic>(std::vector<MonotoneCubic::Row>{
        {-reach, weight - reach * kStiffness}, {reach, weight + reach * kStiffness}});
  }
  c.dynamics.enabled = true;
  c.dynamics.rho_infinity = 1;
  return c;
}

double height(const Simulation& s, const Kinematics& k) {
  return k.x[static_cast<size_t>(s.local().find(s.mesh().body_node(1)))].z();
}

TEST(HeaveCompensator, Transmissibility) {
  for (const double ratio : {0.5, 1.0, 1.6, 3.0}) {
    const double w = ratio * std::sqrt(kStiffness / kMass);
    const double period = 2 * M_PI / w;
    const double by = std::sqrt((std::pow(kStiffness, 2) + std::pow(kDamping * w, 2)) /
                                (std::pow(kStiffness - kMass * w * w, 2) + std::pow(kDamping * w, 2)));
    for (const Spring spring : {Spring::linear, Spring::precharged}) {
      model::Case c = compensator(spring, period);
      const double settled = std::ceil(80 / period) * period;
      const double end = settled + 4 * period;
      c.dynamics.duration = end;
      c.dynamics.step = period / 200;
      Simulation s(PETSC_COMM_SELF, c);
      s.solve_statics();
      const double rest = height(s, s.state().at_rest());
      const double stretch = 20 - (rest + 1) - 14;
      const double hangs = spring == Spring::linear ? kMass * kG / kStiffness : 0;
      EXPECT_NEAR(stretch, hangs, 1e-7 * (1 + hangs));
      Dynamics& d = s.dynamics();
      d.start(s.state());
      // Sine and cosine components of the last four periods.
      double sine = 0, cosine = 0;
      integrate(d, end, end, [&](const StepInfo& i) {
        if (i.time < settled + 0.5 * c.dynamics.step) return;
        const double z = height(s, d.committed_kinematics()) - rest;
        sine += 2 * z * std::sin(w * i.time) / 800;
        cosine += 2 * z * std::cos(w * i.time) / 800;
      });
      const double found = std::hypot(sine, cosine) / kAmplitude;
      printf("  w/w_n = %.1f, %s: %.5f, closed form %.5f (%+.3f %%)\n", ratio,
             spring == Spring::linear ? "linear" : "precharged table", found, by, 100 * (found / by - 1));
      EXPECT_NEAR(found, by, 1e-3 * by);
    }
  }
}

}  // namespace
}  // namespace hawser::test::heave_compensator
