// Friction in whole runs against closed forms: a block on an incline, a line dragged over a plane in any
// direction, mobilisation of a rope round a drum.
#include "verification/contact_rig.hpp"

namespace hawser::test::friction_runs_test {
namespace {

constexpr double kGravity = 9.81, kRadius = 0.05;

model::Case on_plane(model::ContactMethod method, double length, int elements,
                     const model::Friction& friction) {
  model::LineType type = beam_type(1e8, 1e5, 1e5, 50);
  type.outer_diameter = type.contact_diameter = 2 * kRadius;
  model::Case c = one_line(type, length, elements, {}, {});
  c.environment.gravity = kGravity;
  c.lines[0].start = model::Start::points;
  model::Volume plane;
  plane.name = "plane";
  plane.basis = model::StiffnessBasis::per_length;
  plane.normal_stiffness = 1e6;
  plane.relative_damping = 0.3;
  plane.friction = friction;
  c.volumes.push_back(plane);
  c.contact.method = method;
  c.dynamics.enabled = true;
  return c;
}

// The plane under a block tilts to an angle within 10 s (quintic) and then stands. Returns the displacement
// of the block along the slope in the following 10 s.
double slides_by(model::ContactMethod method, double mu, double angle, bool across) {
  model::Friction friction;
  friction.axial = friction.lateral = mu;
  friction.mobilisation_length = 1e-4;
  model::Case c = on_plane(method, 1, 1, friction);
  const double sinkage = 50 * kGravity / 1e6;
  const Vec3 along = across ? Vec3::UnitY() : Vec3::UnitX();
  c.lines[0].points = {-0.5 * along + Vec3(0, 0, kRadius - sinkage),
                       0.5 * along + Vec3(0, 0, kRadius - sinkage)};
  model::Body slope;
  slope.name = "slope";
  model::TableMotion tip;
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.1 * i;
    const double s = std::min(t / 10, 1.0);
    const double smooth = s * s * s * (10 - 15 * s + 6 * s * s);
    tip.time.push_back(t);
    tip.offset.push_back(Vec3::Zero());
    tip.rotation.push_back(Vec3(0, angle * smooth, 0));
  }
  slope.motion = tip;
  c.bodies.push_back(slope);
  c.volumes[0].body = "slope";
  c.dynamics.step = 0.01;
  Simulation s(PETSC_COMM_WORLD, c, {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ())});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto where = [&] {
    return s.bodies().pose(0, d.committed().s.time).to_body(d.committed().s.x[0]).x();
  };
  double from = 0;
  d.run(
      20, [](double t) { return t < 10 - 1e-9 ? 10.0 : 20.0; },
      [&](const StepInfo& i) {
        if (std::abs(i.time - 10) < 1e-6) from = where();
        return true;
      });
  return where() - from;
}

TEST(FrictionRuns, BlockOnAnIncline) {
  for (const auto method : {model::ContactMethod::nodes, model::ContactMethod::line})
    for (const bool across : {false, true}) {
      const double mu = 0.3;
      const double limit = std::atan(mu);
      const double below = slides_by(method, mu, 0.999 * limit, across);
      const double above = slides_by(method, mu, 1.001 * limit, across);
      // Sliding: g (sin a - mu cos a) t²/2.
      const double free = kGravity * (std::sin(1.001 * limit) - mu * std::cos(1.001 * limit)) * 100 / 2;
      std::printf(
          "incline, %s, block %s the slope: 0.1 %% below atan(mu) it moves by %.1e m, 0.1 %% above by %.4f m "
          "(uniformly accelerated %.4f)\n",
          method == model::ContactMethod::line ? "line" : "nodes", across ? "across" : "along", below, above,
          free);
      EXPECT_LT(std::abs(below), 2e-5);
      EXPECT_GT(above, 0.9 * free);
      EXPECT_LT(above, 1.2 * free);
    }
}

struct Dragged {
  Vec3 force = Vec3::Zero();  // of friction on the line, N
  double normal = 0;          // N
};

