// Multipliers in motion without impacts, and what they make of one: a pipe and a cable that lie on a plane,
// that are dragged over it, that slide on a drum, and that fall. On one rank and on two.
#include "verification/contact_models.hpp"

namespace hawser::test::contact_models_motion_test {
namespace {

constexpr double kRadius = 0.1, kWeight = 100 * 9.81;  // m, N/m
constexpr double kFriction = 0.3;

double sum(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}
double most(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return x;
}

enum class Way { augmented, rigid };

struct Options {
  bool beam = true;
  Way way = Way::augmented;
  int elements = 10;
  double rho = 0.8, step = 0;  // s; 0: automatic
  double damping = 0;          // s, of the stiffness

  std::string name() const {
    return std::string(beam ? "beam" : "cable") + (way == Way::rigid ? ", rigid, " : ", augmented, ") +
           std::to_string(elements) + " elements, rho " + std::to_string(rho) + ", step " +
           std::to_string(step) + ", damping " + std::to_string(damping);
  }
};

model::Case lying(const Options& run, double height, model::End a, model::End b) {
  model::LineType type = run.beam ? beam_type(1e9, 1e6, 1e6, 100) : cable_type(1e9, 100);
  type.outer_diameter = type.contact_diameter = 2 * kRadius;
  type.stiffness_damping = run.damping;
  if (run.beam) type.rotary_inertia = Vec3(1, 0.5, 0.5);
  model::Case c = one_line(type, 10, run.elements, std::move(a), std::move(b));
  c.environment.gravity = 9.81;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{0, 0, kRadius + height}, {10, 0, kRadius + height}};
  model::Volume plane;
  plane.name = "plane";
  plane.basis = model::StiffnessBasis::per_length;
  plane.normal_stiffness = 2e7;
  c.volumes.push_back(plane);
  c.contact.method = run.way == Way::rigid ? model::ContactMethod::rigid : model::ContactMethod::nodes;
  c.contact.augmented = run.way == Way::augmented;
  c.dynamics.enabled = true;
  c.dynamics.step = run.step;
  c.dynamics.rho_infinity = run.rho;
  return c;
}

std::shared_ptr<const Surface> ground() {
  return std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
}

struct Seen {
  double off = 0, speed = 0;       // m, m/s, of any node along the normal
  double made = -1e300, left = 0;  // J, largest energy not brought in, and the last
  double rise = -1e300;            // J, the same of kinetic, strain and potential energy alone
  double press = 0, drag = 0;      // N, at the end
  double impulse = 0;              // N s
};

Seen watch(Simulation& s, double duration, double height) {
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Seen out;
  const auto energy = [&] {
    const Energy e = s.system().energy(d.kinematics());
    return sum(e.kinetic + e.strain + e.potential - e.work - d.support_work());
  };
  const auto lost = [&] {
    const Energy e = s.system().energy(d.kinematics());
    return sum(e.friction + e.damping);
  };
  const double before = energy();
  NodeField press(s, "contact_normal_force"), drag(s, "friction_force");
  d.run(
      duration, [=](double t) { return t < duration * (1 - 1e-9) ? duration : t + 100; },
      [&](const StepInfo& step) {
        for (const double f : press.at(d.kinematics())) out.impulse += f * step.h;
        const State& now = d.committed().s;
        for (size_t n = 0; n < static_cast<size_t>(s.local().owned); ++n) {
          out.off = std::max(out.off, std::abs(now.x[n].z() - kRadius - height));
          out.speed = std::max(out.speed, std::abs(now.v[n].z()));
        }
        const double now_there = energy() - before;
        out.rise = std::max(out.rise, now_there);
        out.left = now_there + lost();
        out.made = std::max(out.made, out.left);
        return true;
      });
  for (const double f : press.at(d.kinematics())) out.press += f;
  const std::vector<double>& f = drag.at(d.kinematics());
  for (size_t i = 0; i < f.size(); i += 3) out.drag -= f[i];
  out.press = sum(out.press), out.drag = sum(out.drag), out.impulse = sum(out.impulse);
  out.off = most(out.off), out.speed = most(out.speed);
  return out;
}

// All that the options allow, in turn.
template <class F>
void for_runs(const std::vector<int>& elements, const std::vector<double>& rhos,
              const std::vector<double>& steps, F&& run) {
  for (const bool beam : {true, false})
    for (const Way way : {Way::augmented, Way::rigid})
      for (const int n : elements)
        for (const double rho : rhos)
          for (const double step : steps) run(Options{beam, way, n, rho, step});
}

// What lies in equilibrium stays as it lies, also as deep as statics was allowed to leave it: at its own
// steps and at given ones, with all damping of high frequencies and with none.
TEST(ContactModelsMotion, WhatLiesStays) {
  Seen worst;
  for_runs({4, 10, 20}, {0, 0.4, 0.8, 1}, {0, 0.02, 0.004, 0.001}, [&](const Options& run) {
    model::Case c = lying(run, 0, anchor({0, 0, kRadius}), anchor({10, 0, kRadius}));
    // A slack cable has nothing that keeps rounding small sideways, on springs neither.
    if (!run.beam) c.lines[0].sections[0].length = 9.999;
    c.contact.allowed_penetration = 1e-5;
    Simulation s(PETSC_COMM_WORLD, c, {ground()});
    s.solve_statics();
    const Seen seen = watch(s, run.step == 0.001 ? 0.1 : 0.5, 0);
    EXPECT_LT(seen.off, 1.1e-5) << run.name();
    EXPECT_LT(seen.speed, 1e-8) << run.name();
    EXPECT_LT(std::abs(seen.left), 1e-9 * kWeight * 10 * kRadius) << run.name();
    EXPECT_GT(seen.press, 0.7 * kWeight * 10) << run.name();
    worst.off = std::max(worst.off, seen.off), worst.speed = std::max(worst.speed, seen.speed);
    worst.left = std::max(worst.left, std::abs(seen.left));
  });
  std::printf("lying: %.1e m off, %.1e m/s, %.1e J\n", worst.off, worst.speed, worst.left);
}

// Dampers feel the speeds that it has, not those of a try: none.
TEST(ContactModelsMotion, WhatLiesStaysWithDampers) {
  Seen worst;
  for (const double damping : {0.001, 0.1})
    for_runs({10}, {0, 0.4, 0.8, 1}, {0, 0.02, 0.002}, [&](Options run) {
      run.damping = damping;
      if (!run.beam) return;
      Simulation s(PETSC_COMM_WORLD, lying(run, 0, anchor({0, 0, kRadius}), anchor({10, 0, kRadius})),
                   {ground()});
      s.solve_statics();
      const Seen seen = watch(s, run.step == 0.002 ? 0.1 : 0.5, 0);
      EXPECT_LT(seen.speed, 1e-8) << run.name();
      EXPECT_LT(std::abs(seen.left), 1e-9 * kWeight * 10 * kRadius) << run.name();
      worst.speed = std::max(worst.speed, seen.speed), worst.left = std::max(worst.left, std::abs(seen.left));
    });
  std::printf("lying, damped: %.1e m/s, %.1e J\n", worst.speed, worst.left);
}

// Drawn by one end at 0.1 m/s: friction is mu N, and no energy is made.
TEST(ContactModelsMotion, WhatIsDraggedSlides) {
  Seen worst;
  for_runs({10}, {0, 0.8, 1}, {0, 0.02, 0.001}, [&](const Options& run) {
    model::End end = anchor(Vec3::Zero());
    end.kind = model::EndKind::body, end.body = "boat";
    model::Case c = lying(run, 0, {}, end);
    model::Body boat;
    boat.name = "boat";
    boat.position = Vec3(10, 0, kRadius);
    boat.motion = model::ConstantMotion{Vec3(0.1, 0, 0)};
    boat.ramp = 0.2;
    c.bodies.push_back(boat);
    c.volumes[0].friction.axial = c.volumes[0].friction.lateral = kFriction;
    Simulation s(PETSC_COMM_WORLD, c, {ground()});
    const double duration = run.step == 0.001 ? 0.4 : 1;
    const Seen seen = watch(s, duration, 0);
    EXPECT_LT(seen.off, 1e-8 * kRadius) << run.name();
    EXPECT_NEAR(seen.drag, kFriction * seen.press, 1e-3 * kFriction * seen.press) << run.name();
    EXPECT_LT(seen.made, 5e-3 * kFriction * kWeight * 10 * 0.1 * duration) << run.name();
    worst.made = std::max(worst.made, seen.made), worst.drag = std::min(worst.drag, seen.left);
  });
  std::printf("dragged: at most %.1e J made, at most %.1e J lost\n", worst.made, -worst.drag);
}

// What falls makes no energy, level or with one end first: kinetic, strain and potential energy together are
// never above what they were. What is booked as lost may be more than was, the more so the stronger the
// scheme damps and the longer the steps.
TEST(ContactModelsMotion, WhatFallsMakesNone) {
  const std::vector<double> rhos = {0, 0.4, 0.8, 1};
  for (const double tilt : {0.0, 0.05})
    for (const double rho : rhos) {
      double rise = 0, made = 0;
      for_runs({10}, {rho}, {0, 0.01, 0.002}, [&](const Options& run) {
        model::Case c = lying(run, 0.05, {}, {});
        c.lines[0].points[1].z() += tilt;
        c.lines[0].sections[0].length = path_length(c.lines[0].points);
        Simulation s(PETSC_COMM_WORLD, c, {ground()});
        const Seen seen = watch(s, 0.5, 0);
        const double fallen = kWeight * 10 * (0.05 + 0.5 * tilt);
        // The force that is told is all of the impulse: a cable that fell level lies still.
        if (!run.beam && tilt == 0) {
          EXPECT_NEAR(seen.impulse, kWeight * 10 * 0.5, 1e-9 * kWeight * 10) << run.name();
        }
        EXPECT_LT(seen.rise, 1e-12 * fallen) << run.name();
        EXPECT_LT(seen.made, (rho < 0.8 ? 0.12 : 2e-3) * fallen) << run.name();
        rise = std::max(rise, seen.rise / fallen), made = std::max(made, seen.made / fallen);
      });
      std::printf("fallen, %g m higher at one end, rho %g: %.1e of the fall made, %.1e booked beyond it\n",
                  tilt, rho, rise, made);
    }
}

// A bar that runs end-on into a plane: what is held stops its node alone, and the rest follows in waves.
TEST(ContactModelsMotion, BarOnAPlaneMakesNone) {
  for (const double rho : {0.0, 0.4, 0.8, 1.0}) {
    double rise = 0, made = 0;
    for_runs({10, 40}, {rho}, {0, 2e-3, 2e-4}, [&](const Options& run) {
      if (!run.beam) return;
      model::Case c = lying(run, 0, {}, {});
      c.lines[0].points = {{0, 0, kRadius + 0.05}, {0, 0, kRadius + 10.05}};
      Simulation s(PETSC_COMM_WORLD, c, {ground()});
      const Seen seen = watch(s, 0.15, 0);
      const double fallen = kWeight * 10 * 0.05;
      EXPECT_LT(seen.rise, 1e-11 * fallen) << run.name();
      EXPECT_LT(seen.made, (rho < 0.8 ? 5 : 1e-10) * fallen) << run.name();
      rise = std::max(rise, seen.rise / fallen), made = std::max(made, seen.made / fallen);
    });
    std::printf("end-on, rho %g: %.1e of the fall made, %.1e booked beyond it\n", rho, rise, made);
  }
}

// Along a curved surface what is held neither wins nor loses: a cable slides over the top of a drum.
TEST(ContactModelsMotion, WhatSlidesOverADrumKeepsItsEnergy) {
  for (const Way way : {Way::augmented, Way::rigid})
    for (const double step : {0.01, 0.005}) {
      const Options run{false, way, 4, 0.8, step};
      model::Case c = lying(run, 0, {}, {});
      c.lines[0].points.clear();
      const double r = 2 + kRadius;
      for (int i = -2; i <= 2; ++i)
        c.lines[0].points.push_back(r * Vec3(std::sin(0.25 * i / r), 0, std::cos(0.25 * i / r)));
      c.lines[0].sections[0].length = path_length(c.lines[0].points);
      Simulation s(PETSC_COMM_WORLD, c,
                   {std::make_shared<CylinderSurface>(Vec3(0, -1, 0), Vec3(0, 1, 0), 2)});
      State start = s.state();
      for (size_t n = 0; n < start.x.size(); ++n)
        start.v[n] = 1.0 * Vec3(start.x[n].z(), 0, -start.x[n].x()) / r;
      Dynamics& d = s.dynamics();
      d.start(start);
      const auto energy = [&] {
        const Energy e = s.system().energy(d.kinematics());
        return sum(e.kinetic + e.strain + e.potential);
      };
      const double before = energy();
      d.run(
          0.5, [](double t) { return t + 100; }, [](const StepInfo&) { return true; });
      std::printf("over a drum, %s: %.1e J of 50\n", run.name().c_str(), energy() - before);
      EXPECT_LT(std::abs(energy() - before), 50 * 10 * step * step) << run.name();
    }
}

// Between two jaws that close on it a line is let in: no multiplier can keep it out of both, and what is
// told and booked is what the springs do, not the blows of stops that cannot stop it.
TEST(ContactModelsMotion, WhatIsPinchedPressesAsItsSprings) {
  constexpr double kClosing = 0.01, kRoom = 2.2e-4;  // m/s of each, m on either side
  for (const double gravity : {0.0, 9.81})
    for_runs({4}, {0.8}, {5e-3}, [&](const Options& run) {
      model::Case c = lying(run, 0, {}, {});
      c.environment.gravity = gravity;
      c.volumes.push_back(c.volumes[0]);
      c.bodies.resize(2);
      for (const size_t i : {0u, 1u}) {
        const double side = i == 0 ? -1 : 1;
        c.volumes[i].name = c.volumes[i].body = c.bodies[i].name = i == 0 ? "lower" : "upper";
        c.bodies[i].position = Vec3(0, 0, kRadius + side * (kRadius + kRoom));
        model::TableMotion closing;
        for (const double t : {0.0, 0.1, 0.2}) {
          closing.time.push_back(t);
          closing.offset.push_back({0, 0, -side * kClosing * t});
        }
        c.bodies[i].motion = closing;
      }
      Simulation s(PETSC_COMM_WORLD, c,
                   {ground(), std::make_shared<PlaneSurface>(Vec3::Zero(), -Vec3::UnitZ())});
      const double duration = 0.1, depth = kClosing * duration - kRoom, force = 2e7 * depth * 10;
      const Seen seen = watch(s, duration, 0);
      EXPECT_NEAR(seen.press, 2 * force, 1e-6 * force) << run.name();
      EXPECT_LT(std::abs(seen.left), force * depth) << run.name();
    });
}

}  // namespace
}  // namespace hawser::test::contact_models_motion_test
