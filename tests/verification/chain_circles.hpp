// A chain of 33 m on the bed of a tank, its upper end driven on a vertical circle; at the higher speeds it
// becomes slack and snaps taut. Measured by Lindahl (1985); Bergdahl, Palm, Eskilsson & Lindahl (2016), J.
// Mar. Sci. Eng. 4(1), 5, tables 7 and 8.
#pragma once

#include "support/rig.hpp"

namespace hawser::test {

struct CircleCase {
  double period, radius, measured;  // s, m, N: mean of the largest tensions of the cycles
};

inline const std::vector<CircleCase>& circle_cases() {
  static const std::vector<CircleCase> cases = [] {
    const double radius[] = {0.075, 0.1, 0.125, 0.15, 0.2};
    const struct {
      double period, measured[5];
    } rows[] = {{1.25, {42.5, 46.8, 54.1, 60.4, 70.3}}, {1.5, {41.0, 45.3, 51.5, 59.0, 68.0}},
                {2, {36.0, 39.5, 47.5, 54.1, 62.3}},    {2.5, {31.1, 35.4, 42.5, 49.0, 57.3}},
                {3, {29.5, 33.1, 39.3, 45.8, 54.0}},    {3.5, {27.8, 31.5, 37.5, 42.5, 50.1}}};
    std::vector<CircleCase> out;
    for (const auto& row : rows)
      for (int i = 0; i < 5; ++i) out.push_back({row.period, radius[i], row.measured[i]});
    return out;
  }();
  return cases;
}

// Coefficients of the article, interpreted as in CableDyn's validation with the same tables (SMI-Lab-Inha,
// prepare_bergdahl_cases.py): drag on the bar diameter of 2.2 mm, the axial coefficient on its skin; added
// mass on the area of the bar; critical damping of the bed.
inline model::Case circling_chain(const CircleCase& of, int elements, double step) {
  const double d = 0.0022, m = 0.0818, modulus = 3e9;
  model::LineType t = cable_type(1e4, m);
  t.outer_diameter = std::sqrt(4 * m / (M_PI * 7800));
  t.contact_diameter = 1e-9;
  t.drag_diameter = d;
  t.Cd_normal = 2.5;
  t.Cd_axial = 0.5;
  t.Ca_normal = 3.8;
  model::Case c = one_line(t, 33, elements, anchor({0, 0, -3}), {});
  c.environment.gravity = 9.80665;
  c.environment.water.present = true;
  c.environment.water.depth = 3;
  c.environment.water.density = 1000;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = 3;
  bed.basis = model::StiffnessBasis::per_length;
  bed.normal_stiffness = modulus * d;
  bed.damping = 2 * std::sqrt(modulus * d * m);
  bed.friction.axial = bed.friction.lateral = 0.3;
  bed.friction.mobilisation_length = 0.001;
  model::Body b;
  b.name = "carriage";
  b.position = Vec3(32.554, 0, 0.3);
  model::HarmonicMotion h;
  h.amplitude = Vec3(of.radius, 0, of.radius);
  h.period = of.period;
  h.phase = Vec3(0, 0, M_PI / 2);
  b.motion = h;
  b.ramp = 3 * of.period;
  c.bodies.push_back(b);
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = "carriage";
  c.lines[0].end_b = e;
  c.dynamics.enabled = true;
  c.dynamics.step = step;
  c.dynamics.tolerance = 1e-6;
  return c;
}

struct CircleResult {
  double mean = 0, lowest = 1e99, highest = 0;  // N, of the cycles' largest tensions
  double least = 1e99;                          // N
};

// Three cycles of ramp, `settle` cycles to settle, then `judged` cycles whose peaks are evaluated.
inline CircleResult circle(const CircleCase& of, int elements, double step, int settle, int judged,
                           double rho_infinity = 0.8) {
  model::Case c = circling_chain(of, elements, step);
  c.dynamics.rho_infinity = rho_infinity;
  const double from = (3 + settle) * of.period;
  const double until = from + judged * of.period;
  c.dynamics.duration = until;
  Simulation sim(PETSC_COMM_SELF, c);
  sim.solve_statics();
  const size_t end = 3 * static_cast<size_t>(sim.local().block[static_cast<size_t>(elements)]);
  sim.dynamics().start(sim.state());
  std::vector<double> peak(static_cast<size_t>(judged), 0);
  CircleResult out;
  sim.dynamics().run(
      until, [until](double) { return until; },
      [&](const StepInfo& info) {
        if (info.time < from) return true;
        const auto& r = sim.dynamics().reactions();
        const double T = Vec3(r[end], r[end + 1], r[end + 2]).norm();
        const size_t cycle =
            std::min(static_cast<size_t>((info.time - from) / of.period), static_cast<size_t>(judged - 1));
        peak[cycle] = std::max(peak[cycle], T);
        out.least = std::min(out.least, T);
        return true;
      });
  for (const double p : peak) {
    out.mean += p / judged;
    out.lowest = std::min(out.lowest, p);
    out.highest = std::max(out.highest, p);
  }
  return out;
}

inline double report(const CircleCase& of, const CircleResult& r) {
  const double error = 100 * (r.mean / of.measured - 1);
  printf("  %.2f s, radius %.3f m: %.1f N (cycles %.1f to %.1f, least %.2f), measured %.1f: %+.1f %%\n",
         of.period, of.radius, r.mean, r.lowest, r.highest, r.least, of.measured, error);
  return error;
}

}  // namespace hawser::test
