#include "hawser/terms/volume_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

constexpr double kRounding = 1e-12;  // of coordinates, far above that of a distance

}  // namespace

// Candidates are the pairs whose box comes within the margin: twice what node and body move towards each
// other in the step at their present speed, and at least half an element. In statics (h = 0) a Newton
// iteration may go anywhere, so every pair is one.
void VolumeContact::prepare(const Kinematics& committed, double h) {
  pose_bodies(committed, start_poses_);
  std::vector<Pair> old;
  old.swap(pairs_);
  size_t known = 0;
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
    const size_t n = static_cast<size_t>(i);
    if (!(nodes_[n].radius > 0)) continue;
    const Vec3 tangent = line_.tangent(committed, i);
    for (int k = 0; k < static_cast<int>(volumes_.size()); ++k) {
      const auto key = [&](size_t at) { return std::pair(old[at].node, old[at].volume); };
      while (known < old.size() && key(known) < std::pair(i, k)) ++known;
      size_t end = known;
      while (end < old.size() && key(end) == std::pair(i, k)) ++end;
      const RigidPose& pose = start_poses_[body(k)];
      const Vec3 &x = committed.x[n], y = pose.to_body(x);
      const ContactLaw laws = node_law(i, k);
      const double touch = nodes_[n].radius + laws.normal.smoothing;
      const double motion = 2 * h * (committed.v[n] - pose.velocity_at(x)).norm();
      const double margin = std::max(motion, 0.5 * element_[n]);
      const double away = distance(boxes_[static_cast<size_t>(k)], y);
      if (h > 0 && away > touch + margin && model_ != NodeContact::gap) continue;
      if (left_out(i, k)) continue;

      Pair pair;
      pair.node = i;
      pair.volume = k;
      pair.touch = touch;
      pair.law = laws;
      std::array<History, SurfaceWalls::kMost> histories;
      bool more = false;
      for (size_t at = known; at < end; ++at) {
        const Pair& was = old[at];
        histories[static_cast<size_t>(was.slot)] = was.history;
        more = more || (was.slot > 0 && was.history.touches);
        if (was.slot > 0) continue;
        pair.centre = was.centre, pair.clear = was.clear;
      }
      pair.history = histories[0];
      pair.margin = margin;
      if (model_ == NodeContact::gap && !pair.history.paired) choose_gap(pair, y);
      pair.start.gap = std::max(margin, away - touch) + laws.normal.smoothing;  // a bound
      pair.start.point = y;
      pair.start.tangent = pose.rotation.conjugate() * tangent;
      if (model_ == NodeContact::elastic &&
          (more || !one_wall(pair, y, h > 0 ? motion : std::numeric_limits<double>::max()))) {
        pair.walls = std::make_shared<Walls>();
        pair.walls->committed = histories;
      }
      for (int slot = 0; slot < (pair.walls ? SurfaceWalls::kMost : 1); ++slot) {
        pair.slot = slot;
        if (slot > 0) pair.history = histories[static_cast<size_t>(slot)];
        pair.hint = pair.history.hint;
        pair.start.slip = pair.history.slip;
        pair.start.normal = pair.history.normal;
        if (pair.walls && pair.history.touches) pair.start.gap = -pair.history.depth;
        pair.start_known = !clear_of(pair, y);
        pairs_.push_back(pair);
        if (model_ != NodeContact::gap && !pair.walls && pair.start_known)
          questions_.add(k, pairs_.size() - 1, {y, pair.touch + margin, pair.hint});
      }
    }
  }
  questions_.ask(volumes_, [&](size_t i, std::optional<SurfacePoint>& p) {
    Pair& pair = pairs_[i];
    pair.asked = pair.start.point, pair.asked_distance = pair.touch + pair.margin, pair.seen = p;
  });
  for (Pair& pair : pairs_) {
    if (pair.walls || !pair.start_known) continue;  // which wall the gap is to be of, the trial says
    ContactTrial at;
    at.gap = pair.start.gap;
    locate(pair, pair.start.point, pair.margin, at);
    pair.start.gap = at.gap;
  }
}

// Of what was clear at the start, and touches all the same.
void VolumeContact::know_start(Pair& pair) const {
  if (pair.start_known) return;
  pair.start_known = true;
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  const auto p = surface.query(pair.start.point, pair.touch + pair.margin, pair.hint);
  if (p) pair.start.gap = p->distance - nodes_[static_cast<size_t>(pair.node)].radius;
}

double VolumeContact::clear_about(const Pair& pair, const Vec3& y, double distance) const {
  return volumes_[static_cast<size_t>(pair.volume)].surface->free_radius(y, distance) - pair.touch -
         kRounding * y.cwiseAbs().maxCoeff();
}

