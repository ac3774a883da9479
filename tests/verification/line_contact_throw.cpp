// A pipe of 60 m (12 in) is thrown at 1.5 m/s on a thin bar across below its middle and rebounds. With
// contact along the line the peak reaction does not depend on the step, and contact does not generate energy.
#include "verification/contact_rig.hpp"

namespace hawser::test::line_contact_throw_test {
namespace {

constexpr double kSpan = 60, kDiameter = 0.3239, kWall = 0.0127, kMass = 180,
                 kPull = 2e5;                             // m, m, m, kg/m, N
constexpr double kSpeed = 1.5, kGap = 0.05, kBar = 0.05;  // m/s, m, m (radius)

struct Thrown {
  double most = 0, impulse = 0, depth = 0;  // N, N s, m: largest reaction, over the first second
  double made = 0;  // largest increase of the total energy, over the initial kinetic energy
  double audit = 0;
  int steps = 0;
  double iterations = 0;
};

// step 0: automatic steps of at most `longest` (0: no limit).
Thrown throw_pipe(double stiffness, double step, double longest = 0, bool resolve = true) {
  constexpr int elements = 60;
  const double steel = 2.07e11;
  const double r = kDiameter / 2;
  const double bore = r - kWall;
  const double area = M_PI * (r * r - bore * bore);
  const double I = M_PI / 4 * (std::pow(r, 4) - std::pow(bore, 4));
  model::LineType type = beam_type(steel * area, steel * I, 0.77 * steel * I, kMass);
  type.outer_diameter = type.contact_diameter = kDiameter;
  model::Case c = one_line(type, kSpan / (1 + kPull / (steel * area)), elements, anchor({0, 0, 0}),
                           anchor({kSpan, 0, 0}));
  c.environment.gravity = 9.81;
  c.dynamics.step = step;
  c.dynamics.max_step = longest;
  c.dynamics.resolve_impacts = resolve;
  c.dynamics.duration = 1;
  // The position at rest without the support.
  Simulation rest(PETSC_COMM_WORLD, c);
  rest.solve_statics();
  const double sag = rest.state().x[static_cast<size_t>(elements / 2)].z();

  model::Volume bar;
  bar.name = "bar";
  bar.basis = model::StiffnessBasis::per_length;
  bar.normal_stiffness = stiffness;
  c.volumes.push_back(bar);
  const double z = sag - kGap - r - kBar;
  Simulation s(PETSC_COMM_WORLD, c,
               {std::make_shared<CylinderSurface>(Vec3(kSpan / 2, -1, z), Vec3(kSpan / 2, 1, z), kBar)});
  s.solve_statics();
  for (size_t n = 0; n < s.state().x.size(); ++n)
    s.state().v[n] = -kSpeed * std::sin(M_PI * s.state().x[n].x() / kSpan) * Vec3::UnitZ();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  NodeField normal(s, "contact_normal_force");
  const auto total = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    return e.kinetic + e.strain + e.potential;
  };
  const double before = total();
  const double kinetic = s.system().energy(d.committed_kinematics()).kinetic;
  EXPECT_NEAR(s.state().x[elements / 2].z(), sag, 1e-6) << "it does not hang over the support";
  Thrown out;
  double last = 0;
  d.run(
      1, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        double f = 0;
        for (const double n : normal.at(d.committed_kinematics())) f += n;
        out.most = std::max(out.most, f);
        out.impulse += 0.5 * (f + last) * i.h;
        out.made = std::max(out.made, (total() - before) / kinetic);
        ++out.steps;
        out.iterations += i.iterations;
        last = f;
        return true;
      });
  out.depth = s.line_volume_contact()->largest_penetration().depth;
  const Energy e = s.system().energy(d.committed_kinematics());
  out.audit = (e.kinetic + e.strain + e.potential + e.damping + e.friction - before) / kinetic;
  return out;
}

void print(double stiffness, const std::string& what, const Thrown& t) {
  std::printf(
      "thrown pipe, %.0e N/m², %s: reaction %.2f kN at most, impulse %.3f kN s, %.2f mm deep; energy made "
      "%.4f "
      "%%, not accounted for %.3f %% of the throw; %d steps, %.1f iterations\n",
      stiffness, what.c_str(), t.most / 1e3, t.impulse / 1e3, 1e3 * t.depth, 100 * t.made, 100 * t.audit,
      t.steps, t.iterations / t.steps);
}

// Fixed steps are divided at impacts and for a while afterwards.
TEST(LineThrow, ReactionDoesNotDependOnTheStep) {
  for (const double stiffness : {1e7, 1e8}) {
    const double period = 2 * M_PI * std::sqrt(kMass / stiffness);  // 26.7, 8.4 ms
    const Thrown fine = throw_pipe(stiffness, period / 48);
    print(stiffness, "T/48", fine);
    const auto expect = [&](const std::string& name, const Thrown& t) {
      print(stiffness, name, t);
      EXPECT_NEAR(t.most, fine.most, 0.01 * fine.most) << name;
      EXPECT_LT(t.made, 1e-3) << name;
      // Twenty periods after the impact steps increase, and damp the bending waves of the impact.
      EXPECT_LT(std::abs(t.audit), 3e-2) << name;
    };
    for (const double part : {3.0, 4.0, 6.0, 12.0}) {
      const std::string name = "T/" + std::to_string(static_cast<int>(part));
      expect("automatic, at most " + name, throw_pipe(stiffness, 0, period / part));
      expect("fixed, " + name, throw_pipe(stiffness, period / part));
    }
    expect("fixed, 2 T", throw_pipe(stiffness, 2 * period));
    expect("automatic", throw_pipe(stiffness, 0));
    const Thrown strict = throw_pipe(stiffness, period / 3, 0, false);
    print(stiffness, "fixed, T/3, not divided", strict);
    EXPECT_EQ(strict.steps, static_cast<int>(std::ceil(3 / period)));
    EXPECT_LT(strict.made, 1e-3);
  }
}

}  // namespace
}  // namespace hawser::test::line_contact_throw_test