// Both ends move with a body at constant speed; the middle is free.
Dragged drag(model::ContactMethod method, const model::Friction& friction, double direction) {
  model::Case c = on_plane(method, 4, 8, friction);
  const double sinkage = 50 * kGravity / 1e6;
  const double z = kRadius - sinkage;
  c.lines[0].points = {{-2, 0, z}, {2, 0, z}};
  model::Body tug;
  tug.name = "tug";
  tug.position = Vec3(0, 0, z);
  tug.motion =
      model::ConstantMotion{0.2 * Vec3(std::cos(direction), std::sin(direction), 0), Vec3::UnitZ(), 0};
  tug.ramp = 0.5;
  c.bodies.push_back(tug);
  for (model::End* e : {&c.lines[0].end_a, &c.lines[0].end_b}) {
    e->kind = model::EndKind::body;
    e->carrier = "tug";
    e->at = Vec3(e == &c.lines[0].end_a ? -2 : 2, 0, 0);
    e->clamped = true;
    e->direction = Vec3::UnitX();
  }
  c.line_types[0].EI2 = c.line_types[0].EI3 = 1e8;  // stays straight
  c.line_types[0].stiffness_damping = 1e-3;
  c.dynamics.step = 0.01;
  Simulation s(PETSC_COMM_WORLD, c, {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ())});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  d.run(
      1.5, [](double t) { return t + 100; }, [](const StepInfo&) { return true; });
  Dragged out;
  NodeField tangential(s, "friction_force");
  NodeField normal(s, "contact_normal_force");
  const auto& f = tangential.at(d.committed_kinematics());
  for (size_t i = 0; i < f.size(); i += 3) out.force += Vec3(f[i], f[i + 1], f[i + 2]);
  for (const double n : normal.at(d.committed_kinematics())) out.normal += n;
  return out;
}

TEST(FrictionRuns, EllipseIsTraced) {
  const double mu_a = 0.3, mu_l = 0.8;
  model::Friction springs{mu_a, mu_l, 0, 1e6};
  model::Friction lengths{mu_a, mu_l, 0.002, 0};
  model::Friction paper = lengths;
  lengths.lateral_mobilisation_length = 0.008;
  paper.lateral_mobilisation_length = 0.008;
  paper.spring = FrictionSpring::michalopoulos;
  model::Friction nearest = springs;
  model::Friction nearest_by_length = lengths;
  nearest.return_rule = nearest_by_length.return_rule = FrictionReturn::associated;
  struct Row {
    const char* name;
    model::Friction friction;
    int rule;  // direction of the force for the direction (c, s) of sliding
  };
  for (const auto method : {model::ContactMethod::nodes, model::ContactMethod::line})
    for (const Row& row : {Row{"springs, radial", springs, 0}, Row{"lengths, radial", lengths, 1},
                           Row{"michalopoulos", paper, 2}, Row{"springs, associated", nearest, 3},
                           Row{"lengths, associated", nearest_by_length, 3}}) {
      double worst = 0, worst_direction = 0;
      for (int i = 0; i < 8; ++i) {
        const double a = (i + 0.2) * 2 * M_PI / 8;
        const double co = std::cos(a);
        const double si = std::sin(a);
        const Dragged g = drag(method, row.friction, a);
        const double x = g.force.x() / (mu_a * g.normal);
        const double y = g.force.y() / (mu_l * g.normal);
        worst = std::max(worst, std::abs(std::hypot(x, y) - 1));
        // radial: the force is along the direction of sliding; associated: along the normal of the ellipse.
        Vec3 e;
        switch (row.rule) {
          case 0:
            e = Vec3(co, si, 0);
            break;
          case 1:
            e = Vec3(mu_a / 0.002 * co, mu_l / 0.008 * si, 0);
            break;
          case 2:
            e = Vec3(mu_a * co, mu_l * si, 0);
            break;
          default:
            e = Vec3(mu_a * mu_a * co, mu_l * mu_l * si, 0);
        }
        worst_direction = std::max(worst_direction, (e.normalized() + g.force.normalized()).norm());
        EXPECT_NEAR(g.normal, 4 * 50 * kGravity * (method == model::ContactMethod::nodes ? 7.0 / 8 : 1),
                    0.02 * 2000);
      }
      std::printf("dragged, %s, %s: off the ellipse by %.1e, off the direction by %.1e rad\n",
                  method == model::ContactMethod::line ? "line" : "nodes", row.name, worst, worst_direction);
      EXPECT_LT(worst, 1e-9) << row.name;
      EXPECT_LT(worst_direction, 1e-5) << row.name;
    }
}

