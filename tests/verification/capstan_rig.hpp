// Case C01 for contact at the nodes and along the line: a line slides over a drum, and the ratio of its end
// tensions is exp(mu theta) (Euler, Eytelwein). Only contact and friction hold the line.
//
// There is no gravity. A dead load T1 pulls one end. The other end is drawn along the tangent at a constant
// speed over a fixed drum, or it is held while the drum rotates under the line. The turns lie in one plane:
// contact between lines is off, and the ratio needs no correction for a helix.
#pragma once

#include "verification/contact_rig.hpp"

namespace hawser::test::capstan {

inline constexpr double kRadius = 1, kLine = 0.01, kLoad = 1000;  // m, m (half the diameter), N

// The part that moves.
enum class Moving { line, drum };

struct Pull {
  Moving moving = Moving::line;
  double mu = 0.3, wrap = M_PI;
  model::ContactMethod method = model::ContactMethod::line;
  int elements_a_radian = 8;
  bool beam = true, faceted = false;  // 96 flat facets, or a smooth drum
  double step = 0.005, longest = 0;   // s; step 0: automatic
  double duration = 4, EA = 1e7;      // s, N
};

struct Pulled {
  Samples ratio;                                // T2/T1 over the second half
  int steps = 0, iterations = 0, touching = 0;  // touching: nodes or elements, by the method
  double penetration = 0, audit = 0;            // m; energy error over the work brought in
  double cpu = 0;                               // s, CPU a simulated second
};

inline Pulled run(const Pull& p) {
  const double rho = kRadius + kLine, speed = 0.05;
  const std::vector<Vec3> path = capstan_path(rho, p.wrap, 1.5, 0.5);
  const double length = path_length(path);
  const int elements = static_cast<int>(std::ceil(p.elements_a_radian * length / rho));
  model::LineType type = p.beam ? beam_type(p.EA, 1, 1) : cable_type(p.EA, 1);
  type.outer_diameter = type.contact_diameter = 2 * kLine;
  type.stiffness_damping = 1e-3;
  model::Case c = one_line(type, length, elements, {}, {});
  c.contact.method = p.method;
  c.contact.between_lines.enabled = false;  // turns overlap: only contact with the drum acts
  model::Line& line = c.lines[0];
  line.start = model::Start::points;
  line.points = path;
  const double h = length / elements;
  line.loads.push_back({-kLoad / h * along_circle(0), 0, h, 0, 0});

  model::Body hook, drum;
  hook.name = "hook";
  drum.name = "drum";
  hook.position = path.back();
  hook.ramp = drum.ramp = 1;
  if (p.moving == Moving::line)
    hook.motion = model::ConstantMotion{speed * along_circle(p.wrap), Vec3::UnitZ(), 0};
  else  // about +y the drum's surface moves from hook to load
    drum.motion = model::ConstantMotion{Vec3::Zero(), Vec3::UnitY(), speed / rho};
  c.bodies = {hook, drum};
  line.end_b.kind = model::EndKind::body;
  line.end_b.carrier = "hook";

  model::Volume volume;
  volume.name = volume.body = "drum";
  volume.relative_damping = 0.1;
  volume.friction.axial = volume.friction.lateral = p.mu;
  c.volumes.push_back(volume);
  c.dynamics.enabled = true;
  c.dynamics.step = p.step;
  c.dynamics.max_step = p.longest;
  c.dynamics.duration = p.duration;

  Simulation s(PETSC_COMM_WORLD, c, {p.faceted ? faceted_drum(96, kRadius, 1) : round_drum(kRadius, 1)});
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Pulled out;
  const Energy e0 = s.system().energy(d.committed_kinematics());
  const double before = cpu_seconds();
  d.run(
      p.duration, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        ++out.steps;
        out.iterations += i.iterations;
        if (i.time < p.duration / 2) return true;
        const double* r = d.reactions().data() + 3 * s.local().block.back();
        out.ratio.add(Vec3(r[0], r[1], r[2]).norm() / kLoad, i.h);
        return true;
      });
  out.cpu = (cpu_seconds() - before) / p.duration;
  const Energy e = s.system().energy(d.committed_kinematics());
  const double brought = e.work + d.support_work() - (e.potential - e0.potential);
  out.audit = (e.kinetic + e.strain - e0.kinetic - e0.strain + e.friction + e.damping) / brought - 1;
  out.touching = s.line_volume_contact()->active_count();
  out.penetration = s.line_volume_contact()->largest_penetration().depth;
  return out;
}

inline void report(const Pull& p, const Pulled& o) {
  const double exact = std::exp(p.mu * p.wrap);
  std::printf(
      "capstan, contact %s, %s, %s moves, mu %.1f, %3.0f deg: T2/T1 %.4f, exact %.4f (%+.3f %%), rms %.2f "
      "%%, between "
      "%+.2f and %+.2f %%; %d steps, %.1f iterations a step, %.3f CPU s a second, penetration %.2g m, energy "
      "not accounted for %.3f %%\n",
      p.method == model::ContactMethod::line ? "along the line" : "at the nodes", p.beam ? "beam" : "cable",
      p.moving == Moving::line ? "line" : "drum", p.mu, p.wrap * 180 / M_PI, o.ratio.mean(), exact,
      100 * (o.ratio.mean() / exact - 1), 100 * o.ratio.rms() / exact, 100 * (o.ratio.least / exact - 1),
      100 * (o.ratio.most / exact - 1), o.steps, static_cast<double>(o.iterations) / o.steps, o.cpu,
      o.penetration, 100 * o.audit);
}

// Rows of a table that run with HAWSER_FULL only: neither mu 0.5 and half a turn, nor mu 0.3 and a quarter,
// nor the largest of both.
inline bool between(double mu, double wrap) {
  const bool half = mu == 0.5 && wrap == M_PI;
  const bool quarter = mu == 0.3 && wrap < M_PI;
  const bool largest = mu == 0.5 && wrap > 7;
  return !half && !quarter && !largest && !std::getenv("HAWSER_FULL");
}

}  // namespace hawser::test::capstan
