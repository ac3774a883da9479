// Bend stiffeners, end springs, tables of tension and moment: closed forms.
#include <functional>

#include "hawser/model/check.hpp"
#include "support/rig.hpp"

namespace hawser::test::line_furniture_test {
namespace {

double integral(const std::function<double(double)>& f, double from, double to) {
  const int n = 20000;  // Simpson
  double sum = f(from) + f(to);
  for (int i = 1; i < n; ++i) sum += (i % 2 ? 4 : 2) * f(from + i * (to - from) / n);
  return sum * (to - from) / (3 * n);
}

model::Case cantilever(const model::LineType& t, double length, int elements, const model::End& a) {
  model::Case c = one_line(t, length, elements, a, {});
  c.lines[0].start = model::Start::straight;
  c.dynamics.enabled = false;
  return c;
}

void load(model::Case& c, const Vec3& force, const Vec3& moment = Vec3::Zero()) {
  model::PointLoad p;
  p.at = model::length_of(c.lines[0]);
  p.force = force;
  p.moment = moment;
  c.lines[0].point_loads.push_back(p);
}

// A cantilever in a tapered stiffener at either end: w = ∫ P (L - s)²/EI ds for small deflections.
TEST(LineFurniture, BendStiffenerThatThinsOut) {
  const double L = 10, EI = 1e5, P = 1;
  const auto stiff = [&](double s) { return EI + (s < 4 ? 9e5 - 2e5 * s : 0); };
  const double exact = integral([&](double s) { return P * (L - s) * (L - s) / stiff(s); }, 0, 4) +
                       integral([&](double s) { return P * (L - s) * (L - s) / stiff(s); }, 4, L);
  double before = 0;
  for (const int elements : {10, 20, 40})
    for (const bool from_b : {false, true}) {
      model::Case c = cantilever(beam_type(1e9, EI, EI), L, elements, clamp({0, 0, 0}, {1, 0, 0}));
      model::Line& l = c.lines[0];
      l.bend_stiffeners.push_back({0, false, {{0, 9e5}, {4, 1e5}}});
      if (from_b) l.bend_stiffeners[0] = {4, true, {{0, 1e5}, {4, 9e5}}};
      load(c, {0, 0, -P});
      Simulation sim(PETSC_COMM_SELF, c);
      sim.solve_statics();
      const double w = -sim.state().x.back().z();
      const double error = w / exact - 1;
      printf("  %d elements: deflection %+.4f %%\n", elements, 100 * error);
      EXPECT_NEAR(w, exact, 0.03 * exact * std::pow(10.0 / elements, 2));
      if (from_b) {
        EXPECT_NEAR(w, before, 1e-9 * exact);
      }
      before = w;
    }
}

// Elastic beam on a rotational spring, small load: P L³/3EI + P L²/k. Rigid beam, large load: k phi = P L cos
// phi. The direction is that of an inclined body.
TEST(LineFurniture, SpringAtAnEnd) {
  const double L = 5, k = 2e4;
  for (const bool on_body : {false, true}) {
    model::Body b;
    b.name = "vessel";
    b.position = Vec3(3, 2, 1);
    b.rotation = Vec3(0.4, -0.3, 0.8);
    const Quat turn = exp_so3(b.rotation);
    model::End a = anchor({0, 0, 0});
    a.rotational_stiffness = k;
    a.direction = Vec3::UnitX();
    Vec3 along = Vec3::UnitX(), across = -Vec3::UnitZ();
    if (on_body) {
      a.kind = model::EndKind::body;
      a.carrier = "vessel";
      a.at = Vec3(1, 0, 0);
      along = turn * along;
      across = turn * across;
    }
    const auto run = [&](double EI, double P) {
      model::Case c = cantilever(beam_type(1e10, EI, EI), L, 10, a);
      if (on_body) c.bodies.push_back(b);
      load(c, P * across);
      Simulation sim(PETSC_COMM_SELF, c);
      sim.solve_statics();
      const Vec3 chord = sim.state().x.back() - sim.state().x.front();
      return std::pair(chord.dot(across), std::atan2(chord.dot(across), chord.dot(along)));
    };
    const double EI = 1e5;
    const double small = run(EI, 0.1).first;
    const double exact = 0.1 * (L * L * L / (3 * EI) + L * L / k);
    EXPECT_NEAR(small, exact, 1e-6 * exact);
    const double phi = run(1e9, 8000).second;
    EXPECT_NEAR(k * phi, 8000 * L * std::cos(phi), 1e-4 * k * phi);
    EXPECT_GT(phi, 0.9);
  }
}

// Tension by a table: a cable and a beam under tensions in all its ranges have the strain of the table.
TEST(LineFurniture, TensionByATable) {
  const auto table = std::make_shared<const ResponseCurve>(
      std::vector<ResponseCurve::Row>{{0.01, 1e4}, {0.03, 8e4}, {0.05, 1e5}}, false);
  for (const double T : {2e3, 3e4, 9e4, 1.4e5})
    for (const bool beam : {false, true}) {
      model::LineType t = beam ? beam_type(table->initial(), 10, 10) : cable_type(table->initial(), 1);
      t.tension_table = table;
      model::Case c = cantilever(t, 100, 10, anchor({0, 0, 0}));
      c.lines[0].end_a.direction = Vec3::UnitX();
      load(c, {T, 0, 0});
      Simulation sim(PETSC_COMM_SELF, c);
      sim.solve_statics();
      const double strain = sim.state().x.back().x() / 100 - 1;
      EXPECT_NEAR(table->at(strain).force, T, 1e-6 * T) << T << " " << beam;
    }
}

// An end moment bends a line into an arc whose curvature is that of the line type's law. `set` gives the line
// type this law.
void expect_arcs(double EI, const std::function<double(double)>& moment_at,
                 const std::function<void(model::LineType&)>& set) {
  for (const double M : {1e3, 5e3, 6.5e3}) {
    double low = 0, high = 0.5;
    while (high - low > 1e-14) (moment_at(0.5 * (low + high)) < M ? low : high) = 0.5 * (low + high);
    model::LineType t = beam_type(1e8, EI, 1e4);
    set(t);
    model::Case c = cantilever(t, 4, 16, clamp({0, 0, 0}, {1, 0, 0}));
    load(c, Vec3::Zero(), M * Vec3(0, -0.6, 0.8));
    Simulation sim(PETSC_COMM_SELF, c);
    sim.solve_statics();
    const double turned = log_so3(sim.state().q.front().conjugate() * sim.state().q.back()).norm();
    printf("  moment %.0f N m: turned by %.6f rad, curvature times length %.6f\n", M, turned, 4 * low);
    EXPECT_NEAR(turned, 4 * low, 2e-5 * 4 * low) << M;
  }
}

TEST(LineFurniture, MomentByATable) {
  const auto table = std::make_shared<const ResponseCurve>(
      std::vector<ResponseCurve::Row>{{0.1, 4e3}, {0.2, 6e3}, {0.5, 7e3}}, true);
  expect_arcs(
      table->initial(), [&](double c) { return table->at(c).force; },
      [&](model::LineType& t) { t.moment_table = table; });
}

TEST(LineFurniture, MomentByAPlasticCurve) {
  const auto law = std::make_shared<const PlasticBending>(
      std::vector<PlasticBending::Row>{{0.1, 4e3}, {0.2, 6e3}, {0.5, 7e3}});
  expect_arcs(
      law->initial(), [&](double c) { return law->at(c, 0, nullptr).m[0]; },
      [&](model::LineType& t) { t.plastic_bending = law; });
}

}  // namespace
}  // namespace hawser::test::line_furniture_test