// C02: dT/ds = mu T/R min(u/d, 1), du/ds = (T - T1)/EA from T1 and u0 at the loaded side; quasi-static.
TEST(FrictionRuns, CapstanMobilisation) {
  constexpr double rho = 1, T1 = 1000, EA = 1e5, mu = 0.3, d = 0.002, wrap = M_PI, leg = 0.3;
  const auto reference = [&](double u0, double& T2, double& delta) {
    double T = T1;
    double u = u0;
    const int n = 20000;
    const double h = wrap * rho / n;
    const auto dT = [&](double t, double s) { return mu * t / rho * std::min(s / d, 1.0); };
    const auto du = [&](double t) { return (t - T1) / EA; };
    for (int i = 0; i < n; ++i) {
      const double a1 = dT(T, u);
      const double b1 = du(T);
      const double a2 = dT(T + h / 2 * a1, u + h / 2 * b1);
      const double b2 = du(T + h / 2 * a1);
      const double a3 = dT(T + h / 2 * a2, u + h / 2 * b2);
      const double b3 = du(T + h / 2 * a2);
      const double a4 = dT(T + h * a3, u + h * b3);
      const double b4 = du(T + h * a3);
      T += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      u += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
    }
    T2 = T;
    delta = u;
  };
  double T2 = 0, delta = 0;
  reference(5e-4, T2, delta);  // a row of an independent solution (DOP853, 1e-12)
  EXPECT_NEAR(T2, 1973.279137, 0.1);
  EXPECT_NEAR(delta, 0.01084858139, 1e-6);

  for (const auto method : {model::ContactMethod::line, model::ContactMethod::nodes}) {
    const std::vector<Vec3> path = capstan_path(rho, wrap, leg, leg);
    const double length = path_length(path);
    model::LineType type = cable_type(EA, 1);
    type.outer_diameter = type.contact_diameter = 0.02;
    type.stiffness_damping = 2e-3;
    const int elements = 120;
    model::Case c = one_line(type, length / (1 + T1 / EA), elements, {}, {});
    model::Line& line = c.lines[0];
    line.start = model::Start::points;
    line.points = path;
    const double h = length / (1 + T1 / EA) / elements;
    line.loads.push_back({-T1 / h * along_circle(0), 0, h, 0, 0});
    model::Body hook;
    hook.name = "hook";
    hook.position = path.back();
    hook.ramp = 1;
    hook.motion = model::ConstantMotion{0.003 * along_circle(wrap), Vec3::UnitZ(), 0};
    c.bodies = {hook};
    line.end_b.kind = model::EndKind::body;
    line.end_b.carrier = "hook";
    model::Volume drum;
    drum.name = "drum";
    drum.basis = model::StiffnessBasis::per_length;
    drum.normal_stiffness = 1e8;
    drum.smoothing = 1e-6;
    drum.relative_damping = 0.1;
    drum.friction.axial = drum.friction.lateral = mu;
    drum.friction.mobilisation_length = d;
    drum.friction.spring = FrictionSpring::michalopoulos;  // the spring of C02 follows the normal force
    c.volumes.push_back(drum);
    c.contact.method = method;
    c.dynamics.enabled = true;
    c.dynamics.step = 0.01;
    Simulation s(PETSC_COMM_WORLD, c, {round_drum(rho - 0.01, 1)});
    s.solve_statics();
    Dynamics& dyn = s.dynamics();
    dyn.start(s.state());
    const Vec3 end = s.state().x.back();
    // Tension at the hook against the displacement of the rope where it leaves the drum.
    std::vector<std::pair<double, double>> path_of_run;
    dyn.run(
        11, [](double t) { return t + 100; },
        [&](const StepInfo&) {
          const double* r = dyn.reactions().data() + 3 * s.local().block.back();
          const double T = Vec3(r[0], r[1], r[2]).norm();
          path_of_run.emplace_back((dyn.committed().s.x.back() - end).norm() - (T - T1) / EA * leg, T);
          return true;
        });
    for (const double u0 : {1e-5, 1e-4, 5e-4, 1e-3, 1.5e-3, 2e-3, 3e-3}) {
      reference(u0, T2, delta);
      size_t i = 1;
      while (i + 1 < path_of_run.size() && path_of_run[i].first < delta) ++i;
      const auto [d0, t0] = path_of_run[i - 1];
      const auto [d1, t1] = path_of_run[i];
      const double T = t0 + (delta - d0) / (d1 - d0) * (t1 - t0);
      std::printf("mobilisation, %s: drawn %.3f mm, T2 %.2f N, reference %.2f (%+.3f %%)\n",
                  method == model::ContactMethod::line ? "line" : "nodes", 1e3 * delta, T, T2,
                  100 * (T / T2 - 1));
      EXPECT_NEAR(T, T2, 5e-3 * T2);
    }
  }
}

}  // namespace
}  // namespace hawser::test::friction_runs_test
