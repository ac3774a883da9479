#include "hawser/terms/line_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/math/so3.hpp"

namespace hawser {

namespace {

// What is found free is looked at in up to so many places more to keep that much of it.
constexpr int kPlaces = 4;
constexpr double kRoom = 0.5;

}  // namespace

// The gap along the axis less the smoothing, as the search for stretches sees it, and how far the volume is.
class LineContact::Gap final : public AxisGapFunction {
 public:
  Gap(const LineContact& contact, Pair& pair, const AxisShape& shape, const RigidPose& pose,
      std::vector<FreePlace>& places)
      : contact_(contact), pair_(pair), shape_(shape), pose_(pose), places_(places) {
    places_.clear();
  }

  AxisGap at(double xi, double within) override {
    if (xi == 0.5 && middle_) return *middle_;
    const Vec3 y = pose_.to_body(shape_.point(xi));
    const auto p = contact_.see(pair_, y, pair_.touch + within);
    const double gap = p ? p->distance - pair_.touch : within;
    keep(xi, y, gap);
    if (!p) return {within, 0};
    pair_.hint = p->triangle;
    return {gap, (pose_.rotation * p->normal).dot(shape_.slope(xi))};
  }
  void set_middle(double gap, const std::optional<SurfacePoint>& p) {
    middle_ = {gap, p ? (pose_.rotation * p->normal).dot(shape_.slope(0.5)) : 0};
    keep(0.5, pose_.to_body(shape_.point(0.5)), gap);
  }

