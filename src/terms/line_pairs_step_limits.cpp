// The class LinePairs: checks that no line passes through another, and step limits that resolve impacts.

#include <algorithm>
#include <cmath>

#include "hawser/kernels/axis_approach.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

// In a step, the distance of two axes may not fall below the smaller of kThrough times the sum of the radii
// and half of the distance before, nor below kPressed: below about half of the radii, the force that pushes
// crossing lines apart decreases with the penetration.
constexpr double kThrough = 0.25, kPressed = 0.1;
// In statics a step has no information about contacts it has not met. It ends at this fraction of the sum of
// the radii, so that the next step includes the contact. Axes nearer than kNoSide cross.
constexpr double kStaticDepth = 0.7, kNoSide = 1e-9;
// Largest penetration in a step, as a fraction of the sum of the radii.
constexpr double kDeep = 0.5;
// Steps longer than this fraction of the contact period do not resolve an impact.
constexpr double kUnresolved = 1.0 / 3;
// Penetration for which a stiffness is proposed, as a fraction of the sum of the radii.
constexpr double kProposed = 0.25;

}  // namespace

Verdict LinePairs::check_step(const Kinematics& trial) const {
  if (!candidates_.covers(trial)) return {Verdict::Kind::prepare_again, advice::BeyondContactSearch{}};
  if (start_.size() != segments_.size()) return {};  // not prepared, no comparison possible
  const std::vector<Rod> moved = rods(trial);
  const Pair* through = nullptr;
  double smallest_gap = HUGE_VAL;
  for (const Pair& p : pairs_) {
    if (clipped(p) || !may_touch(p, moved) || !tunnels(p, trial)) continue;
    const double gap = nearest_at_start(p).gap;
    if (!through || gap < smallest_gap) {
      through = &p;
      smallest_gap = gap;
    }
  }
  if (through)
    return {Verdict::Kind::shorter,
            trial.moves() ? too_soft(*through) : advice::LinesPass{nearest_places(*through)}};
  return {};
}

// True if an axis passes through the other, or nearly does, from the start of the step to the trial.
bool LinePairs::tunnels(const Pair& p, const Kinematics& trial) const {
  const AxisShape a0(start(p.a));
  const AxisShape b0(start(p.b));
  const AxisShape a1(ends(trial, p.a));
  const AxisShape b1(ends(trial, p.b));
  ApproachLimits limits;
  if (trial.moves()) {
    limits.min_distance = kThrough * p.law.radii;
    limits.part = 0.5;
    limits.floor = kPressed * p.law.radii;
    return sides_kept(a0, a1, b0, b1, limits) != Sides::kept;
  }
  // Axes may cross at the start; then neither side is the correct one.
  limits.min_distance = kStaticDepth * p.law.radii;
  limits.part = 0.9;
  limits.no_side = kNoSide * p.law.radii;
  return sides_kept(a0, a1, b0, b1, limits) == Sides::near;
}

// Relative speed between the nearest points of the chords, m/s (> 0: separating), and the gap, m.
LinePairs::Nearest LinePairs::nearest(const Pair& p, const SegmentPair& c, const AxisEnds& a,
                                      const AxisEnds& b) const {
  if (!(c.distance > 0)) return {};
  const Vec3 v = (1 - c.s) * a.v1 + c.s * a.v2 - (1 - c.t) * b.v1 - c.t * b.v2;
  return {v.dot(c.difference) / c.distance, c.distance - p.law.radii};
}

// Relative acceleration of the element centres along the line between the chords, m/s². At the turning point
// of an impact the speed is zero.
double LinePairs::acceleration(const Pair& p, const Kinematics& state) const {
  const auto mean = [&](std::span<const Vec3> v, int segment) -> Vec3 {
    const ContactSegment& s = this->segment(segment);
    return 0.5 * (v[s.first] + v[s.second]);
  };
  const SegmentPair& c = p.chords;
  return c.distance > 0 ? (mean(state.a, p.a) - mean(state.a, p.b)).dot(c.difference) / c.distance : 0;
}

// Effective mass of the two lines, kg/m.
double LinePairs::mass_per_length(const Pair& p) const {
  const double a = type_of_segment(p.a).mass_per_length;
  const double b = type_of_segment(p.b).mass_per_length;
  return a * b / (a + b);
}

// 1/omega of the effective mass on the contact, s.
double LinePairs::inverse_frequency(const Pair& p, double speed) const {
  const double m = mass_per_length(p);
  const double depth = largest_depth(p);
  return std::sqrt(m / stiffness_of_impact(p.law.normal, depth, m, speed));
}

// Effective mass of an impact, kg: the interval in contact is at most one of the elements.
double LinePairs::mass(const Pair& p) const {
  return mass_per_length(p) * std::min(segment(p.a).element.length, segment(p.b).element.length);
}

