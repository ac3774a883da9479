// Axial and transverse waves end a contact while the nodes near it do not move, so the state at the start of
// the step does not announce the separation. The energy generated stays below a limit at all steps.
#include "verification/contact_rig.hpp"

namespace hawser::test::contact_parting_test {
namespace {

constexpr double kSpan = 100, kMass = 20, kPull = 2e5, kAxial = 1e8;  // m, kg/m, N, N
const double kWave = std::sqrt(kPull / kMass);                        // m/s
constexpr int kElements = 100;
constexpr double kStiffness = 2e8, kRadius = 0.05;  // N/m², m, of string and bar

enum class Bar { volume, line };

// The bar lies across, below the middle of the string, `depth` inside it.
struct Rig {
  model::Case c;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  Rig(Bar bar, const std::vector<Vec3>& shape, double depth, double step) {
    model::LineType type = cable_type(kAxial, kMass);
    type.outer_diameter = type.contact_diameter = 2 * kRadius;
    double length = 0;
    for (size_t i = 1; i < shape.size(); ++i) length += (shape[i] - shape[i - 1]).norm();
    c = one_line(type, length / (1 + kPull / kAxial), kElements, anchor(shape.front()), anchor(shape.back()));
    c.lines[0].start = model::Start::points;
    c.lines[0].points = shape;
    c.environment.gravity = 0;
    c.dynamics.step = step;
    const double z = depth - 2 * kRadius;
    if (bar == Bar::line) {
      model::LineType stiff = beam_type(1e10, 1e7, 1e7, 1000);
      stiff.name = "bar";
      stiff.contact_diameter = 2 * kRadius;
      c.line_types.push_back(stiff);
      model::Line l;
      l.name = "bar";
      l.sections.push_back({stiff.name, 1, 2, 1});
      l.end_a = clamp({kSpan / 2, -0.5, z}, Vec3::UnitY());
      l.end_b = clamp({kSpan / 2, 0.5, z}, Vec3::UnitY());
      c.lines.push_back(l);
      c.contact.between_lines.general.basis = model::StiffnessBasis::per_length;
      c.contact.between_lines.general.normal_stiffness = kStiffness;
      return;
    }
    model::Volume support;
    support.name = "bar";
    support.basis = model::StiffnessBasis::per_length;
    support.normal_stiffness = kStiffness;
    c.volumes.push_back(support);
    surfaces.push_back(
        std::make_shared<CylinderSurface>(Vec3(kSpan / 2, -1, z), Vec3(kSpan / 2, 1, z), kRadius));
  }
};

struct Course {
  double made = 0, lifted = 0;  // increase of energy from its least; s
  Samples reaction;             // N, between `from` and `to`
  int steps = 0, rejected = 0;
};

// Runs until `until` [s]. Energies are relative to the kinetic energy of the string at the speed `thrown`
// [m/s].
Course follow(Simulation& s, Bar bar, double thrown, double until, double from, double to) {
  Course out;
  Dynamics& d = s.dynamics();
  d.start(s.state());
  NodeField normal(s, bar == Bar::line ? "line_contact_normal_force" : "contact_normal_force");
  const Energy first = s.system().energy(d.committed_kinematics());
  const double energy = 0.5 * kMass * kSpan * thrown * thrown;
  double least = first.kinetic + first.strain;
  d.run(
      until, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        double f = 0;
        for (size_t n = 0; n <= kElements; ++n) f += normal.at(d.committed_kinematics())[n];
        if (i.time > from && i.time < to) out.reaction.add(f, i.h);
        if (f > 0) out.lifted = i.time;
        const Energy e = s.system().energy(d.committed_kinematics());
        out.made = std::max(out.made, (e.kinetic + e.strain - least) / energy);
        least = std::min(least, e.kinetic + e.strain);
        ++out.steps;
        out.rejected += i.rejected;
        return true;
      });
  return out;
}

// A string is thrown on a bar at 1 m/s: the reaction is 2 m c v until the waves from the held ends lift the
// string off, half a second later. The generated energy is below 0.1 %; reaction and time are printed.
TEST(ContactParting, StringThrownOnABar) {
  constexpr double speed = 1, plateau = 0.5;
  for (const double divided : {3.0, 4.0, 6.0, 12.0}) {
    const Rig rig(Bar::volume, {Vec3::Zero(), {kSpan, 0, 0}}, -1e-4, plateau / divided);
    Simulation s(PETSC_COMM_WORLD, rig.c, rig.surfaces);
    s.solve_statics();
    for (size_t n = 1; n + 1 < s.state().x.size(); ++n) s.state().v[n] = -speed * Vec3::UnitZ();
    const Course r = follow(s, Bar::volume, speed, 1, 0.1, 0.45);
    std::printf(
        "string thrown on a bar, steps of 1/%.0f of the contact (%d, %d rejected): reaction %+.2f %%, lifted "
        "off at %.3f s, energy made %.4f %%\n",
        divided, r.steps, r.rejected, 100 * (r.reaction.mean() / (2 * kMass * kWave * speed) - 1), r.lifted,
        100 * r.made);
    EXPECT_LT(r.made, 1e-3);
  }
}

// The string starts at rest in the shape in which a thrown string is at rest everywhere, pressed on the bar
// with 2 m c v. The waves of its corners lift it off a quarter of a second later.
TEST(ContactParting, StringReleased) {
  constexpr double speed = 2;
  const double down = speed * kSpan / 4 / kWave;
  const double force = 2 * kMass * kWave * speed;
  const double depth = std::pow(force / (4.0 / 3 * kStiffness * std::sqrt(4 * kRadius)), 2.0 / 3);
  for (const Bar bar : {Bar::volume, Bar::line})
    for (const double step : {0.03, 0.025, 0.02, 0.015, 0.01, 0.005}) {
      const Rig rig(
          bar,
          {{0, 0, 0}, {kSpan / 4, 0, -down}, {kSpan / 2, 0, 0}, {3 * kSpan / 4, 0, -down}, {kSpan, 0, 0}},
          depth, step);
      Simulation s(PETSC_COMM_WORLD, rig.c, rig.surfaces);
      const Course r = follow(s, bar, speed, 0.4, 0.05, 0.15);
      std::printf(
          "string released on a %s, steps of %g s (%d, %d rejected): reaction %+.2f %%, lifted off at "
          "%.3f s, energy made %.4f %%\n",
          bar == Bar::line ? "line" : "volume", step, r.steps, r.rejected,
          100 * (r.reaction.mean() / force - 1), r.lifted, 100 * r.made);
      // The start is out of balance: with steps of 0.03 s the first accelerations contain 0.1 % of the
      // energy, which falls with the square of the step (docs/theory/time-integration.md, "Cables").
      EXPECT_LT(r.made, std::max(1e-3, 1.2e-3 * std::pow(step / 0.03, 2)));
    }
}

// A free bar hits a wall end-on at 8 m/s. The wave from its free end separates it after 2 L/c, 51 ms. Returns
// the generated energy over the initial energy.
double bar_on_wall(model::ContactMethod method, double stiffness, double step) {
  model::LineType type = beam_type(5e7, 1e5, 1e5, 80);
  type.rotary_inertia = Vec3::Constant(0.4);
  type.outer_diameter = type.contact_diameter = 0.2;
  model::Case c = one_line(type, 20, 20, {}, {});
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {Vec3::Zero(), Vec3(20, 0, 0)};
  c.statics.enabled = false;
  c.dynamics.step = step;
  c.dynamics.max_step = 0.02;
  c.contact.method = method;
  model::Volume wall;
  wall.name = "wall";
  wall.basis = model::StiffnessBasis::per_point;
  wall.normal_stiffness = stiffness;
  c.volumes.push_back(wall);
  Simulation s(PETSC_COMM_SELF, c, {std::make_shared<PlaneSurface>(Vec3(-0.101, 0, 0), Vec3::UnitX())});
  for (Vec3& v : s.state().v) v = Vec3(-8, 0, 0);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto energy = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    return e.kinetic + e.strain;
  };
  const double first = energy();
  double least = first;
  double made = 0;
  d.run(
      0.3, [](double) { return 1e300; },
      [&](const StepInfo&) {
        made = std::max(made, (energy() - least) / first);
        least = std::min(least, energy());
        return true;
      });
  return made;
}