const std::optional<SurfacePoint>& VolumeContact::look(Pair& pair, const Vec3& y, double distance) const {
  if (distance == pair.asked_distance && y == pair.asked) return pair.seen;
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  const int wall = pair.walls ? see_wall(pair, y) : Walls::kAll;
  if (wall == Walls::kNone)
    pair.seen.reset();
  else if (wall == Walls::kAll)
    pair.seen = surface.query(y, distance, pair.hint);
  else
    pair.seen = surface.query_wall(pair.walls->near.of[static_cast<size_t>(wall)], y, distance);
  pair.asked = y, pair.asked_distance = distance;
  return pair.seen;
}

void VolumeContact::look_ahead(const Kinematics& at) {
  if (model_ == NodeContact::gap) return;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    Pair& pair = pairs_[i];
    const size_t n = static_cast<size_t>(pair.node);
    const Vec3 y = poses_[body(pair.volume)].to_body(at.x[n]);
    const double distance = pair.touch + 0.5 * element_[n];
    if (pair.walls || clear_of(pair, y) || (distance == pair.asked_distance && y == pair.asked)) continue;
    pair.asked = y, pair.asked_distance = distance;
    questions_.add(pair.volume, i, {y, distance, pair.hint});
  }
  questions_.ask(volumes_, [&](size_t i, std::optional<SurfacePoint>& p) { pairs_[i].seen = p; });
}

void VolumeContact::limit_step(const Kinematics& committed, Strikes& to) const {
  std::vector<SurfacePoint> met;
  for (const Pair& pair : pairs_) {
    if (pair.slot > 0) continue;
    const size_t n = static_cast<size_t>(pair.node), k = static_cast<size_t>(pair.volume);
    const RigidPose& pose = start_poses_[body(pair.volume)];
    const Vec3 v = pose.rotation.conjugate() * (committed.v[n] - pose.velocity_at(committed.x[n]));
    const double speed = v.norm();
    if (speed == 0) continue;
    // Look ahead as far as the node gets in half a second.
    const Vec3 y = pose.to_body(committed.x[n]);
    const double ahead = pair.touch + 0.5 * (element_[n] + speed);
    // Nothing is there, or nothing could come of it.
    const double radius = nodes_[n].radius,
                 room = pair.walls ? 0 : std::max(pair.clear - (y - pair.centre).norm(), 0.0);
    if (room * (1 - 1e-9) > ahead - pair.touch ||
        (!may_limit(radius, room, speed, to) &&
         !may_strike(pair.law.normal, nodes_[n].mass, radius, speed, committed.a[n].norm())))
      continue;
    met.clear();
    if (pair.walls) {
      met = nearest_on_walls(*volumes_[k].surface, y, ahead);
    } else if (pair.asked_distance >= ahead && pair.asked == y) {  // prepare() did
      if (pair.seen && pair.seen->distance <= ahead) met.push_back(*pair.seen);
    } else if (const auto p = volumes_[k].surface->query(y, ahead, pair.hint)) {
      met.push_back(*p);
    }
    for (const SurfacePoint& p : met) {
      const Approach at{p.distance - pair.touch, -p.normal.dot(v),
                        p.normal.dot(pose.rotation.conjugate() * committed.a[n])};
      limit_depth(nodes_[n].radius, at, to);
      to.add(strikes(pair.law.normal, nodes_[n].mass, 1, nodes_[n].radius, at),
             mesh_.nodes[static_cast<size_t>(global_[n])].line);
    }
  }
}

bool VolumeContact::locate(Pair& pair, const Vec3& y, double reach, ContactTrial& trial) const {
  if (model_ == NodeContact::gap) return locate_gap(pair, y, trial);
  if (clear_of(pair, y)) return false;
  const auto& p = look(pair, y, pair.touch + reach);
  pair.centre = y;
  pair.clear = clear_about(pair, y, p ? p->distance : pair.touch + reach);
  if (!p) return false;
  pair.hint = p->triangle;
  trial.point = y;
  trial.gap = p->distance - nodes_[static_cast<size_t>(pair.node)].radius;
  trial.normal = p->normal;
  trial.curvature = p->curvature;
  return p->distance < pair.touch;
}

PointContact VolumeContact::contact(Pair& pair, const Kinematics& at, bool derivatives, bool convex,
                                    ContactTrial& trial) {
  const size_t n = static_cast<size_t>(pair.node);
  const RigidPose& pose = poses_[body(pair.volume)];
  const Vec3& x = at.x[n];
  trial.point = pose.to_body(x);
  if (!locate(pair, trial.point, 0.5 * element_[n], trial)) return {};
  know_start(pair);
  if (at.step > 0) trial.velocity = pose.rotation.conjugate() * (at.v[n] - pose.velocity_at(x));
  if (convex) trial.curvature.setZero();  // -N H is the negative geometric stiffness of contact
  return volume_contact(applied(pair.law), pair.walls ? start(pair, trial.point) : pair.start, trial,
                        derivatives);
}

