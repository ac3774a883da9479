#include "hawser/terms/line_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/geometry/segment_ccd.hpp"
#include "hawser/geometry/segment_distance.hpp"

namespace hawser {
namespace {

// Lines must not come nearer than this part of the radii between two accepted states: their axes would cross.
constexpr double kThrough = 0.25;
// In statics, where steps know nothing of forces that they have not met, they end at this part of the radii:
// the next one knows. Axes nearer than the second cross.
constexpr double kStaticDepth = 0.7, kNoSide = 1e-9;
// A step may take a line this part of the radii deeper than to the surface.
constexpr double kDeep = 0.5;
// Steps in a period of the contact, at least.
constexpr double kLeastSteps = 3;

}  // namespace

double deepest_of(const std::vector<LinePairHistory>& points) {
  if (points.empty()) return 0;
  size_t least = 0;
  for (size_t i = 1; i < points.size(); ++i)
    if (points[i].gap < points[least].gap) least = i;
  if (points.size() < 3) return -points[least].gap;
  const size_t first = std::min(least > 0 ? least - 1 : 0, points.size() - 3);
  const LinePairHistory &a = points[first], &b = points[first + 1], &c = points[first + 2];
  const double ab = (b.gap - a.gap) / (b.xi - a.xi), bc = (c.gap - b.gap) / (c.xi - b.xi);
  const double curve = (bc - ab) / (c.xi - a.xi);
  const bool joined = a.to >= b.from && b.to >= c.from;
  if (!joined || !(curve > 0)) return -points[least].gap;
  const double place = std::clamp(0.5 * (a.xi + b.xi - ab / curve), a.from, c.to);
  return -(a.gap + (place - a.xi) * (ab + curve * (place - b.xi)));
}

bool LinePairs::recouple(const Kinematics& committed, double h) {
  if (!candidates_.update(committed, h) && listed_) return false;
  // Histories go by element until the new list is there.
  for (Pair& p : pairs_)
    if (p.history) kept_[p.key] = std::move(p.history);
  pairs_.clear();
  listed_ = false;
  return true;
}

void LinePairs::reghost() {
  candidates_.locate();
  for (Pair& p : pairs_)
    if (p.history) kept_[p.key] = std::move(p.history);
  pairs_.clear();
  const auto& segments = candidates_.segments();
  for (const CandidatePair& c : candidates_.pairs()) {
    Pair& p = pairs_.emplace_back();
    p.a = c.a, p.b = c.b, p.counted = c.counted;
    p.key = {segments[static_cast<size_t>(c.a)].global, segments[static_cast<size_t>(c.b)].global};
    p.law = law(p.key.first, p.key.second);
    if (const auto k = kept_.find(p.key); k != kept_.end()) p.history = std::move(k->second);
  }
  kept_.clear();
  listed_ = true;
}

void LinePairs::prepare(const Kinematics& committed, double) {
  const size_t n = candidates_.segments().size();
  start_.resize(n);
  for (size_t i = 0; i < n; ++i) start_[i] = ends(committed, static_cast<int>(i));
  rods_ = rods(committed);
  for (Pair& p : pairs_) {
    const Rod &a = rods_[static_cast<size_t>(p.a)], &b = rods_[static_cast<size_t>(p.b)];
    p.clear = closest_points_of_segments(a.x1, a.x2, b.x1, b.x2).distance - a.sagitta - b.sagitta -
              p.law.reach - p.law.normal.smoothing;
  }
}

std::vector<LinePairs::Rod> LinePairs::rods(const Kinematics& at) const {
  std::vector<Rod> out(start_.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = rod(at, static_cast<int>(i));
  return out;
}

// Whether the surfaces, which were `clear` apart, may have met since the start of the step.
bool LinePairs::met(const Pair& p, const std::vector<Rod>& is) const {
  const auto moved = [&](int segment) {
    const size_t i = static_cast<size_t>(segment);
    return std::max((is[i].x1 - rods_[i].x1).norm(), (is[i].x2 - rods_[i].x2).norm()) + is[i].sagitta;
  };
  return moved(p.a) + moved(p.b) >= p.clear;
}

bool LinePairs::near(const Pair& p, const std::vector<Rod>& is) const {
  if (!met(p, is)) return false;
  const Rod &a = is[static_cast<size_t>(p.a)], &b = is[static_cast<size_t>(p.b)];
  return closest_points_of_segments(a.x1, a.x2, b.x1, b.x2).distance - a.sagitta - b.sagitta <
         p.law.reach + p.law.normal.smoothing;
}

template <class What>
void LinePairs::sides(const Pair& pair, const PairAxis& A, const PairAxis& B, bool moves, bool convex,
                      const What& what) const {
  static const std::vector<LinePairHistory> nothing;
  LinePairSide::Settings s;
  s.law = pair.law;
  if (!friction_on_) s.law.friction = {};
  s.moves = moves, s.convex = convex;
  for (size_t k = 0; k < kParts; ++k) {
    const bool swapped = k >= 3;
    const FootOf part = static_cast<FootOf>(k % 3);
    const int master = swapped ? pair.key.first : pair.key.second;
    if (part != FootOf::element && !joint(master, part == FootOf::second_end)) continue;
    const int slave = swapped ? pair.key.second : pair.key.first;
    s.slave_radius = elements_[static_cast<size_t>(slave)].radius;
    what(k, LinePairSide(swapped ? B : A, swapped ? A : B, part, s,
                         pair.history ? (*pair.history)[k] : nothing));
  }
}

void LinePairs::evaluate(const Kinematics& trial, Sink& sink) {
  const bool tangent = sink.wants_tangent();
  double f[24], K[576], C[576];
  const std::vector<Rod> is = rods(trial);
  for (Pair& pair : pairs_) {
    if (!near(pair, is)) continue;
    const size_t i = static_cast<size_t>(pair.a), j = static_cast<size_t>(pair.b);
    const PairAxis A(ends(trial, pair.a), start_[i]), B(ends(trial, pair.b), start_[j]);
    for (const bool swapped : {false, true}) {
      const PairAxis &slave = swapped ? B : A, &master = swapped ? A : B;
      LinePairForces g(slave.now.count(), master.now.count());
      bool any = false;
      sides(pair, A, B, trial.step > 0, sink.convex(), [&](size_t part, const LinePairSide& side) {
        if ((part >= 3) != swapped) return;
        const auto panels = side.panels();
        if (panels.empty()) return;
        any = true;
        side.add(panels, tangent, g);
      });
      if (!any) continue;
      std::fill(std::begin(f), std::end(f), 0.0);
      to_nodes(g, slave, master, f, nullptr, nullptr);
      if (tangent) {
        std::fill(std::begin(K), std::end(K), 0.0), std::fill(std::begin(C), std::end(C), 0.0);
        // The moment arms' turning is negative stiffness as well.
        if (sink.convex()) g.F.fill(Vec3::Zero());
        double same[24] = {};
        to_nodes(g, slave, master, same, K, C);
      }
      int blocks[8], n = 0;
      for (const bool second : {false, true}) {
        const ContactSegment& s =
            candidates_.segments()[static_cast<size_t>(second != swapped ? pair.b : pair.a)];
        for (const int node : {s.first, s.second}) {
          const int b = mesh_.block[static_cast<size_t>(node)];
          blocks[n++] = b;
          if ((second ? master : slave).beam()) blocks[n++] = b + 1;
        }
      }
      sink.add({blocks, static_cast<size_t>(n)}, f, tangent ? K : nullptr,
               tangent && trial.step > 0 ? C : nullptr, nullptr);
    }
  }
}

bool LinePairs::covers(const Kinematics& trial) const {
  if (!candidates_.covers(trial)) return false;
  if (start_.size() != candidates_.segments().size()) return true;  // not prepared: nothing to compare with
  const std::vector<Rod> is = rods(trial);
  return std::none_of(pairs_.begin(), pairs_.end(), [&](const Pair& p) {
    return met(p, is) && (passes(p, trial, is) || !resolved(p, trial, is));
  });
}

// Whether the axes cross, or nearly, on their straight way from the start of the step.
bool LinePairs::passes(const Pair& p, const Kinematics& trial, const std::vector<Rod>& is) const {
  const size_t i = static_cast<size_t>(p.a), j = static_cast<size_t>(p.b);
  const AxisShape a0(start_[i]), b0(start_[j]), a1(ends(trial, p.a)), b1(ends(trial, p.b));
  // Pieces whose chords are within a twentieth of the radii.
  const double near_enough = 0.05 * p.law.reach;
  const auto pieces = [&](double sagitta) {
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(sagitta / near_enough))), 1, 16);
  };
  const double bend_a = std::max(rods_[i].sagitta, is[i].sagitta),
               bend_b = std::max(rods_[j].sagitta, is[j].sagitta);
  const int m = pieces(bend_a), n = pieces(bend_b);
  const auto piece = [](const AxisShape& s0, const AxisShape& s1, int k, int of) {
    const double x = k / static_cast<double>(of), y = (k + 1) / static_cast<double>(of);
    return MovingSegment{s0.point(x), s0.point(y), s1.point(x), s1.point(y)};
  };
  for (int k = 0; k < m; ++k) {
    const MovingSegment A = piece(a0, a1, k, m);
    for (int l = 0; l < n; ++l) {
      const MovingSegment B = piece(b0, b1, l, n);
      // Lines that lie deep in each other already may stay so.
      const double was = closest_points_of_segments(A.from0, A.to0, B.from0, B.to0).distance;
      double least = std::min(kThrough * p.law.reach, 0.5 * was);
      if (!(trial.step > 0)) {
        // Axes may cross from the start: then no side is the right one.
        if (was < kNoSide * p.law.reach) continue;
        least = std::min(kStaticDepth * p.law.reach, 0.9 * was);
      }
      if (!(least > 0) || first_approach(A, B, least, 0.05 * least) <= 1) return true;
    }
  }
  return false;
}

