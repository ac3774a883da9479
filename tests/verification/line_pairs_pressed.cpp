// A line is drawn against another with more force than their contact can carry: it does not pass through, and
// the run stops with the reason.
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "support/rig.hpp"

namespace hawser::test::line_pairs_pressed_test {
namespace {

// The ends of `a` move up at 10.7 m/s from below `b`, far past it.
const char* const kDrawn = R"(hawser: 1
environment: {gravity: 0}
line_types:
  a: {outer_diameter: 0.2, mass_per_length: 20, EA: 2.0e6, EI: 1000, GJ: 1000}
  b: {outer_diameter: 0.12, mass_per_length: 20, EA: 2.0e6, EI: 1000, GJ: 1000}
bodies:
  m: {position: [0, 0, -1.2], motion: {velocity: [0, 0, 10.7], ramp: 0.112}}
lines:
  a:
    sections: [{type: a, length: 3.98, elements: 3}]
    end_a: {body: m, at: [-1.4658, -1.1382, 0]}
    end_b: {body: m, at: [1.4658, 1.5832, 0]}
  b:
    sections: [{type: b, length: 5.95, elements: 3}]
    end_a: {anchor: [0, -3, 0]}
    end_b: {anchor: [0, 3, 0]}
contact: {between_lines: {normal_stiffness: STIFFNESS, friction: 0.3, relative_damping: 0}}
dynamics: {duration: 0.3745, step: 0.06, rho_infinity: 0.4}
)";

struct Drawn {
  bool through = false;
  double depth = 0;  // m
  std::string stopped;
};

// Heights of b over a where they cross in plan view.
std::vector<double> heights(const Simulation& s, const State& at) {
  const auto points = [&](int line) {
    std::vector<Vec3> out;
    for (const LocalElement& e : s.local().elements) {
      const Element& g = s.mesh().element(static_cast<size_t>(e.global));
      if (g.line != line) continue;
      const size_t i = static_cast<size_t>(e.first);
      const size_t j = static_cast<size_t>(e.second);
      AxisEnds ends;
      ends.length = g.length;
      ends.x1 = at.x[i];
      ends.x2 = at.x[j];
      ends.q1 = at.q[i];
      ends.q2 = at.q[j];
      const AxisShape shape(ends);
      for (int k = 0; k < 200; ++k) out.push_back(shape.point(k / 199.0));
    }
    return out;
  };
  const std::vector<Vec3> a = points(0);
  const std::vector<Vec3> b = points(1);
  std::vector<double> out;
  for (size_t i = 0; i + 1 < a.size(); ++i)
    for (size_t j = 0; j + 1 < b.size(); ++j) {
      const Vec3 d = b[j] - a[i];
      const Vec3 u = a[i + 1] - a[i];
      const Vec3 v = b[j + 1] - b[j];
      const double det = v.x() * u.y() - u.x() * v.y();
      const double x = (v.x() * d.y() - d.x() * v.y()) / det;
      const double y = (u.x() * d.y() - d.x() * u.y()) / det;
      if (x >= 0 && x < 1 && y >= 0 && y < 1) out.push_back(d.z() + y * v.z() - x * u.z());
    }
  return out;
}

Drawn draw(const std::string& stiffness) {
  std::string text = kDrawn;
  text.replace(text.find("STIFFNESS"), 9, stiffness);
  model::Case c = io::read_case_text(text, "drawn.yaml");
  Simulation s(PETSC_COMM_WORLD, c);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Drawn out;
  try {
    d.run(
        c.dynamics.duration, [](double) { return 1e300; },
        [&](const StepInfo&) {
          for (const double h : heights(s, d.committed().s)) out.through |= h < 0;
          return true;
        });
  } catch (const SolveError& e) {
    out.stopped = e.what();
  }
  out.depth = s.line_pairs()->deepest().depth;
  return out;
}

TEST(PressedLines, WhatIsTooSoftEndsTheRunWithTheReason) {
  for (const char* k : {"{per_length: 2.0e6}", "{per_length: 5.0e6}"}) {
    const Drawn d = draw(k);
    EXPECT_FALSE(d.through) << k;
    EXPECT_LT(d.depth, 0.96 * 0.16) << k;
    printf("  %s: %s\n", k, d.stopped.c_str());
    EXPECT_NE(d.stopped.find("is too small for the contact force"), std::string::npos) << d.stopped;
    EXPECT_NE(d.stopped.find("lines a (arc length"), std::string::npos) << d.stopped;
    EXPECT_EQ(d.stopped.find("out of balance"), std::string::npos) << d.stopped;
    // The stiffness that the message proposes carries the force.
    const size_t at = d.stopped.find("{per_length: ");
    ASSERT_NE(at, std::string::npos);
    const Drawn held = draw(d.stopped.substr(at, d.stopped.find('}', at) + 1 - at));
    EXPECT_EQ(held.stopped, "");
    EXPECT_FALSE(held.through);
    EXPECT_LT(held.depth, 0.3 * 0.16);
  }
}

TEST(PressedLines, TheAutomaticStiffnessHoldsThem) {
  const Drawn d = draw("auto");
  EXPECT_EQ(d.stopped, "");
  EXPECT_FALSE(d.through);
}

}  // namespace
}  // namespace hawser::test::line_pairs_pressed_test
