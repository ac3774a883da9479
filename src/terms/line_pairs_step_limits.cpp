// Which steps LinePairs accepts and which it asks for: no line goes through another, and it is seen how they
// meet.

#include <algorithm>
#include <cmath>

#include "hawser/kernels/axis_approach.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/mesh/arc.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

// Axes come no nearer in a step than this part of the radii, or than half of what they were, and no nearer
// than the second: from about half the radii on, what crosses is pushed back the less the deeper it is.
constexpr double kThrough = 0.25, kPressed = 0.1;
// In statics, where steps know nothing of forces that they have not met, they end at this part of the radii:
// the next one knows. Axes nearer than the second cross.
constexpr double kStaticDepth = 0.7, kNoSide = 1e-9;
// A step may take a line this part of the radii deeper than to the surface.
constexpr double kDeep = 0.5;
// Part of the contact's period, beyond which a step sees nothing of an impact.
constexpr double kUnresolved = 1.0 / 3;
// The part of the radii to which a stiffness that is proposed lets lines be pressed in.
constexpr double kProposed = 0.25;

}  // namespace

Verdict LinePairs::check_step(const Kinematics& trial) const {
  if (!candidates_.covers(trial)) return {Verdict::Kind::prepare_again, advice::BeyondContactSearch{}};
  if (start_.size() != candidates_.segments().size()) return {};  // not prepared: nothing to compare with
  const std::vector<Rod> moved = rods(trial);
  const Pair* through = nullptr;
  double least = HUGE_VAL;
  for (const Pair& p : pairs_) {
    if (clipped(p) || !met(p, moved) || !tunnels(p, trial)) continue;
    const double gap = nearest_at_start(p).gap;
    if (!through || gap < least) {
      through = &p;
      least = gap;
    }
  }
  if (through)
    return {Verdict::Kind::shorter,
            trial.step > 0 ? too_soft(*through) : advice::LinesPass{nearest_places(*through)}};
  return {};
}

// Whether an axis comes through the other, or nearly, on the way from the start of the step.
bool LinePairs::tunnels(const Pair& p, const Kinematics& trial) const {
  const AxisShape a0(start(p.a)), b0(start(p.b)), a1(ends(trial, p.a)), b1(ends(trial, p.b));
  ApproachLimits limits;
  if (trial.step > 0) {
    limits.most = kThrough * p.law.radii;
    limits.part = 0.5;
    limits.floor = kPressed * p.law.radii;
    return sides_kept(a0, a1, b0, b1, limits) != Sides::kept;
  }
  // Axes may cross from the start: then no side is the right one.
  limits.most = kStaticDepth * p.law.radii;
  limits.part = 0.9;
  limits.no_side = kNoSide * p.law.radii;
  return sides_kept(a0, a1, b0, b1, limits) == Sides::near;
}

// Relative speed along the line between the nearest points of the chords, m/s (> 0: they part), and the gap,
// m.
LinePairs::Nearest LinePairs::nearest(const Pair& p, const SegmentPair& c, const AxisEnds& a,
                                      const AxisEnds& b) const {
  if (!(c.distance > 0)) return {};
  const Vec3 v = (1 - c.s) * a.v1 + c.s * a.v2 - (1 - c.t) * b.v1 - c.t * b.v2;
  return {v.dot(c.difference) / c.distance, c.distance - p.law.radii};
}

// Relative acceleration of the middles along the line between them, m/s²: at the turning point of an impact
// there is no speed.
double LinePairs::acceleration(const Pair& p, const Kinematics& at) const {
  const auto mean = [&](std::span<const Vec3> v, int segment) -> Vec3 {
    const ContactSegment& s = this->segment(segment);
    return 0.5 * (v[s.first] + v[s.second]);
  };
  const SegmentPair& c = p.chords;
  return c.distance > 0 ? (mean(at.a, p.a) - mean(at.a, p.b)).dot(c.difference) / c.distance : 0;
}

// kg/m, of the two on their contact.
double LinePairs::mass_per_length(const Pair& p) const {
  const double a = type_of(p.key.first).mass_per_length, b = type_of(p.key.second).mass_per_length;
  return a * b / (a + b);
}

// 1/omega of the two masses on the contact, s.
double LinePairs::inverse_frequency(const Pair& p, double speed) const {
  const double m = mass_per_length(p), depth = deepest(p);
  return std::sqrt(m / stiffness_of_impact(p.law.normal, depth, m, speed));
}

// kg. The interval that touches is at most one of the elements.
double LinePairs::mass(const Pair& p) const {
  return mass_per_length(p) * std::min(element(p.key.first).length, element(p.key.second).length);
}