// Relative speed along the line between the nearest points of the chords, m/s (> 0: they part), and the gap,
// m.
LinePairs::Nearest LinePairs::nearest(const Pair& p, const AxisEnds& a, const AxisEnds& b) const {
  const SegmentPair c = closest_points_of_segments(a.x1, a.x2, b.x1, b.x2);
  if (!(c.distance > 0)) return {};
  const Vec3 v = (1 - c.s) * a.v1 + c.s * a.v2 - (1 - c.t) * b.v1 - c.t * b.v2;
  return {v.dot(c.difference) / c.distance, c.distance - p.law.reach};
}

// Relative acceleration of the middles along the line between them, m/s²: at the turning point of a blow
// there is no speed.
double LinePairs::acceleration(const Pair& p, const Kinematics& at) const {
  const auto mean = [&](std::span<const Vec3> v, int segment) -> Vec3 {
    const ContactSegment& s = candidates_.segments()[static_cast<size_t>(segment)];
    return 0.5 * (v[static_cast<size_t>(s.first)] + v[static_cast<size_t>(s.second)]);
  };
  const AxisEnds &a = start_[static_cast<size_t>(p.a)], &b = start_[static_cast<size_t>(p.b)];
  const SegmentPair c = closest_points_of_segments(a.x1, a.x2, b.x1, b.x2);
  return c.distance > 0 ? (mean(at.a, p.a) - mean(at.a, p.b)).dot(c.difference) / c.distance : 0;
}