 private:
  void keep(double xi, const Vec3& y, double gap) {
    const Surface& surface = *contact_.volumes_[static_cast<size_t>(pair_.volume)].surface;
    places_.push_back({xi, surface.free_radius(y, gap + pair_.touch)});
  }
  const LineContact& contact_;
  Pair& pair_;
  const AxisShape& shape_;
  const RigidPose& pose_;
  std::vector<FreePlace>& places_;
  std::optional<AxisGap> middle_;
};

// Candidates as in the `nodes` method, from the element's middle. In statics (h = 0) every pair is one.
void LineContact::prepare(const Kinematics& committed, double h) {
  pose_bodies(committed, start_poses_);
  start_x_.assign(committed.x.begin(), committed.x.end());
  start_q_.assign(committed.q.begin(), committed.q.end());
  groups_.clear();
  std::vector<Pair> old;
  old.swap(pairs_);
  pairs_.reserve(old.size());
  size_t known = 0;
  for (int e = 0; e < static_cast<int>(elements_.size()); ++e) {
    const LineContactElement& element = elements_[static_cast<size_t>(e)];
    if (!(element.radius > 0)) continue;
    const AxisEnds at = ends(committed, e);
    const AxisShape shape(at);
    for (int k = 0; k < static_cast<int>(volumes_.size()); ++k) {
      const auto key = [&](size_t i) { return std::pair(old[i].element, old[i].volume); };
      while (known < old.size() && key(known) < std::pair(e, k)) ++known;
      size_t end = known;
      while (end < old.size() && key(end) == std::pair(e, k)) ++end;
      const RigidPose& pose = start_poses_[body(k)];
      const ContactLaw laws = element_law(static_cast<size_t>(e), volumes_[static_cast<size_t>(k)].settings);
      const double touch = element.radius + laws.normal.smoothing;
      const double speed =
          std::max((at.v1 - pose.velocity_at(at.x1)).norm(), (at.v2 - pose.velocity_at(at.x2)).norm());
      const double margin = std::max(2 * h * speed, 0.5 * length(e));
      const double away = distance(boxes_[static_cast<size_t>(k)], pose.to_body(shape.point(0.5)));
      if (h > 0 && away > touch + margin + 0.5 * shape.reach()) continue;
      const Share part = part_of(e, k);
      if (part.none()) continue;

      Pair first;
      first.element = e;
      first.volume = k;
      first.touch = touch;
      first.part = part;
      first.levels = contact_levels(length(e), element.radius);
      first.law = laws;
      first.start = shape;
      std::vector<std::vector<Point>> histories;
      for (size_t i = known; i < end; ++i) {
        Pair& was = old[i];
        histories.resize(static_cast<size_t>(was.slot) + 1);
        histories.back() = std::move(was.history);
        if (was.slot > 0) continue;
        first.hint = was.hint, first.ahead = was.ahead, first.free = was.room();
        first.one_chord = was.one_chord, first.one_reach = was.one_reach, first.one = was.one;
        // What was found on all of the surface is found again; of a wall it may be another.
        // So are panels of what touched: they part as at the start of this step.
        if (!was.walls && histories.back().empty()) first.found = std::move(was.found);
      }
      // Pairs that did not touch are in no checkpoint.
      while (!histories.empty() && histories.back().empty()) histories.pop_back();
      const bool one =
          histories.size() < 2 &&
          one_wall(first, shape, pose, h > 0 ? 2 * h * speed : std::numeric_limits<double>::max());
      if (one) {
        if (!histories.empty()) first.history = std::move(histories[0]);
        pairs_.push_back(std::move(first));
        continue;
      }
      const size_t touched = std::max(histories.size(), size_t{1});
      histories.resize(SurfaceWalls::kMost);
      first.found = {};
      first.walls = std::make_shared<Walls>();
      first.walls->free = first.free;
      for (size_t slot = 0; slot < touched; ++slot) {
        Pair& pair = pairs_.emplace_back(first);
        pair.slot = static_cast<int>(slot);
        pair.history = histories[slot];
      }
      first.walls->committed = std::move(histories);
    }
  }
}

void LineContact::keep_free(const Pair& pair, const AxisShape& shape, const RigidPose& pose,
                            std::vector<FreePlace>& places) const {
  const auto by_xi = [](const FreePlace& a, const FreePlace& b) { return a.xi < b.xi; };
  std::sort(places.begin(), places.end(), by_xi);
  double least = std::numeric_limits<double>::infinity(), worst = 0;
  for (const FreePlace& p : places) least = std::min(least, p.distance - pair.touch);
  if (!(least > 0)) return;
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  double free = least_distance(places, shape.reach(), shape.bend_bound(), worst) - pair.touch;
  for (int i = 0; i < kPlaces && free < kRoom * least; ++i) {
    const Vec3 y = pose.to_body(shape.point(worst));
    const double within = pair.touch + 2 * least;
    const auto p = surface.query(y, within, pair.hint);
    const FreePlace more{worst, surface.free_radius(y, p ? p->distance : within)};
    places.insert(std::upper_bound(places.begin(), places.end(), more, by_xi), more);
    least = std::min(least, more.distance - pair.touch);
    free = least_distance(places, shape.reach(), shape.bend_bound(), worst) - pair.touch;
  }
  pair.room().offer(points(shape, pose), free);
}

SurfaceQuestion LineContact::middle(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const {
  return {pose.to_body(shape.point(0.5)), pair.touch + 2 * shape.reach(), pair.hint};
}

const std::vector<ContactStretch>& LineContact::touched_before(Pair& pair) const {
  static const std::vector<ContactStretch> kNone;
  if (pair.wall()) return kNone;
  if (pair.before) return *pair.before;
  pair.before.emplace();
  const auto touched = [](const std::vector<Point>& history) { return !history.empty(); };
  if (!touched(pair.history) &&
      !(pair.walls && std::any_of(pair.walls->committed.begin(), pair.walls->committed.end(), touched)))
    return kNone;
  constexpr int kCloser = 2;  // halvings more than in a trial: what is not seen here is filled there
  std::vector<FreePlace> places;
  Gap gap(*this, pair, pair.start, start_poses_[body(pair.volume)], places);
  *pair.before = contact_stretches(gap, {pair.start.reach(), pair.touch, pair.start.bend_bound()},
                                   pair.levels + kCloser);
  return *pair.before;
}

std::vector<ContactStretch> LineContact::locate(Pair& pair, const AxisShape& shape, const RigidPose& pose,
                                                const std::optional<SurfacePoint>& middle) const {
  const double reach = shape.reach();
  if (middle) pair.hint = middle->triangle;
  const std::vector<ContactStretch>& before = touched_before(pair);
  Gap gap(*this, pair, shape, pose, places_);
  const double middle_gap = middle ? middle->distance - pair.touch : 2 * reach;
  gap.set_middle(middle_gap, middle);
  std::vector<ContactStretch> stretches;
  if (middle_gap < 0.5 * reach)
    stretches = contact_stretches(gap, {reach, pair.touch, shape.bend_bound()}, pair.levels,
                                  middles(hollows(before)));
  // Of one wall alone it says nothing of the others.
  if (stretches.empty() && !pair.wall()) keep_free(pair, shape, pose, places_);
  std::vector<ContactStretch> panels =
      cut_stretches(as_parted_before(stretches, before, pair.found.filled), pair.levels);
  if (!pair.part.all()) keep_part(pair.part, panels);
  return panels;
}

// The end of the part is one of the material: it does not move with the gap.
void LineContact::keep_part(const Share& part, std::vector<ContactStretch>& panels) {
  for (ContactStretch& s : panels) {
    if (s.from < part.from) s.from = part.from, s.from_moves = false;
    if (s.to > part.to) s.to = part.to, s.to_moves = false;
  }
  std::erase_if(panels, [](const ContactStretch& s) { return !(s.from < s.to); });
}

SurfacePoint LineContact::nothing() {
  SurfacePoint p;
  p.distance = std::numeric_limits<double>::max();
  return p;
}

// Whether what was found belongs to another trial; then it is of this one from now on.
bool LineContact::renew(Found& f, const AxisShape& shape, const RigidPose& pose) {
  if (f.known && f.shape.same_axis(shape) && f.position == pose.position &&
      f.rotation.coeffs() == pose.rotation.coeffs())
    return false;
  f.known = true, f.shape = shape, f.position = pose.position, f.rotation = pose.rotation;
  f.panels.clear(), f.filled.clear(), f.points.clear();
  return true;
}

void LineContact::gauss_points(const Pair& pair, const AxisShape& shape, const RigidPose& pose,
                               std::vector<SurfaceQuestion>& ask) {
  ask.clear();
  for (const ContactStretch& s : pair.found.panels)
    for (const double place : ContactRule::place())
      ask.push_back({pose.to_body(shape.point(s.from + (s.to - s.from) * place)), pair.touch, pair.hint});
}

const LineContact::Found& LineContact::find(Pair& pair, const AxisShape& shape, const RigidPose& pose) const {
  Found& f = pair.found;
  if (clear(pair, shape, pose) || !renew(f, shape, pose)) return f;
  if (pair.walls) see_walls(pair, shape, pose);
  if (pair.idle()) return f;
  const SurfaceQuestion first = middle(pair, shape, pose);
  f.panels = locate(pair, shape, pose, see(pair, first.point, first.max_distance));
  std::vector<SurfaceQuestion> ask;
  gauss_points(pair, shape, pose, ask);
  for (const SurfaceQuestion& q : ask) {
    const auto p = see(pair, q.point, q.max_distance);
    if (p) pair.hint = p->triangle;
    f.points.push_back(p ? *p : nothing());
  }
  return f;
}

ContactTrial LineContact::trial(const Pair& pair, const AxisShape& shape, const RigidPose& pose, double xi,
                                bool moves, const SurfacePoint& p) const {
  const Vec3 x = shape.point(xi);
  ContactTrial trial;
  trial.point = pose.to_body(x);
  trial.gap = p.distance - elements_[static_cast<size_t>(pair.element)].radius;
  trial.normal = p.normal;
  trial.curvature = p.curvature;
  if (moves) trial.velocity = pose.rotation.conjugate() * (shape.velocity(xi) - pose.velocity_at(x));
  return trial;
}

LineContact::Origin LineContact::origin(Pair& pair, double xi) const {
  Origin o;
  o.xi = xi;
  for (const Point& p : pair.past())
    if (p.from <= xi && xi <= p.to) return o;
  const double within = 2 * pair.start.reach() + length(pair.element);
  const Vec3 y = start_poses_[body(pair.volume)].to_body(pair.start.point(xi));
  const auto p = see(pair, y, pair.touch + within, true);
  o.touched = false;
  o.gap = p ? p->distance - elements_[static_cast<size_t>(pair.element)].radius
            : within + pair.law.normal.smoothing;
  if (p) o.gradient = p->normal;
  return o;
}

// Slip is interpolated between the Gauss points of one stretch. Material that did not touch has none.
ContactStart LineContact::start(const Pair& pair, const Origin& from, ContactRates* rates) const {
  const RigidPose& pose = start_poses_[body(pair.volume)];
  const Quat back = pose.rotation.conjugate();
  ContactStart s;
  s.point = pose.to_body(pair.start.point(from.xi));
  const Vec3 slope = back * pair.start.slope(from.xi);
  s.tangent = slope.normalized();
  if (rates) {
    rates->start_point = slope;
    const Vec3 bend = back * pair.start.bend(from.xi);
    rates->start_tangent = (bend - s.tangent * s.tangent.dot(bend)) / slope.norm();
  }
  if (!from.touched) {
    s.gap = from.gap;
    if (rates) rates->start_gap = from.gradient.dot(slope);
    return s;
  }
  const std::vector<Point>& past = pair.past();
  const auto after = std::find_if(past.begin(), past.end(), [&](const Point& p) { return p.xi > from.xi; });
  const Point* b = after != past.end() ? &*after : nullptr;
  const Point* a = after != past.begin() ? &*(after - 1) : nullptr;
  if (a && b && a->from != b->from && a->to != b->from) (from.xi <= a->to ? b : a) = nullptr;
  if (!a || !b) {
    const Point& p = a ? *a : *b;
    s.slip = p.slip, s.normal = p.normal;
    return s;
  }
  const double gap = b->xi - a->xi, t = (from.xi - a->xi) / gap;
  const SlipBetween between = slip_between(a->slip, a->normal, b->slip, b->normal, t, rates != nullptr);
  s.slip = between.slip, s.normal = between.normal;
  if (rates) rates->start_slip = between.slip_by_t / gap, rates->start_normal = between.normal_by_t / gap;
  return s;
}

LineContact::Rolled LineContact::rolled(const Pair& pair, const AxisShape& shape) const {
  Rolled r;
  r.on = elements_[static_cast<size_t>(pair.element)].rolling && shape.count() == AxisShape::kMost &&
         friction_on_ && pair.law.friction.active();
  if (!r.on) return r;
  const Quat before = start_poses_[body(pair.volume)].rotation.conjugate(),
             after = poses_[body(pair.volume)].rotation.conjugate();
  for (size_t i = 0; i < 2; ++i)
    r.ends[i] = axis_roll(before * pair.start.turn(i), after * shape.turn(i),
                          elements_[static_cast<size_t>(pair.element)].tangent);
  return r;
}

// Ends that move with the unknowns: s is where gap(s, X) = smoothing, so ds = -n . dx(s) / (n . x'(s)), and
// the places and weights of the Gauss points follow it.
struct LineContact::Moving {
  bool on = false;
  AxisShape::Weights H{};
  Vec3 by_axis = Vec3::Zero();                 // ds / dx(s), 1/m
  std::array<Vec3, AxisShape::kMost> force{};  // dF_j / ds
  std::array<double, 2> torque{};              // dT_i / ds
};

// Adds the forces of one panel. The tangent is exact, moving ends included.
void LineContact::panel(Pair& pair, const AxisShape& shape, const RigidPose& pose, size_t panel, bool moves,
                        const Sink& sink, AxisShape::Generalised& g, Rolled& rolled) const {
  const ContactStretch& s = pair.found.panels[panel];
  const bool tangent = sink.wants_tangent(), convex = sink.convex();
  const double L = length(pair.element), span = s.to - s.from;
  const ContactLaw laws = applied(pair.law);
  const size_t n = static_cast<size_t>(shape.count());
  const Mat3 R = pose.rotation.toRotationMatrix();
  const Quat back = pose.rotation.conjugate();
  // Relative velocity in the body frame: u = R'(v - V) - omega x y.
  const Mat3 spin = hat(pose.rotation.conjugate() * pose.angular_velocity);
  Moving ends[2];
  for (size_t i = 0; i < 2 && tangent && !convex; ++i) {
    if (!(i ? s.to_moves : s.from_moves)) continue;
    const double xi = i ? s.to : s.from;
    const auto p = see(pair, pose.to_body(shape.point(xi)), pair.touch + 1e-9);
    if (!p) continue;
    const Vec3 normal = R * p->normal;
    const double slope = normal.dot(shape.slope(xi));
    if (std::abs(slope) < 1e-9 * shape.reach()) continue;
    ends[i].on = true;
    ends[i].H = shape.functions(xi);
    ends[i].by_axis = -normal / slope;
    ends[i].force.fill(Vec3::Zero());
  }
  for (size_t q = 0; q < ContactRule::kPoints; ++q) {
    const double place = ContactRule::place()[q], weight = ContactRule::weight()[q];
    const double xi = s.from + span * place, w = L * span * weight;
    const SurfacePoint& seen_there = pair.found.points[ContactRule::kPoints * panel + q];
    if (!seen(pair, seen_there)) continue;
    ContactTrial trial = this->trial(pair, shape, pose, xi, moves, seen_there);
    if (convex) trial.curvature.setZero();  // -N H is the negative geometric stiffness of contact
    Origin from;
    ContactStart begin;
    ContactRates rates;
    if (laws.friction.active()) {
      from = origin(pair, xi);
      begin = start(pair, from, ends[0].on || ends[1].on ? &rates : nullptr);
    }
    if (rolled.on)
      trial.roll = rolled.angle(xi), trial.lever = elements_[static_cast<size_t>(pair.element)].radius;
    const PointContact c = volume_contact(laws, begin, trial, tangent);
    if (!(c.normal.force > 0)) continue;
    const AxisShape::Weights H = shape.functions(xi);
    const Vec3 f = -(R * c.force);
    for (size_t j = 0; j < n; ++j) g.F[j] += w * H[j] * f;
    // A roll by da moves the line's surface by arm da: its work is the torque's.
    const Vec3 arm = -trial.lever * begin.tangent.cross(trial.normal);
    const std::array<double, 2> N{1 - xi, xi};
    const double torque = -arm.dot(c.force);
    for (size_t i = 0; i < 2; ++i) rolled.forces.T[i] += w * N[i] * torque;
    if (!tangent) continue;
    const Mat3 K = -w * R * (c.by_point - (moves ? 1.0 : 0.0) * c.by_velocity * spin) * R.transpose();
    const Mat3 C = moves ? Mat3(-w * R * c.by_velocity * R.transpose()) : Mat3(Mat3::Zero());
    for (size_t j = 0; j < n; ++j)
      for (size_t k = 0; k < n; ++k) {
        g.K[j][k] += H[j] * H[k] * K;
        if (moves) g.C[j][k] += H[j] * H[k] * C;
      }
    if (rolled.on) {
      AxisShape::Rolling& r = rolled.forces;
      const Mat3 by_point = c.by_point - (moves ? 1.0 : 0.0) * c.by_velocity * spin;
      const Vec3 by_x = -w * (R * (by_point.transpose() * arm +
                                   trial.lever * trial.curvature * begin.tangent.cross(c.force))),
                 by_v = moves ? Vec3(-w * (R * (c.by_velocity.transpose() * arm))) : Vec3(Vec3::Zero()),
                 by_roll = -w * (R * c.by_roll);
      for (size_t i = 0; i < 2; ++i) {
        for (size_t k = 0; k < n; ++k) {
          r.by_X[i][k] += N[i] * H[k] * by_x, r.by_V[i][k] += N[i] * H[k] * by_v;
          r.force_by_roll[k][i] += N[i] * H[k] * by_roll;
        }
        for (size_t k = 0; k < 2; ++k) r.by_roll[i][k] -= w * N[i] * N[k] * arm.dot(c.by_roll);
      }
    }
    if (!ends[0].on && !ends[1].on) continue;

    rates.point = back * shape.slope(xi);
    if (moves)
      rates.velocity = back * (shape.velocity_slope(xi) - pose.angular_velocity.cross(shape.slope(xi)));
    rates.roll = rolled.ends[1].angle - rolled.ends[0].angle;
    const Vec3 along = contact_force_along(laws, begin, trial, rates), slope = -(R * along);
    const Vec3 arm_along = -trial.lever * (rates.start_tangent.cross(trial.normal) +
                                           begin.tangent.cross(trial.curvature * rates.point));
    const double torque_along = -(arm_along.dot(c.force) + arm.dot(along));
    const AxisShape::Weights dH = shape.derivatives(xi);
    for (size_t i = 0; i < 2; ++i) {
      if (!ends[i].on) continue;
      const double stretch = i ? weight : -weight, shift = span * weight * (i ? place : 1 - place);
      for (size_t j = 0; j < n; ++j)
        ends[i].force[j] += L * ((stretch * H[j] + shift * dH[j]) * f + shift * H[j] * slope);
      for (size_t j = 0; j < 2 && rolled.on; ++j)
        ends[i].torque[j] +=
            L * ((stretch * N[j] + (j ? shift : -shift)) * torque + shift * N[j] * torque_along);
    }
  }
  for (const Moving& m : ends)
    for (size_t j = 0; j < 2 && m.on && rolled.on; ++j)
      for (size_t k = 0; k < n; ++k) rolled.forces.by_X[j][k] += m.H[k] * m.torque[j] * m.by_axis;
  for (const Moving& m : ends)
    for (size_t j = 0; j < n && m.on; ++j)
      for (size_t k = 0; k < n; ++k) g.K[j][k] += m.H[k] * m.force[j] * m.by_axis.transpose();
}

void LineContact::evaluate(const Kinematics& trial, Sink& sink) {
  pose_bodies(trial, poses_);
  const bool tangent = sink.wants_tangent();
  double f[12], K[144], C[144];
  find_all(trial);
  for (size_t k = 0; k < near_.size(); ++k) {
    Pair& pair = pairs_[near_[k]];
    const AxisShape& shape = shapes_[k];
    const RigidPose& pose = poses_[body(pair.volume)];
    const size_t panels = pair.found.panels.size();
    if (!panels) continue;
    AxisShape::Generalised g;
    Rolled roll = rolled(pair, shape);
    for (size_t i = 0; i < panels; ++i) panel(pair, shape, pose, i, trial.step > 0, sink, g, roll);
    std::fill(std::begin(f), std::end(f), 0.0);
    std::fill(std::begin(K), std::end(K), 0.0), std::fill(std::begin(C), std::end(C), 0.0);
    shape.to_nodes(g, f, nullptr, nullptr);
    if (roll.on) shape.to_nodes(roll.forces, roll.ends, !sink.convex(), f, tangent ? K : nullptr, C);
    if (tangent) {
      // The moment arms' turning is negative stiffness as well.
      if (sink.convex()) g.F.fill(Vec3::Zero());
      double same[12] = {};
      shape.to_nodes(g, same, K, C);
    }
    const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
    const int a = mesh_.block[static_cast<size_t>(e.first)], b = mesh_.block[static_cast<size_t>(e.second)];
    const int blocks[4] = {a, shape.count() == 4 ? a + 1 : b, b, b + 1};
    if (floats(pair.volume)) {
      std::array<LineBlock, 4> line;
      for (size_t i = 0; i < 4; ++i) {
        const bool beam = shape.count() == 4;
        const size_t n = static_cast<size_t>(i < (beam ? 2U : 1U) ? e.first : e.second);
        line[i] = {blocks[i], beam && i % 2 == 1, trial.x[n], trial.v[n], trial.q[n].toRotationMatrix()};
      }
      add_against_body(sink, {line.data(), static_cast<size_t>(shape.count())},
                       floating_frame(pair.volume, trial), e.counted, f, tangent ? K : nullptr,
                       tangent && trial.step > 0 ? C : nullptr);
      continue;
    }
    sink.add({blocks, static_cast<size_t>(shape.count())}, f, tangent ? K : nullptr,
             tangent && trial.step > 0 ? C : nullptr, nullptr);
  }
}

}  // namespace hawser
