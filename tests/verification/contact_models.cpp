// Contact at the nodes by an elastic surface and by gap springs. Pipe of the figure in cases/impact: 60 m, 12
// in, falls at 1.5 m/s onto a point support under its middle.
#include "verification/contact_models.hpp"

namespace hawser::test::contact_models_test {
namespace {

struct Landing {
  double peak = 0, impulse = 0, energy = 0;  // N, N s, J: largest energy above that at the start
  double depth = 0;                          // m, of the node under the surface
  int releases = 0;
};

// step 0: automatic steps of at most `longest` (0: no limit).
Landing land(model::ContactMethod method, double step, double longest = 0) {
  model::Case c = pipe(method, step);
  c.dynamics.max_step = longest;
  Simulation s(PETSC_COMM_WORLD, c, {point_support()});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  NodeField contact(s, "contact_normal_force");
  Landing out;
  const auto total = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    return e.kinetic + e.strain + e.potential;
  };
  const double e0 = total();
  double last = 0;
  d.run(
      0.35, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        double f = 0;
        for (const double x : contact.at(d.committed_kinematics())) f += x;
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

// The peak force depends on the spring and not on the step, because the program shortens steps at impacts.
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

// A gap spring keeps the normal of the start. A pipe that is pushed off the side of a roller still lies on
// the initial tangent plane; contact with the surface releases it.
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