// 1/omega of the two masses on the contact, s.
double LinePairs::slowness(const Pair& p) const {
  const double ma = elements_[static_cast<size_t>(p.key.first)].mass_per_length,
               mb = elements_[static_cast<size_t>(p.key.second)].mass_per_length;
  return std::sqrt(ma * mb / (ma + mb) / p.law.normal.stiffness);
}

// kg, of the two on their contact, and what their line bears, J. The stretch that touches is at most one of
// the elements.
double LinePairs::mass(const Pair& p) const {
  const auto [i, j] = p.key;
  const double ma = elements_[static_cast<size_t>(i)].mass_per_length,
               mb = elements_[static_cast<size_t>(j)].mass_per_length;
  const auto& e = mesh_.mesh->elements;
  return ma * mb / (ma + mb) * std::min(e[static_cast<size_t>(i)].length, e[static_cast<size_t>(j)].length);
}

double LinePairs::bears(const Pair& p) const {
  if (bearable_.empty()) return 0;
  const auto& e = mesh_.mesh->elements;
  return std::min(bearable_[static_cast<size_t>(e[static_cast<size_t>(p.key.first)].line)],
                  bearable_[static_cast<size_t>(e[static_cast<size_t>(p.key.second)].line)]);
}

// A step in which they meet or part fast enough to press in beyond the ramp, and with more energy than can be
// borne, is no longer than a third of the contact's period.
bool LinePairs::resolved(const Pair& p, const Kinematics& trial, const std::vector<Rod>& is) const {
  const size_t i = static_cast<size_t>(p.a), j = static_cast<size_t>(p.b);
  const double slow = slowness(p);
  if (trial.step <= (1 + 1e-9) / kLeastSteps * 2 * M_PI * slow || (!p.history && !near(p, is))) return true;
  const double v0 = nearest(p, start_[i], start_[j]).speed,
               v1 = nearest(p, ends(trial, p.a), ends(trial, p.b)).speed;
  const double v = std::max(std::abs(v0), std::abs(v1));
  return v * slow <= 2 * p.law.normal.smoothing || 0.5 * mass(p) * v * v <= bears(p);
}