// All of the energy of two that meet or part is uncertain in a step of more than a third of the contact's
// period; in a shorter one, that by which the trapezoidal rule misses where they touch first or last.
void LinePairs::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  const std::vector<Rod> moved = rods(trial);
  for (const Pair& p : pairs_) {
    const double slow = inverse_frequency(p, 0), ramp = p.law.normal.smoothing;
    if (!p.counted || clipped(p) || resolves_contact(slow, trial.step) || (!p.points && !near(p, moved)))
      continue;
    const AxisEnds a = ends(trial, p.a), b = ends(trial, p.b);
    const Nearest before = nearest_at_start(p),
                  after = nearest(p, closest_points_of_segments(a.x1, a.x2, b.x1, b.x2), a, b);
    const double speed = std::max(std::abs(before.speed), std::abs(after.speed));
    if (!(speed * slow > 2 * ramp)) continue;
    const double m = mass(p), k = m / (slow * slow),
                 depth = std::max(ramp - std::min(before.gap, after.gap), 0.0),
                 path = std::abs(after.gap - before.gap);
    const double error =
        trial.step > kUnresolved * 2 * M_PI * slow
            ? 0.5 * m * speed * speed
            : crossing_error(slow, 2 * ramp, k * depth, 0.5 * k * depth * depth, path, speed);
    if (error > 0) to.list.push_back({element(p.key.first).line, element(p.key.second).line, error});
  }
}

// m, in the accepted state, negative within the ramp; 0: they do not touch. A side without a share has no
// points.
double LinePairs::deepest(const Pair& p) const {
  double depth = -HUGE_VAL;
  for (const size_t pass : {0, 3})
    if (p.points && !(*p.points)[pass].empty()) depth = std::max(depth, deepest_of((*p.points)[pass]));
  return depth > -HUGE_VAL ? depth : 0;
}

// An impact is followed, and no line is carried deeper into another than half the radii at the speed it has.
void LinePairs::limit_step(const Kinematics& at, ImpactEvents& to) const {
  for (const Pair& p : pairs_) {
    if (clipped(p)) continue;
    const size_t i = p.a, j = p.b;
    const Nearest c = nearest_at_start(p);
    const double ramp = p.law.normal.smoothing,
                 apart = std::max(c.gap - rods_[i].sagitta - rods_[j].sagitta, 0.0);
    if (c.speed < 0) to.limit((apart + kDeep * p.law.radii) / -c.speed);
    if (!p.counted) continue;
    Approach a{std::max(apart - ramp, 0.0), -c.speed, acceleration(p, at)};
    if (p.points) a.gap = -ramp - deepest(p);
    to.add(impact_event(inverse_frequency(p, std::max(-c.speed, 0.0)), 2 * ramp, mass(p), a),
           element(p.key.first).line, element(p.key.second).line);
  }
}

// Where two lines are nearest in the accepted state.
advice::NearestPlaces LinePairs::nearest_places(const Pair& p) const {
  const Element &a = element(p.key.first), &b = element(p.key.second);
  const Mesh& m = *mesh_.mesh;
  return {m.lines[a.line].name, m.lines[b.line].name, arc_at(m, a, p.chords.s), arc_at(m, b, p.chords.t)};
}

// J, in the springs of the contact of the two lines, of what this rank counts.
double LinePairs::stored(const Pair& of) const {
  const auto lines = [&](const Pair& p) {
    return ordered(element(p.key.first).line, element(p.key.second).line);
  };
  return sum([&](const Pair& p) { return lines(p) == lines(of); },
             [](const LinePairContactPoint& h) { return h.potential; });
}

// A crossing holds energy with the depth to the power 5/2.
advice::StepFinding LinePairs::too_soft(const Pair& p) const {
  const double radii = p.law.radii, k = p.law.normal.stiffness, speed = -nearest_at_start(p).speed,
               depth = deepest(p);
  if (!(depth > kProposed * radii)) return advice::LinesStartTooNear{nearest_places(p)};
  const double has = stored(p), more = speed > 0 ? 0.5 * mass(p) * speed * speed : 0;
  const double wanted = k * std::pow(depth / (kProposed * radii), 2.5) * (1 + more / has);
  const bool own = options_.tuned.count(ordered(element(p.key.first).line, element(p.key.second).line)) > 0;
  return advice::PressedLines{.at = nearest_places(p),
                              .depth = depth,
                              .radii = radii,
                              .stiffness = k,
                              .wanted = wanted,
                              .energy = has,
                              .own_settings = own};
}

}  // namespace hawser
