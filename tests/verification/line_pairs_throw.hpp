// Crossing lines thrown at each other with random velocities.
#pragma once

#include <random>

#include "hawser/geometry/segment_distance.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test {

inline constexpr double kDiameter = 0.1;

// Whether segments of the two lines changed sides between two states: the vector between their nearest points
// reverses while these points are inside the segments. The linear path between the states is sampled in small
// pieces.
inline bool crossed(const Mesh& mesh, const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  constexpr int kPieces = 200;
  const auto at = [&](int node, double t) {
    const size_t i = static_cast<size_t>(node);
    return Vec3((1 - t) * from[i] + t * to[i]);
  };
  const auto own = [&](int line) {
    const LineSpan& s = mesh.lines[static_cast<size_t>(line)];
    return std::pair(s.first_element, s.first_element + s.elements);
  };
  for (int a = own(0).first; a < own(0).second; ++a)
    for (int b = own(1).first; b < own(1).second; ++b) {
      const Element& A = mesh.element(static_cast<size_t>(a));
      const Element& B = mesh.element(static_cast<size_t>(b));
      SegmentPair last;
      for (int k = 0; k <= kPieces; ++k) {
        const double t = k / static_cast<double>(kPieces);
        const SegmentPair now =
            closest_points_of_segments(at(A.first, t), at(A.second, t), at(B.first, t), at(B.second, t));
        const auto inside = [](const SegmentPair& p) { return p.s > 0 && p.s < 1 && p.t > 0 && p.t < 1; };
        if (now.distance == 0) return true;
        if (k > 0 && inside(now) && inside(last) && now.difference.dot(last.difference) < 0) return true;
        last = now;
      }
    }
  return false;
}

struct Throw {
  bool met = false, crossed = false, finished = false;
  double depth = 0, gain = 0;  // over the radii; largest total energy over the initial one
  double made = 0;             // largest increase of energy over an impact, until just after it
  int steps = 0, rejected = 0;
};

inline Throw throw_lines(unsigned seed, double step_diameters, bool cables) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  model::Case c;
  c.environment.gravity = 0;
  model::LineType type = cables ? cable_type(1e6, 5) : beam_type(1e6, 1e3, 1e3, 5);
  type.contact_diameter = type.outer_diameter = kDiameter;
  type.rotary_inertia = Vec3::Constant(5 * kDiameter * kDiameter / 8);
  c.line_types = {type};
  const double speed = 4 + 4 * std::abs(unit(random));
  const double angle = 0.3 + 1.2 * std::abs(unit(random));
  const double gap = kDiameter * (1.05 + std::abs(unit(random)));
  for (int l = 0; l < 2; ++l) {
    model::Line line;
    line.name = l ? "second" : "first";
    line.sections.push_back({type.name, 2, 2, 1});
    line.start = model::Start::points;
    const Vec3 along = l ? Vec3(std::cos(angle), std::sin(angle), 0) : Vec3::UnitX();
    const Vec3 middle = 0.7 * unit(random) * along + Vec3(0, 0, l * gap);
    line.points = {middle - along, middle + along};
    c.lines.push_back(line);
  }
  touch(c, 2e7, 0.001 * kDiameter, 0.2);
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.step = step_diameters * kDiameter / speed;
  c.dynamics.duration = 1;
  Simulation s(PETSC_COMM_WORLD, c);
  for (int n = 0; n < s.local().nodes(); ++n) {
    const size_t i = static_cast<size_t>(n);
    const bool second = s.mesh().node(i).line == 1;
    s.state().v[i] = Vec3(0, 0, second ? -speed : 0) + 0.1 * speed * vector();
  }
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Throw out;
  std::vector<Vec3> last = d.committed().s.x;
  const auto total = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    return e.kinetic + e.strain + e.potential;
  };
  const double first = total();
  double apart = 1;
  bool touched = false;
  try {
    d.run((gap + 6 * kDiameter) / speed, [](double) { return 1e300; },
          [&](const StepInfo& info) {
            out.crossed |= crossed(s.mesh(), last, d.committed().s.x);
            const double energy = total() / first;
            const bool touches = s.line_pairs()->active_count() > 0;
            out.gain = std::max(out.gain, energy);
            if (touches || touched) out.made = std::max(out.made, energy - apart);
            if (!touches) apart = energy;
            touched = touches;
            out.met |= touches;
            last = d.committed().s.x;
            ++out.steps;
            out.rejected += info.rejected;
            return true;
          });
    out.finished = true;
  } catch (const std::exception& e) {
    printf("  throw %u: %s\n", seed, e.what());
  }
  out.depth = s.line_pairs()->deepest().depth / kDiameter;
  return out;
}

// Steps in which the lines move by half a diameter to four diameters; cables and beams alternate.
inline Throw throw_of(unsigned seed) { return throw_lines(seed, 0.5 + 3.5 * (seed % 8) / 7.0, seed % 2); }

inline void expect_none_passes_through(unsigned count) {
  unsigned met = 0, crossed = 0, unfinished = 0;
  long steps = 0, rejected = 0;
  double depth = 0, made = 0;
  double gain[2] = {0, 0};  // of beams, of cables
  unsigned gained = 0;      // impacts that increase the energy by more than 1 %
  for (unsigned seed = 0; seed < count; ++seed) {
    const Throw t = throw_of(seed);
    met += t.met;
    crossed += t.crossed;
    unfinished += !t.finished;
    steps += t.steps;
    rejected += t.rejected;
    gained += t.made > 0.01;
    depth = std::max(depth, t.depth);
    made = std::max(made, t.made);
    gain[seed % 2] = std::max(gain[seed % 2], t.gain);
  }
  printf(
      "  %u throws: %u met, %u passed through, %u stopped; %ld steps, %ld rejected; deepest %.3f of the "
      "radii; "
      "energy made by an impact at most %.4f of all, more than 1 %% by %u; largest energy in flight %.4f of "
      "the first with beams, %.4f with cables\n",
      count, met, crossed, unfinished, steps, rejected, depth, made, gained, gain[0], gain[1]);
  EXPECT_EQ(crossed, 0U);
  EXPECT_EQ(unfinished, 0U);
  EXPECT_GT(met, count / 2);
  EXPECT_LT(made, 0.05);
  EXPECT_LE(gained, count / 100);
  EXPECT_LT(gain[0], 1.1);
  EXPECT_LT(gain[1], 1.5);
}

}  // namespace hawser::test