VolumeContact::Force VolumeContact::force(const Kinematics& trial, int pair, bool tangent, bool convex) {
  pose_bodies(trial, poses_);
  return resolve(pairs_[static_cast<size_t>(pair)], trial, tangent, convex);
}

VolumeContact::Force VolumeContact::resolve(Pair& p, const Kinematics& trial, bool tangent, bool convex) {
  ContactTrial at;
  const PointContact c = contact(p, trial, tangent, convex, at);
  Force f;
  if (c.normal.force == 0) return f;
  const RigidPose& pose = poses_[body(p.volume)];
  const Mat3 R = pose.rotation.toRotationMatrix();
  f.touches = true;
  f.total = R * c.force;
  f.friction = R * c.friction;
  if (tangent) {
    // Relative velocity in the body frame: u = R'(v - V) - omega x y.
    const Mat3 spin = hat(pose.rotation.conjugate() * pose.angular_velocity);
    f.K = -R * (c.by_point - (trial.step > 0 ? 1.0 : 0.0) * c.by_velocity * spin) * R.transpose();
    if (trial.step > 0) f.C = -R * c.by_velocity * R.transpose();
  }
  return f;
}

void VolumeContact::evaluate(const Kinematics& trial, Sink& sink) {
  pose_bodies(trial, poses_);
  look_ahead(trial);
  const bool tangent = sink.wants_tangent(), convex = sink.convex();
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  for (Pair& pair : pairs_) {
    Force f = resolve(pair, trial, tangent, convex);
    if (!f.touches) continue;
    const int block = block_[static_cast<size_t>(pair.node)];
    const Vec3 residual = -f.total;
    const RowMajor K = f.K, C = f.C;
    if (floats(pair.volume)) {
      const size_t n = static_cast<size_t>(pair.node);
      const LineBlock node{block, false, trial.x[n], trial.v[n], Mat3::Identity()};
      add_against_body(sink, {&node, 1}, floating_frame(pair.volume, trial), true, residual.data(),
                       tangent ? K.data() : nullptr, tangent && trial.step > 0 ? C.data() : nullptr);
      continue;
    }
    sink.add({&block, 1}, residual.data(), tangent ? K.data() : nullptr, tangent ? C.data() : nullptr,
             nullptr);
  }
}

// Evaluated again at the accepted state, so that what is kept belongs to it and to no other trial.
void VolumeContact::commit(const Kinematics& accepted) {
  pose_bodies(accepted, poses_);
  look_ahead(accepted);
  for (Pair& pair : pairs_) {
    ContactTrial at;
    const PointContact c = contact(pair, accepted, false, false, at);
    History next;
    if (c.normal.elastic != 0) {
      next = History(c, at.normal);
      next.touches = true;
      next.depth = std::max(0.0, -at.gap);
      next.hint = pair.hint;
    }
    accounts_[static_cast<size_t>(pair.node)].reaches(next.depth, accepted.time, pair.volume);
    if (pair.walls && c.normal.elastic != 0) pair.start.gap = start(pair, at.point).gap;
    if (accepted.step > 0 && (next.touches || pair.history.touches)) account(pair, next, at.point);
    next.paired = pair.history.paired, next.anchor = pair.history.anchor;
    next.direction = pair.history.direction;
    pair.history = next;
  }
  keep_raise();
}

// Trapezoid over the step, of which only the part in touch counts when the pair met or parted in it.
void VolumeContact::account(const Pair& pair, const History& next, const Vec3& y) {
  const StepOfBody step(start_poses_[body(pair.volume)], poses_[body(pair.volume)], !floats(pair.volume));
  const History& last = pair.history;
  const Vec3& y0 = pair.start.point;
  Account& sum = accounts_[static_cast<size_t>(pair.node)];
  double part = 1;
  const double smoothing = pair.law.normal.smoothing;
  if (!last.touches) {
    const double moved = std::max(pair.start.gap - smoothing, 0.0), deep = smoothing + next.depth;
    part = moved > 0 ? deep / (moved + deep) : 1;
  } else if (!next.touches) {
    const double away = last.normal.dot(y - y0), deep = std::max(smoothing - pair.start.gap, 0.0);
    part = away > deep ? deep / away : 1;
  }
  add_work(sum, step, last, step.R0, y0, y, part);
  add_work(sum, step, next, step.R1, y0, y, part);
  if (!raised(pair.volume)) return;
  // What the spring gave and has is not its own then: it was brought in.
  const auto gave = [&](const History& h) {
    return 0.5 * part * (h.normal_force - h.damping_force) * h.normal.dot(y - y0);
  };
  sum.work += gave(last) + gave(next) + next.potential - last.potential;
}

}  // namespace hawser
