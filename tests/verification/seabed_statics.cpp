// Beams and cables lying on a seabed: Winkler's foundation, an end lifted off, pull-out against friction.
#include "hawser/terms/seabed.hpp"
#include "support/rig.hpp"

namespace hawser::test {
namespace {

// Of the axis: the line is so thin that its radius does not matter.
model::Case on_bed(const model::LineType& type, double length, int elements, const model::End& a,
                   const model::End& b, double stiffness) {
  model::LineType t = type;
  t.contact_diameter = 1e-9;
  model::Case c = one_line(t, length, elements, a, b);
  c.environment.gravity = 10;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true, bed.depth = 50;
  bed.basis = model::StiffnessBasis::per_length, bed.normal_stiffness = stiffness;
  bed.smoothing = 0.01 * type.mass_per_length * 10 / stiffness;
  c.dynamics.enabled = false;
  return c;
}

// A long beam under a point load in its middle: Hetényi (1946), w0 = P lambda/(2 k), M0 = P/(4 lambda), on
// top of what its weight presses it in.
TEST(SeabedStatics, InfiniteBeamUnderAPointLoad) {
  const double k = 1e5, P = 1e4, EI = 1e6, depth = -50;
  for (const int elements : {100, 200}) {
    model::Case c = on_bed(beam_type(1e9, EI, EI, 1000), 40, elements, anchor({0, 0, depth - 0.1}),
                           anchor({40, 0, depth - 0.1}), k);
    c.lines[0].start = model::Start::straight;
    model::PointLoad load;
    load.at = 20, load.force = Vec3(0, 0, -P);
    c.lines[0].point_loads.push_back(load);
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double w = depth - 0.1 - sim.state().x[static_cast<size_t>(elements / 2)].z();
    const double at_1 = depth - 0.1 - sim.state().x[static_cast<size_t>(elements / 2 + elements / 40)].z();
    printf("  %d elements: w0 %.8f m, w(1 m) %.8f m\n", elements, w, at_1);
    EXPECT_NEAR(w, 0.01988176822, 2e-3 * 0.01988);
    if (elements % 40 == 0) {
      EXPECT_NEAR(at_1, 0.0174894562, 2e-3 * 0.01749);
    }
  }
}

// The end of a heavy beam is lifted by 0.5 m: how much hangs, and the force, matched solutions of beam and
// foundation without tension.
TEST(SeabedStatics, EndLiftedOffAFoundationWithoutTension) {
  struct Row {
    double k, hanging, force, moment;
  };
  for (const Row& r : {Row{1e4, 5.850298262, 5161.217109, 13319.08102},
                       {1e5, 7.905066548, 5209.966704, 13571.87653},
                       {1e6, 9.041841992, 5228.027777, 13666.13722},
                       {1e7, 9.669046428, 5232.158579, 13687.7417}}) {
    const int elements = 300;
    model::Case c = on_bed(beam_type(1e9, 1e6, 1e6, 100), 30, elements, anchor({0, 0, -49.5}), {}, r.k);
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {Vec3(0, 0, -49.5), Vec3(10, 0, -50), Vec3(29.99, 0, -50)};
    c.environment.seabed.friction.axial = c.environment.seabed.friction.lateral = 0;
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double force = sim.system().reactions()[2];
    double hanging = 0, moment = 0;
    for (int n = 1; n <= elements; ++n)
      if (sim.seabed()->node_force(sim.state().view(0), n).z() > 0) {
        hanging = 30.0 / elements * n;
        break;
      }
    const FieldRegistry fields = sim.system().fields();
    for (const FieldSource& f : fields.sources())
      if (f.name == "bending_moment") {
        std::vector<double> values(static_cast<size_t>(elements) + 1);
        f.fill(sim.state().view(0), values);
        moment = *std::max_element(values.begin(), values.end());
      }
    printf("  k %g: hangs %.2f of %.4f m, force %+.4f %%, moment %+.4f %%\n", r.k, hanging, r.hanging,
           100 * (force / r.force - 1), 100 * (moment / r.moment - 1));
    EXPECT_NEAR(hanging, r.hanging, 0.11);
    EXPECT_NEAR(force, r.force, 2e-3 * r.force);
    EXPECT_NEAR(moment, r.moment, 2e-3 * r.moment);
  }
}

// A long pipe pulled at its end against elastoplastic friction tau = mu w with mobilisation length d: elastic
// up to F = sqrt(EA tau d) at the end, then a part of it slips. Closed form.
TEST(SeabedStatics, PullOut) {
  struct Row {
    double F, u;
  };
  for (const Row& r : {Row{17677.66953, 0.0025},
                       {35355.33906, 0.005},
                       {50000, 0.0075},
                       {100000, 0.0225},
                       {200000, 0.0825},
                       {400000, 0.3225}}) {
    model::LineType t = cable_type(5e8, 100);
    model::Case c = on_bed(t, 1200, 1200, {}, {}, 1e6);
    c.environment.seabed.friction.axial = c.environment.seabed.friction.lateral = 0.5;
    c.environment.seabed.friction.mobilisation_length = 0.005;
    c.statics.enabled = false;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {Vec3(0, 0, -50.001), Vec3(1200, 0, -50.001)};
    model::PointLoad load;
    load.at = 1200, load.force = Vec3(r.F, 0, 0);
    c.lines[0].point_loads.push_back(load);
    Simulation sim(PETSC_COMM_SELF, c);
    sim.seabed()->lay(PETSC_COMM_SELF, sim.state().view(0), {});
    StaticsSettings settings;
    settings.near = true;
    solve_statics(sim.system(), settings, sim.state());
    const double u = sim.state().x[1200].x() - 1200;
    printf("  F %g N: u %.6f of %.6f m\n", r.F, u, r.u);
    EXPECT_NEAR(u, r.u, 5e-3 * r.u) << r.F;
  }
}

}  // namespace
}  // namespace hawser::test