TEST(ContactParting, BarThrownOnAWall) {
  using model::ContactMethod;
  for (const double step : {0.0, 0.02, 0.01, 0.005}) {
    const double line = bar_on_wall(ContactMethod::line, 1e9, step);
    const double nodes = bar_on_wall(ContactMethod::nodes, 1e9, step);
    const double gap = bar_on_wall(ContactMethod::gap, 1e9, step);
    std::printf(
        "bar on a wall, steps of %g s: energy made %.3f %%, at the nodes %.3f %%, gap springs %.3f %%\n",
        step, 100 * line, 100 * nodes, 100 * gap);
    EXPECT_LT(line, 1e-3);
    EXPECT_LT(nodes, 2e-3);
    EXPECT_LT(gap, 2e-3);
  }
  // With a stiffer spring the wave arrives when steps are long again. (From 5e9 N/m on the whole compression
  // lies within the smoothing ramp and counts as separated: up to 4 % are generated, depending on the
  // vibration of the bar's end in such steps.)
  const double gap = bar_on_wall(ContactMethod::gap, 4e9, 0.01);
  std::printf("bar on a gap spring of 4e9 N/m, steps of 0.01 s: energy made %.3f %%\n", 100 * gap);
  EXPECT_LT(gap, 4e-3);
}

}  // namespace
}  // namespace hawser::test::contact_parting_test