// An impact is followed, and no line is carried deeper into another than half the radii at the speed it has.
void LinePairs::limit_step(const Kinematics& at, Strikes& to) const {
  for (const Pair& p : pairs_) {
    const size_t i = static_cast<size_t>(p.a), j = static_cast<size_t>(p.b);
    const Nearest c = nearest(p, start_[i], start_[j]);
    const double ramp = p.law.normal.smoothing,
                 apart = std::max(c.gap - rods_[i].sagitta - rods_[j].sagitta, 0.0);
    if (c.speed < 0) to.limit((apart + kDeep * p.law.reach) / -c.speed);
    if (!p.counted) continue;
    Approach a{std::max(apart - ramp, 0.0), -c.speed, acceleration(p, at)};
    if (p.history) a.gap = -ramp - std::max(deepest_of((*p.history)[0]), deepest_of((*p.history)[3]));
    const auto& e = mesh_.mesh->elements;
    to.add(strike(slowness(p), 2 * ramp, mass(p), a), e[static_cast<size_t>(p.key.first)].line,
           e[static_cast<size_t>(p.key.second)].line);
  }
}

void LinePairs::commit(const Kinematics& accepted) {
  const std::vector<Rod> is = rods(accepted);
  for (Pair& pair : pairs_) {
    if (!near(pair, is) && !pair.history) continue;
    const size_t i = static_cast<size_t>(pair.a), j = static_cast<size_t>(pair.b);
    const PairAxis A(ends(accepted, pair.a), start_[i]), B(ends(accepted, pair.b), start_[j]);
    auto next = std::make_unique<History>();
    bool any = false;
    sides(pair, A, B, accepted.step > 0, false, [&](size_t part, const LinePairSide& side) {
      side.keep(side.panels(), (*next)[part]);
      any |= !(*next)[part].empty();
    });
    if (pair.counted) {
      for (const size_t part : {0, 3}) {
        const double depth = deepest_of((*next)[part]);
        if (depth > deepest_.depth) deepest_ = {depth, accepted.time, pair.key.first, pair.key.second};
      }
      if (accepted.step > 0) account(pair, A, B, *next);
    }
    pair.history = any ? std::move(next) : nullptr;
  }
}

// Trapezoid over the step, as for contact with volumes: half with the forces at its start, half with those at
// its end, each at their points. Of a step in which a point met or left only the part in touch counts.
void LinePairs::account(const Pair& pair, const PairAxis& A, const PairAxis& B, const History& next) {
  const double smoothing = pair.law.normal.smoothing, reach = pair.law.reach;
  const ContactSegment& first = candidates_.segments()[static_cast<size_t>(pair.a)];
  Account& sum = accounts_[static_cast<size_t>(first.first)];
  for (size_t k = 0; k < kParts; ++k) {
    const bool swapped = k >= 3;
    const PairAxis &slave = swapped ? B : A, &master = swapped ? A : B;
    const double share =
        elements_[static_cast<size_t>(swapped ? pair.key.second : pair.key.first)].radius / reach;
    const auto add = [&](const LinePairHistory& h, bool at_end) {
      const Vec3 was = slave.start.point(h.xi) - master.start.point(h.eta),
                 is = slave.now.point(h.xi) - master.now.point(h.eta);
      const Vec3 moved =
          is - share * (slave.turn_at(h.xi) * was) - (1 - share) * (master.turn_at(h.eta) * was);
      const double before = was.norm() - reach, after = is.norm() - reach;
      double part = 1;  // of the step in which they touch
      if (at_end && before > smoothing) part = (smoothing - h.gap) / (before - h.gap);
      if (!at_end && after > smoothing) part = (smoothing - h.gap) / (after - h.gap);
      const double w = 0.5 * std::clamp(part, 0.0, 1.0) * h.weight;
      sum.friction -= w * h.friction.dot(moved);
      sum.damping -= w * h.damping_force * (after - before);
    };
    if (pair.history)
      for (const LinePairHistory& h : (*pair.history)[k]) add(h, false);
    for (const LinePairHistory& h : next[k]) add(h, true);
  }
}

// In dynamics of the committed state. Statics asks for trials: its line search goes down this energy.
Energy LinePairs::energy(const Kinematics& at) const {
  Energy e;
  const std::vector<Rod> is = at.step > 0 ? std::vector<Rod>{} : rods(at);
  for (const Pair& p : pairs_) {
    if (!p.counted) continue;
    if (at.step > 0) {
      if (p.history)
        for (const auto& part : *p.history)
          for (const LinePairHistory& h : part) e.strain += h.weight * h.potential;
      continue;
    }
    if (!near(p, is)) continue;
    const PairAxis A(ends(at, p.a), start_[static_cast<size_t>(p.a)]),
        B(ends(at, p.b), start_[static_cast<size_t>(p.b)]);
    sides(p, A, B, false, false,
          [&](size_t, const LinePairSide& side) { e.strain += side.potential(side.panels()); });
  }
  for (const Account& a : accounts_) e.friction += a.friction, e.damping += a.damping;
  return e;
}

}  // namespace hawser
