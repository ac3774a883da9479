// The ways of keeping a node out of a volume beside each other: elastic, augmented, exact, rigid, gap spring.
// The pipe of the figure in cases/impact: 60 m of 12 inch, falls to 1.5 m/s and meets a point support with
// its middle.
#include "verification/contact_models.hpp"

namespace hawser::test::contact_models_test {
namespace {

struct Landing {
  double peak = 0, impulse = 0, energy = 0;  // N, N s, J: largest ever above the start
  double depth = 0;                          // m, of the node under the surface
  int releases = 0;
};

// step 0: automatic, at most `longest` (0: as the program likes).
Landing land(model::ContactMethod method, double step, double longest = 0) {
  model::Case c = pipe(method, step);
  c.dynamics.max_step = longest;
  Simulation s(PETSC_COMM_WORLD, c, {point_support()});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  NodeField contact(s, "contact_normal_force");
  Landing out;
  const auto total = [&] {
    const Energy e = s.system().energy(d.kinematics());
    return e.kinetic + e.strain + e.potential;
  };
  const double e0 = total();
  double last = 0;
  d.run(
      0.35, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        double f = 0;
        for (const double x : contact.at(d.kinematics())) f += x;
        out.peak = std::max(out.peak, f);
        out.impulse += 0.5 * (f + last) * i.h;
        if (last > 0 && f == 0) ++out.releases;
        last = f;
        out.energy = std::max(out.energy, total() - e0);
        out.depth = std::max(out.depth, kPipeRadius - d.committed().s.x[30].z());
        return true;
      });
  return out;
}

double fallen_energy() { return kMass * 60 * kSpeed * kSpeed / 2; }

// The spring decides the force, not the step, where the program may shorten it as the node strikes.
TEST(ContactModels, ElasticPeakDoesNotDependOnTheStep) {
  const double period = 2 * M_PI * std::sqrt(kMass / kStiffness);
  const Landing fine = land(model::ContactMethod::nodes, period / 200);
  const auto expect = [&](const char* how, double part, const Landing& l, double within) {
    std::printf(
        "elastic, %s T/%2.0f: peak %.1f kN (%+.2f %% of T/200), impulse %.3f kN s, energy %+.2e of the "
        "fall\n",
        how, part, l.peak / 1e3, 100 * (l.peak / fine.peak - 1), l.impulse / 1e3, l.energy / fallen_energy());
    EXPECT_NEAR(l.peak, fine.peak, within * fine.peak) << how << ' ' << part;
    EXPECT_LT(l.energy, 1e-9 * fallen_energy());
  };
  for (const double part : {3.0, 4.0, 6.0, 10.0, 20.0, 50.0}) {
    expect("automatic, at most", part, land(model::ContactMethod::nodes, 0, period / part), 0.03);
    expect("fixed", part, land(model::ContactMethod::nodes, period / part), 0.03);
  }
  expect("automatic, at most", 0, land(model::ContactMethod::nodes, 0), 0.03);
}

// The step decides the force: the speed of the node is taken out in one. No energy is made of it.
TEST(ContactModels, RigidPeakGrowsAsTheStepFalls) {
  double first = 0, before = 0, last = 0;
  for (const double step : {8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 1.25e-4, 6.25e-5}) {
    const Landing l = land(model::ContactMethod::rigid, step);
    std::printf("rigid, %.3g ms: peak %.1f kN, impulse %.3f kN s, %d releases, %.1e m under, energy %+.2e\n",
                1e3 * step, l.peak / 1e3, l.impulse / 1e3, l.releases, l.depth, l.energy / fallen_energy());
    EXPECT_LT(l.depth, 1e-7 * kPipeRadius);
    EXPECT_LT(l.energy, 1e-12 * fallen_energy());
    EXPECT_GT(l.peak, last);
    if (first == 0) first = l.peak;
    before = last, last = l.peak;
  }
  EXPECT_GT(last, 10 * first);
  EXPECT_NEAR(last, 2 * before, 0.2 * last);  // in short steps as one over the step
}

// A cable laid over a round bar from both sides, in statics: penetration by the spring, by multipliers, and
// exactly, and the same shape whatever the stiffness.
struct Hung {
  double deepest = 0, force = 0, tension = 0;  // m, N, N
  int touching = 0, iterations = 0;
};
Hung hang(double stiffness, bool augmented, bool exact) {
  const model::Case c = hung_cable(stiffness, augmented, exact);
  Simulation s(PETSC_COMM_WORLD, c, {round_drum(3.6, 2)});
  Hung out;
  out.iterations = s.solve_statics().iterations;
  NodeField force(s, "contact_normal_force"), tension(s, "effective_tension");
  for (const double f : force.at(s.state().view(0))) out.force += f, out.touching += f > 0;
  for (const double t : tension.at(s.state().view(0))) out.tension = std::max(out.tension, t);
  for (const Vec3& x : s.state().x) out.deepest = std::max(out.deepest, 3.65 - std::hypot(x.x(), x.z()));
  return out;
}

TEST(ContactModels, MultipliersWorkOffThePenetration) {
  const Hung soft = hang(1e5, false, false), exact = hang(1e6, true, true);
  std::printf(
      "elastic 1e5 N/m: %.2e m deep, %d nodes, %.1f N of contact, largest tension %.1f N, %d iterations\n",
      soft.deepest, soft.touching, soft.force, soft.tension, soft.iterations);
  std::printf("exact:           %.2e m deep, %d nodes, %.1f N, %.1f N, %d iterations\n", exact.deepest,
              exact.touching, exact.force, exact.tension, exact.iterations);
  EXPECT_GT(soft.deepest, 1e-3);
  EXPECT_LT(exact.deepest, 1e-9);
  for (const double k : {1e5, 1e6, 1e7}) {
    const Hung h = hang(k, true, false);
    std::printf("augmented %.0e:  %.2e m deep, %d nodes, %.1f N, %.1f N, %d iterations\n", k, h.deepest,
                h.touching, h.force, h.tension, h.iterations);
    EXPECT_LT(h.deepest, 2e-7);
    EXPECT_EQ(h.touching, exact.touching);
    EXPECT_NEAR(h.force, exact.force, 1e-4 * exact.force);
    EXPECT_NEAR(h.tension, exact.tension, 1e-5 * exact.tension);
  }
}

// In motion: with multipliers the node stops at the surface, and a step that is tried again leaves no trace.
TEST(ContactModels, AugmentedInMotion) {
  model::Case c = pipe(model::ContactMethod::nodes, 4e-3);
  c.contact.augmented = true;
  c.contact.allowed_penetration = 1e-6;
  Simulation s(PETSC_COMM_WORLD, c, {point_support()});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  double deepest = 0, most = 0;
  NodeField contact(s, "contact_normal_force");
  d.run(
      0.3, [](double t) { return t + 100; },
      [&](const StepInfo&) {
        deepest = std::max(deepest, kPipeRadius - d.committed().s.x[30].z());
        for (const double f : contact.at(d.kinematics())) most = std::max(most, f);
        return true;
      });
  std::printf("augmented in motion: %.1e m under the surface, peak %.1f kN\n", deepest, most / 1e3);
  EXPECT_GT(most, 1e4);
  EXPECT_LT(deepest, 2e-6);
  // A try that is thrown away.
  s.system().prepare(d.kinematics(), 4e-3);
  const Dynamics::Attempt first = d.attempt(4e-3);
  const double h2 = d.attempt(2e-3).converged ? 1 : 0;
  const Dynamics::Attempt again = d.attempt(4e-3);
  EXPECT_EQ(h2, 1);
  EXPECT_EQ(first.iterations, again.iterations);
  EXPECT_EQ(first.error, again.error);
}

// A gap spring knows the normal of the start alone: pushed off the side of a roller, the pipe still lies on
// the plane that was there, while a surface lets it go.
TEST(ContactModels, GapSpringKeepsItsDirection) {
  for (const auto method : {model::ContactMethod::gap, model::ContactMethod::nodes}) {
    model::LineType type = beam_type(1e8, 1e6, 1e6, 100);
    type.outer_diameter = type.contact_diameter = 0.2;
    model::Case c = one_line(type, 2, 1, {}, {});
    c.environment.gravity = kGravity;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {{-1, 0, 0.1}, {1, 0, 0.1}};
    c.lines[0].loads.push_back({Vec3(0, 400, 0), 0, -1, 0, 0});
    model::Volume roller;
    roller.name = "roller";
    roller.basis = model::StiffnessBasis::per_point;
    roller.normal_stiffness = 1e6;
    roller.relative_damping = 0.3;
    c.volumes.push_back(roller);
    c.contact.method = method;
    c.dynamics.enabled = true;
    c.dynamics.step = 0.005;
    Simulation s(PETSC_COMM_WORLD, c,
                 {std::make_shared<CylinderSurface>(Vec3(-2, 0, -0.3), Vec3(2, 0, -0.3), 0.3)});
    Dynamics& d = s.dynamics();
    d.start(s.state());
    d.run(
        1.5, [](double t) { return t + 100; }, [](const StepInfo&) { return true; });
    const Vec3 x = d.committed().s.x[0];
    std::printf("%s: after 1.5 s at y %.2f m, z %.3f m\n",
                method == model::ContactMethod::gap ? "gap" : "nodes", x.y(), x.z());
    EXPECT_GT(x.y(), 2);
    if (method == model::ContactMethod::gap)
      EXPECT_NEAR(x.z(), 0.1 - 1e2 * kGravity / 1e6, 1e-3);
    else
      EXPECT_LT(x.z(), -1);
  }
}

}  // namespace
}  // namespace hawser::test::contact_models_test