// In a step longer than a third of the contact period, all energy of lines that meet or part is uncertain. In
// a shorter one, only the error of the trapezoidal rule at first or last contact is.
void LinePairs::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  const std::vector<Rod> moved = rods(trial);
  for (const Pair& p : pairs_) {
    const double slow = inverse_frequency(p, 0);
    const double ramp = p.law.normal.smoothing;
    if (!p.counted || clipped(p) || resolves_contact(slow, trial.step) || (!p.points && !near(p, moved)))
      continue;
    const AxisEnds a = ends(trial, p.a);
    const AxisEnds b = ends(trial, p.b);
    const Nearest before = nearest_at_start(p);
    const Nearest after = nearest(p, closest_points_of_segments(a.x1, a.x2, b.x1, b.x2), a, b);
    const double speed = std::max(std::abs(before.speed), std::abs(after.speed));
    if (!(speed * slow > 2 * ramp)) continue;
    const double m = mass(p);
    const double k = m / (slow * slow);
    const double depth = std::max(ramp - std::min(before.gap, after.gap), 0.0);
    const double path = std::abs(after.gap - before.gap);
    const double error =
        trial.step > kUnresolved * 2 * M_PI * slow
            ? 0.5 * m * speed * speed
            : crossing_error(slow, 2 * ramp, k * depth, 0.5 * k * depth * depth, path, speed);
    if (error > 0) to.list.push_back({line_of_segment(p.a), line_of_segment(p.b), error});
  }
}

// Penetration in the accepted state, m, negative within the ramp; 0: no contact. A pass without a share of
// the force has no points.
double LinePairs::largest_depth(const Pair& p) const {
  double depth = -HUGE_VAL;
  for (size_t k = 0; k < kPasses; ++k)
    if (kPassKinds[k].on_element() && p.points && !(*p.points)[k].empty())
      depth = std::max(depth, largest_depth_of((*p.points)[k]));
  return depth > -HUGE_VAL ? depth : 0;
}

// Limits the step so that impacts are resolved and no line, at its present speed, penetrates deeper than half
// the sum of the radii.
void LinePairs::limit_step(const Kinematics& state, ImpactEvents& to) {
  for (const Pair& p : pairs_) {
    if (clipped(p)) continue;
    const size_t i = p.a;
    const size_t j = p.b;
    const Nearest c = nearest_at_start(p);
    const double ramp = p.law.normal.smoothing;
    const double clearance = std::max(c.gap - rods_[i].sagitta - rods_[j].sagitta, 0.0);
    if (c.speed < 0) to.limit((clearance + kDeep * p.law.radii) / -c.speed);
    if (!p.counted) continue;
    Approach a{std::max(clearance - ramp, 0.0), -c.speed, acceleration(p, state)};
    if (p.points) a.gap = -ramp - largest_depth(p);
    to.add(impact_event(inverse_frequency(p, std::max(-c.speed, 0.0)), 2 * ramp, mass(p), a),
           line_of_segment(p.a), line_of_segment(p.b));
  }
}

// Nearest places of two lines in the accepted state.
advice::NearestPlaces LinePairs::nearest_places(const Pair& p) const {
  const Element& a = segment(p.a).element;
  const Element& b = segment(p.b).element;
  const Mesh& m = *mesh_.mesh;
  return {m.line_names[a.line], m.line_names[b.line], arc_at(m, a, p.chords.s), arc_at(m, b, p.chords.t)};
}

// Energy in the contact springs of the two lines that this rank counts, J.
double LinePairs::stored(const Pair& pair) const {
  const auto lines = [&](const Pair& p) { return ordered(line_of_segment(p.a), line_of_segment(p.b)); };
  return sum([&](const Pair& p) { return lines(p) == lines(pair); },
             [](const LinePairContactPoint& h) { return h.potential; });
}

// The energy of a crossing is proportional to the depth to the power 5/2.
advice::StepFinding LinePairs::too_soft(const Pair& p) const {
  const double radii = p.law.radii;
  const double k = p.law.normal.stiffness;
  const double speed = -nearest_at_start(p).speed;
  const double depth = largest_depth(p);
  if (!(depth > kProposed * radii)) return advice::LinesStartTooNear{nearest_places(p)};
  const double has = stored(p);
  const double more = speed > 0 ? 0.5 * mass(p) * speed * speed : 0;
  const double required = k * std::pow(depth / (kProposed * radii), 2.5) * (1 + more / has);
  const bool given = options_.tuned.count(ordered(line_of_segment(p.a), line_of_segment(p.b))) > 0;
  return advice::PressedLines{.at = nearest_places(p),
                              .depth = depth,
                              .radii = radii,
                              .stiffness = k,
                              .required = required,
                              .energy = has,
                              .given = given};
}

}  // namespace hawser
