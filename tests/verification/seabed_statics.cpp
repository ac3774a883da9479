// Beams and cables on a seabed against closed forms: Winkler's foundation, an end lifted off, pull-out
// against friction.
#include "hawser/terms/bed_contact.hpp"
#include "support/rig.hpp"

namespace hawser::test::seabed_statics_test {
namespace {

// Contact of the axis: the line is so thin that its radius does not matter.
model::Case on_bed(const model::LineType& type, double length, int elements, const model::End& a,
                   const model::End& b, double stiffness) {
  model::LineType t = type;
  t.contact_diameter = 1e-9;
  model::Case c = one_line(t, length, elements, a, b);
  c.environment.gravity = 10;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = 50;
  bed.basis = model::StiffnessBasis::per_length;
  bed.normal_stiffness = stiffness;
  bed.smoothing = 0.01 * type.mass_per_length * 10 / stiffness;
  c.dynamics.enabled = false;
  return c;
}

// Values of a field at the nodes.
std::vector<double> values(Simulation& sim, const std::string& name) {
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources())
    if (f.name == name) {
      std::vector<double> out(sim.state().x.size() * static_cast<size_t>(f.components));
      f.fill(sim.state().at_rest(), out);
      return out;
    }
  return {};
}

// A long beam under a point load in its middle: Hetényi (1946), w0 = P lambda/(2 k), M0 = P/(4 lambda), in
// addition to the settlement by its weight.
TEST(SeabedStatics, InfiniteBeamUnderAPointLoad) {
  const double k = 1e5, P = 1e4, EI = 1e6, depth = -50;
  for (const int elements : {100, 400}) {
    model::Case c =
        on_bed(beam_type(1e9, EI, EI, 1000), 40, elements, {}, clamp({40, 0, depth - 0.1}, {1, 0, 0}), k);
    c.lines[0].start = model::Start::straight;
    model::PointLoad load;
    load.at = 20;
    load.force = Vec3(0, 0, -P);
    c.lines[0].point_loads.push_back(load);
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double w = depth - 0.1 - sim.state().x[static_cast<size_t>(elements / 2)].z();
    EXPECT_NEAR(w, 0.01988176822, 2e-3 * 0.01988);
    if (elements % 40) {
      printf("  %d elements: w0 %+.4f %%\n", elements, 100 * (w / 0.01988176822 - 1));
      continue;
    }
    const size_t metre = static_cast<size_t>(elements / 2 + elements / 40);
    const double at_1 = depth - 0.1 - sim.state().x[metre].z();
    const std::vector<double> moment = values(sim, "bending_moment");
    const double M0 = moment[static_cast<size_t>(elements / 2)];
    const double M1 = moment[metre];
    printf("  %d elements: w0 %+.4f %%, w(1 m) %+.4f %%, moment %+.4f %%, at 1 m %+.4f %%\n", elements,
           100 * (w / 0.01988176822 - 1), 100 * (at_1 / 0.0174894562 - 1), 100 * (M0 / 6287.167148 - 1),
           100 * (M1 / 2258.950988 - 1));
    EXPECT_NEAR(at_1, 0.0174894562, 2e-3 * 0.01749);
    EXPECT_NEAR(M0, 6287.167148, 2e-3 * 6287);
    EXPECT_NEAR(M1, 2258.950988, 2e-3 * 2259);
  }
}

// A long beam under a point load at its free end: Hetényi (1946), w0 = 2 P lambda/k, slope 2 P lambda²/k,
// largest moment -P exp(-pi/4) sin(pi/4)/lambda at pi/(4 lambda), in addition to the settlement by its
// weight.
TEST(SeabedStatics, HalfABeamUnderAPointLoadAtItsEnd) {
  const double k = 1e5, P = 1e4, EI = 1e6, level = -50.1;
  const int elements = 400;
  model::Case c = on_bed(beam_type(1e9, EI, EI, 1000), 40, elements, {}, clamp({40, 0, level}, {1, 0, 0}), k);
  c.environment.seabed.friction.axial = c.environment.seabed.friction.lateral = 0;
  c.lines[0].start = model::Start::straight;
  model::PointLoad load;
  load.at = 0;
  load.force = Vec3(0, 0, -P);
  c.lines[0].point_loads.push_back(load);
  Simulation sim(PETSC_COMM_SELF, c);
  sim.solve_statics();
  const double w = level - sim.state().x[0].z();
  const double slope = (sim.state().q[0] * Vec3::UnitX()).z();
  const std::vector<double> moment = values(sim, "bending_moment");
  const auto largest = std::max_element(moment.begin(), moment.end());
  const double at = 40.0 / elements * static_cast<double>(largest - moment.begin());
  printf("  w0 %+.4f %%, slope %+.4f %%, moment %+.4f %% at %.1f m\n", 100 * (w / 0.07952707287670506 - 1),
         100 * (slope / 0.03162277660168379 - 1), 100 * (*largest / 8107.853848579669 - 1), at);
  EXPECT_NEAR(w, 0.07952707287670506, 2e-3 * 0.0795);
  EXPECT_NEAR(slope, 0.03162277660168379, 2e-3 * 0.0316);
  EXPECT_NEAR(*largest, 8107.853848579669, 2e-3 * 8108);
  EXPECT_NEAR(at, 1.975171812535064, 0.1);
}

// The end of a heavy beam is lifted by 0.5 m: hanging length and force by matched solutions of beam and
// foundation without tension. These assume small deflections and are proportional to weight and lift; a tenth
// of both reduces the effect of large deflections to a hundredth.
TEST(SeabedStatics, EndLiftedOffAFoundationWithoutTension) {
  struct Row {
    double k, hanging, force, moment, touchdown_moment, largest_at, deepest;  // largest: m from touchdown
  };
  for (const Row& r :
       {Row{1e4, 5.850298262, 5161.217109, 13319.08102, 13081.6646, 0.6890811536, 0.127639357},
        {1e5, 7.905066548, 5209.966704, 13571.87653, 9940.094942, 2.695099844, 0.01781537201},
        {1e6, 9.041841992, 5228.027777, 13666.13722, 6393.547787, 3.813814215, 0.00278648708},
        {1e7, 9.669046428, 5232.158579, 13687.7417, 3844.7548, 4.43688785, 0.000462312554},
        {1e8, 10.01875571, 5232.984653, 13692.06419, 2240.261882, 4.785771057, 7.914311204e-05}})
    for (const double scale : {1.0, 0.1}) {
      const int elements = 600;
      const double top = -50 + 0.5 * scale;
      model::Case c =
          on_bed(beam_type(1e9, 1e6, 1e6, 100 * scale), 30, elements, anchor({0, 0, top}), {}, r.k);
      c.lines[0].start = model::Start::points;
      c.lines[0].points = {Vec3(0, 0, top), Vec3(10, 0, -50), Vec3(29.99, 0, -50)};
      c.environment.seabed.friction.axial = c.environment.seabed.friction.lateral = 0;
      Simulation sim(PETSC_COMM_SELF, c);
      sim.solve_statics();
      const double force = sim.system().reactions()[2] / scale;
      const auto& x = sim.state().x;
      const double h = 30.0 / elements;
      size_t i = 1;
      while (x[i].z() > -50) ++i;
      // Cubic through both nodes and their slopes.
      const double z0 = x[i - 1].z() + 50;
      const double z1 = x[i].z() + 50;
      const double s0 = h * (sim.state().q[i - 1] * Vec3::UnitX()).z();
      const double s1 = h * (sim.state().q[i] * Vec3::UnitX()).z();
      double part = 0;
      for (double high = 1; high - part > 1e-9;) {
        const double t = 0.5 * (part + high);
        const double u = 1 - t;
        const double z = u * u * (1 + 2 * t) * z0 + t * t * (3 - 2 * t) * z1 + t * u * (u * s0 - t * s1);
        (z > 0 ? part : high) = t;
      }
      const double hanging = h * (static_cast<double>(i - 1) + part);
      const std::vector<double> moments = values(sim, "bending_moment");
      const auto highest = std::max_element(moments.begin(), moments.end());
      const double moment = *highest / scale;
      const double there = (moments[i - 1] + part * (moments[i] - moments[i - 1])) / scale;
      const double at = hanging - h * static_cast<double>(highest - moments.begin());
      double deepest = 0;
      for (const Vec3& p : x) deepest = std::max(deepest, (-50 - p.z()) / scale);
      printf(
          "  k %g, lifted by %g m: hangs %+.4f %%, force %+.4f %%, moment %+.4f %%, at the touchdown %+.4f "
          "%%, deepest %+.4f %%\n",
          r.k, 0.5 * scale, 100 * (hanging / r.hanging - 1), 100 * (force / r.force - 1),
          100 * (moment / r.moment - 1), 100 * (there / r.touchdown_moment - 1),
          100 * (deepest / r.deepest - 1));
      EXPECT_NEAR(force, r.force, 2e-3 * r.force);
      EXPECT_NEAR(moment, r.moment, 2e-3 * r.moment);
      if (scale == 1) continue;
      EXPECT_NEAR(hanging, r.hanging, 2e-3 * r.hanging);
      EXPECT_NEAR(there, r.touchdown_moment, 2e-3 * r.touchdown_moment);
      EXPECT_NEAR(deepest, r.deepest, 2e-3 * r.deepest);
      EXPECT_NEAR(at, r.largest_at, h);
    }
}

// A long pipe pulled at its end against elastoplastic friction tau = mu w with mobilisation length d: elastic
// up to F = sqrt(EA tau d) at the end, above that a part slips. Closed form.
TEST(SeabedStatics, PullOut) {
  struct Row {
    double F, u, slips, tension;  // N; m; m, length that slips; N, 50 m from the end
  };
  for (const Row& r : {Row{17677.66953, 0.0025, 0, 8716.305381908778},
                       {35355.33906, 0.005, 0, 17432.610763817556},
                       {50000, 0.0075, 29.289321881345256, 26378.682326731465},
                       {100000, 0.0225, 129.28932188134524, 75000},
                       {200000, 0.0825, 329.28932188134524, 175000},
                       {400000, 0.3225, 729.2893218813452, 375000}}) {
    model::LineType t = cable_type(5e8, 100);
    model::Case c = on_bed(t, 1200, 1200, {}, {}, 1e6);
    c.environment.seabed.friction.axial = c.environment.seabed.friction.lateral = 0.5;
    c.environment.seabed.friction.mobilisation_length = 0.005;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {Vec3(0, 0, -50.001), Vec3(1200, 0, -50.001)};
    model::PointLoad load;
    load.at = 1200;
    load.force = Vec3(r.F, 0, 0);
    c.lines[0].point_loads.push_back(load);
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double u = sim.state().x[1200].x() - 1200;
    const auto moved = [&](int n) { return sim.state().x[static_cast<size_t>(n)].x() - n; };
    int sliding = 0;
    while (sliding < 1200 && moved(1200 - sliding) > 0.005) ++sliding;
    const double slip =
        sliding == 0
            ? 0
            : sliding - 1 + (moved(1201 - sliding) - 0.005) / (moved(1201 - sliding) - moved(1200 - sliding));
    const double tension = values(sim, "effective_tension")[1150];
    printf("  F %g N: u %.6f of %.6f m, %.3f of %.3f m slip, tension %+.3f %%\n", r.F, u, r.u, slip, r.slips,
           100 * (tension / r.tension - 1));
    EXPECT_NEAR(u, r.u, 5e-3 * r.u) << r.F;
    EXPECT_NEAR(slip, r.slips, 5e-3 * std::max(r.slips, 1.0)) << r.F;
    EXPECT_NEAR(tension, r.tension, 5e-3 * r.tension) << r.F;
  }
}

// A pipe laid cold and heated by 60 K (1.17e-5/K); friction of 500 N/m mobilised at 5 mm holds its middle.
// Closed form: slipping length, expansion of the ends, and force in the middle. The model is one half, held
// in the middle.
TEST(SeabedStatics, Heating) {
  struct Row {
    double length, slip, end, force;
  };
  for (const Row& r : {Row{600, 287.80890488030343, 0.1656248683617732, -146944.69911537858},
                       {2000, 631.2851402664203, 0.2489017043064301, -350615.49150208966},
                       {4000, 631.2893218813451, 0.2489020, -350999.99972262495}}) {
    const double half = r.length / 2;
    const int elements = static_cast<int>(half / 2);
    model::LineType t = beam_type(5e8, 1e7, 1e7, 100);
    t.thermal_expansion = 1.17e-5;
    model::Case c = on_bed(t, half, elements, clamp({0, 0, -50.001}, {1, 0, 0}), {}, 1e6);
    model::Friction& f = c.environment.seabed.friction;
    f.axial = f.lateral = 0.5;
    f.mobilisation_length = 0.005;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {Vec3(0, 0, -50.001), Vec3(half, 0, -50.001)};
    c.lines[0].temperature_change = {{0, 60}};
    Simulation sim(PETSC_COMM_SELF, c);
    const std::vector<Vec3> before = sim.state().x;
    sim.solve_statics();
    const auto moved = [&](int n) {
      return sim.state().x[static_cast<size_t>(n)].x() - before[static_cast<size_t>(n)].x();
    };
    int n = elements;
    while (moved(n - 1) > 0.005) --n;
    const double sticks = n - (moved(n) - 0.005) / (moved(n) - moved(n - 1));
    const double slip = half * (1 - sticks / elements);
    const double end = moved(elements);
    const double force = values(sim, "effective_tension")[0];
    printf("  %g m: %+.3f %% slip, end %+.3f %%, force in the middle %+.3f %%\n", r.length,
           100 * (slip / r.slip - 1), 100 * (end / r.end - 1), 100 * (force / r.force - 1));
    EXPECT_NEAR(end, r.end, 5e-3 * r.end);
    EXPECT_NEAR(force, r.force, -5e-3 * r.force);
    EXPECT_NEAR(slip, r.slip, 5e-3 * r.slip);
  }
}

// Slow pull by 0.08 m, release and push: F²/(2 tau EA) in loading, F1 less the root of 4 tau EA (u1 - u) in
// unloading (Masing's rule); half of the displacement remains at zero force. Rigid-plastic closed form; the
// mobilisation length of 0.02 mm matters only at the reversal.
TEST(SeabedStatics, PullingUnloadingPushing) {
  const double EA = 5e8, tau = 500, far = 0.08, length = 500;
  constexpr size_t kElements = 1000;
  model::End b;
  b.kind = model::EndKind::body;
  b.carrier = "hand";
  b.clamped = true;
  b.direction = Vec3::UnitX();
  model::Case c = on_bed(beam_type(EA, 1e7, 1e7, 100), length, static_cast<int>(kElements), {}, b, 1e6);
  model::Body hand;
  hand.name = "hand";
  hand.position = Vec3(length, 0, -50.001);
  model::HarmonicMotion m;
  m.amplitude = Vec3(far, 0, 0);
  m.period = 80;
  hand.motion = m;
  hand.ramp = 8;
  c.bodies.push_back(hand);
  model::Friction& f = c.environment.seabed.friction;
  f.axial = f.lateral = tau / 1000;
  f.mobilisation_length = 2e-5;
  c.lines[0].start = model::Start::straight;
  c.dynamics.enabled = true;
  c.dynamics.duration = 60;
  c.dynamics.step = 0.1;
  Simulation sim(PETSC_COMM_SELF, c);
  sim.solve_statics();
  sim.dynamics().start(sim.state());
  const double most = std::sqrt(2 * tau * EA * far);
  double off = 0, left = 0, last_u = 0, last_F = 0;
  sim.dynamics().run(
      60, [](double) { return 60.0; },
      [&](const StepInfo& info) {
        const double u = sim.dynamics().committed_kinematics().x[kElements].x() - length;
        const double F = sim.dynamics().reactions()[3 * 2 * kElements];
        if (info.time > 20.05) {
          if (last_F > 0 && F <= 0) left = last_u + (u - last_u) * last_F / (last_F - F);
          if (u < far - 0.01) off = std::max(off, std::abs(F - (most - std::sqrt(4 * tau * EA * (far - u)))));
        } else if (u > 0.01) {
          off = std::max(off, std::abs(F - std::sqrt(2 * tau * EA * u)));
        }
        last_u = u;
        last_F = F;
        return true;
      });
  printf("  force within %.3f %% of %g N, %.5f of %.5f m left at no force\n", 100 * off / most, most, left,
         far / 2);
  EXPECT_LT(off, 5e-3 * most);
  EXPECT_NEAR(left, far / 2, 5e-3 * far / 2);
}

}  // namespace
}  // namespace hawser::test::seabed_statics_test
