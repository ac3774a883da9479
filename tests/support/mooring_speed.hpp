// Cost of a simulated second of a mooring line or a riser: a studless chain ("chain") and a pipe of beams
// ("riser") in 200 m of water, the upper end surging 2 m every 10 s. The cost is given in CPU time and in
// numeric LU factorisations of the same chain (3-blocks, one a node of a cable, two of a beam, natural
// order), which can be compared across machines. Errors are those of the extremes at the upper end from 20 s
// to 100 s against converged ones, relative to the largest tension.
#pragma once

#include <fmt/format.h>
#include <petscmat.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hawser/run/simulation.hpp"
#include "support/cpu_time.hpp"

namespace hawser::test::speed {

// All in N.
struct Extremes {
  double least = 1e99, most = 0, anchor_least = 1e99, anchor_most = 0;
};
// Converged in element length and time step.
constexpr Extremes kChain = {1809.80e3, 2352.10e3, 1194.62e3, 1642.79e3};
constexpr Extremes kRiser = {63.41e3, 70.16e3, 12.97e3, 16.90e3};

// Water, bed, vessel and settings of dynamics. Newton's tolerance: 10 to the power of minus `digits`.
inline model::Case surging(double step, int digits) {
  model::Case c;
  c.environment.water.present = true;
  c.environment.water.depth = 200;
  model::Seabed& bed = c.environment.seabed;
  bed.present = true;
  bed.depth = 200;
  bed.basis = model::StiffnessBasis::per_length;
  model::Body b;
  b.name = "vessel";
  model::HarmonicMotion m;
  m.amplitude = Vec3(2, 0, 0);
  m.period = 10;
  b.motion = m;
  b.ramp = 10;
  c.bodies.push_back(b);
  c.contact.between_lines.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 100;
  c.dynamics.step = step;
  c.dynamics.tolerance = std::pow(10, -digits);
  return c;
}

inline model::Line hung(const std::string& type, double length, int segments, const Vec3& anchor,
                        const Vec3& hang_off) {
  model::Line l;
  l.name = "line";
  l.sections.push_back({type, length, segments, 1});
  l.end_a.kind = model::EndKind::anchor;
  l.end_a.at = anchor;
  l.end_b.kind = model::EndKind::body;
  l.end_b.carrier = "vessel";
  l.end_b.at = hang_off;
  return l;
}

// Bed stiffness of 100 kN/m³ on the diameter, no friction; a damping ratio of 1 for each segment.
inline model::Case chains(int segments, int lines, double step, int digits) {
  model::Case c = surging(step, digits);
  model::LineType t;
  t.name = "chain";
  t.kind = model::LineKind::cable;
  t.outer_diameter = 0.252;
  t.contact_diameter = 1e-9;
  t.mass_per_length = 390;
  t.EA = 1.674e9;
  t.Cd_normal = 1.37;
  t.Cd_axial = 0.64;
  t.stiffness_damping = 760.0 / segments * std::sqrt(t.mass_per_length / t.EA);
  c.line_types.push_back(t);
  c.environment.seabed.normal_stiffness = 25200;
  for (int i = 0; i < lines; ++i) {
    c.lines.push_back(hung(t.name, 760, segments, Vec3(700, 50 * i, -200), Vec3(0, 50 * i, 0)));
    c.lines.back().name = fmt::format("{} {}", t.name, i);
  }
  return c;
}

// Beams pinned at both ends; the only damping is that of the water.
inline model::Case riser(int segments, double step, int digits) {
  model::Case c = surging(step, digits);
  model::LineType t;
  t.name = "pipe";
  t.outer_diameter = 0.2;
  t.contact_diameter = 1e-9;
  t.mass_per_length = 60;
  t.EA = 5e8;
  t.EI2 = t.EI3 = t.GJ = 5e4;
  t.rotary_inertia = Vec3(0.6, 0.3, 0.3);
  t.Cd_normal = 1.2;
  t.Cd_axial = 0.05;
  c.line_types.push_back(t);
  c.environment.seabed.normal_stiffness = 2e4;
  c.lines.push_back(hung(t.name, 420, segments, Vec3(300, 0, -200), Vec3(0, 0, -10)));
  return c;
}

// Time of one numeric factorisation, s: the minimum over batches of 200.
inline double factorisation(System& system, const State& s, int batches) {
  MatHandle J = system.create_matrix();
  Weights w;
  w.M = 400;
  const std::vector<double> zero(3 * static_cast<std::size_t>(system.mesh().blocks()), 0);
  system.tangent(s.at_rest(), w, zero, false, J.get());
  IS rows = nullptr, columns = nullptr;
  check(MatGetOrdering(J.get(), MATORDERINGNATURAL, &rows, &columns));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  Mat F = nullptr;
  check(MatGetFactor(J.get(), MATSOLVERPETSC, MAT_FACTOR_LU, &F));
  check(MatLUFactorSymbolic(F, J.get(), rows, columns, &info));
  double best = 1e9;
  for (int batch = 0; batch < batches; ++batch) {
    const int n = 200;
    const double from = cpu_seconds();
    for (int i = 0; i < n; ++i) check(MatLUFactorNumeric(F, J.get(), &info));
    best = std::min(best, (cpu_seconds() - from) / n);
  }
  check(MatDestroy(&F));
  check(ISDestroy(&rows));
  check(ISDestroy(&columns));
  return best;
}

struct Cost {
  double used = 0, one = 0;  // s: CPU time of a simulated second, time of a factorisation
  double steps = 0, iterations = 0;
  Extremes found;
};

// Simulates 100 s from the line at rest.
inline Cost measure(const model::Case& c, int batches) {
  const std::size_t segments = static_cast<std::size_t>(c.lines[0].sections[0].elements);
  run::Simulation sim(PETSC_COMM_SELF, c);
  sim.solve_statics();
  Cost cost;
  cost.one = factorisation(sim.system(), sim.state(), batches);
  sim.dynamics().start(sim.state());
  const std::size_t end = 3 * static_cast<std::size_t>(sim.local().block[segments]);
  const double from = cpu_seconds();
  sim.dynamics().run(
      100, [](double) { return 100.0; },
      [&](const StepInfo& info) {
        cost.iterations += info.iterations;
        ++cost.steps;
        if (info.time < 20) return true;
        const auto& r = sim.dynamics().reactions();
        const double T = Vec3(r[end], r[end + 1], r[end + 2]).norm();
        const double A = Vec3(r[0], r[1], r[2]).norm();
        Extremes& found = cost.found;
        found.least = std::min(found.least, T);
        found.most = std::max(found.most, T);
        found.anchor_least = std::min(found.anchor_least, A);
        found.anchor_most = std::max(found.anchor_most, A);
        return true;
      });
  cost.used = (cpu_seconds() - from) / 100;
  return cost;
}

}  // namespace hawser::test::speed
