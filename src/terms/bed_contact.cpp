// The class BedContact: forces, tangent, energy and accepted steps from gap, normal force, friction and
// suction at each point, and the memory of friction (`PointHistory`: slip, normal and forces of the accepted
// state): start() reads it, commit() computes the next one, store() keeps it, checkpoint_records() and
// restore() write and read it. The law at a point is surface_contact() in kernels/surface_contact_law.cpp,
// its friction kernels/point_friction.hpp; other parts of the class are in bed_contact_*.cpp.
#include "hawser/terms/bed_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace hawser {

Vec3 BedContact::line_direction(const Point& p, const Kinematics& state) const {
  if (p.second < 0) return line_.tangent(state, p.node);
  const Vec3 chord = state.x[p.second] - state.x[p.node];
  const double length = chord.norm();
  return length > 0 ? Vec3(chord / length) : Vec3::UnitX();
}

bool BedContact::locate(const Point& p, const Vec3& x, double beyond, ContactTrial& trial) const {
  const double radius = law(p).radius;
  const double smoothing = law(p).law.normal.smoothing;
  trial.point = x;
  if (!surface_) {
    trial.gap = plane_.gap(x) - radius;
    trial.normal = plane_.normal;
    return trial.gap < smoothing;
  }
  trial.gap = smoothing + beyond;
  Cache& cache = cache_[index_of(p)];
  if (cache.clear - (1 + 1e-9) * (x - cache.centre).norm() > beyond) return false;
  const double search_range = std::max(2 * beyond, 0.5 * longest_element_[p.node]);
  const auto s = surface_->query(x, contact_distance(p) + search_range, cache.hint);
  cache.centre = x;
  if (!s) {
    // If the bed is a mesh, x may also be below it beyond its edge. Then only the distance to the bounding
    // box is certain to be free.
    const bool endless = !std::isfinite(bounds_.hi.z());
    cache.clear = endless ? search_range : std::min(search_range, distance(bounds_, x) - contact_distance(p));
    return false;
  }
  cache.hint = s->triangle;
  cache.clear = s->distance - contact_distance(p);
  // The gap is limited so that the result does not depend on the search radius of this or earlier queries.
  trial.gap = std::min(s->distance - radius, smoothing + beyond);
  trial.normal = s->normal;
  trial.curvature = s->curvature;
  return cache.clear < 0;
}

double BedContact::gap(const Vec3& x, double max_distance) const {
  if (!surface_) return plane_.gap(x);
  const auto s = surface_->query(x, max_distance);
  return s ? s->distance : std::numeric_limits<double>::infinity();
}

ContactForce BedContact::contact(const Point& p, const Kinematics& state, bool derivatives, ContactTrial& t,
                                 bool convex) const {
  const double beyond = suction_range(law(p).suction, suction_state(p, state)) - law(p).law.normal.smoothing;
  const bool touches = locate(p, of_nodes(p, state.x), std::max(0.0, beyond), t);
  if (convex) t.curvature.setZero();
  if (!touches) return {};
  if (state.moves()) t.velocity = of_nodes(p, state.v);
  // Friction f_i = -k_i s_i of the trial slip s along and across the line, (f_a/mu_a)² + (f_l/mu_l)² <= N²:
  // friction() in kernels/friction_law.hpp.
  if (friction_ == FrictionMode::contact && !(laid() && !laid_[index_of(p)].known()))
    return surface_contact(law(p).law, start(p), t, derivatives);
  return surface_contact({law(p).law.normal, FrictionLaw{}}, start(p), t, derivatives);
}

ContactStart BedContact::start(const Point& p) const {
  const StepStart& s = starts_[index_of(p)];
  if (laid()) {
    const LaidReference& from = laid_[index_of(p)];
    // With a gap of 0 at the start, all of the displacement from the laid position counts as slip.
    return {from.place, 0, s.direction, from.slip, from.normal};
  }
  return {s.point, s.gap, s.direction, history(p).slip, history(p).normal, history(p).peak};
}

// In statics laid lines keep the position from which friction is counted.
void BedContact::prepare(const Kinematics& from, double h) {
  if (h > 0) {
    laid_.clear();
    laid_.shrink_to_fit();
  }
  for (const Point& p : points_) {
    StepStart& start = starts_[index_of(p)];
    if (law(p).law.friction.active()) start.direction = line_direction(p, from);
    ContactTrial at;
    if (laid()) {
      LaidReference& laid = laid_[index_of(p)];
      const double force = contact(p, from, false, at).along_normal.force;
      if (friction_ == FrictionMode::contact && laid.known()) laid.normal_force = force;
      if (friction_ == FrictionMode::pressed && force > 0) laid.normal = at.normal;
      continue;
    }
    const Vec3 x = of_nodes(p, from.x);
    // The search reaches as far as the point can move in this step, so that its gap at the start is known if
    // it lands.
    locate(p, x, std::max(2 * h * of_nodes(p, from.v).norm(), 0.5 * longest_element_[p.node]), at);
    start.point = x;
    start.gap = at.gap;
  }
}

namespace {
// Adds equal shares of the force to n nodes.
template <int n>
void add_shared(const int (&blocks)[n], const Vec3& residual, const Mat3* K, const Mat3* C,
                Assembler& assembler) {
  using Shared = Eigen::Matrix<double, 3 * n, 3 * n, Eigen::RowMajor>;
  const Eigen::Matrix<double, 3 * n, 1> f = (residual / n).replicate<n, 1>();
  Shared k, c;
  if (K) k = (*K / (n * n)).replicate<n, n>();
  if (C) c = (*C / (n * n)).replicate<n, n>();
  assembler.add(blocks, f, K ? DerivativeView(k) : DerivativeView(),
                C ? DerivativeView(c) : DerivativeView());
}
}  // namespace

// Each node bears half of the force at the middle of an element.
void BedContact::add(const Point& p, const Vec3& residual, const Mat3* K, const Mat3* C,
                     Assembler& assembler) const {
  if (p.second < 0) return add_shared({mesh_.block[p.node]}, residual, K, C, assembler);
  add_shared({mesh_.block[p.node], mesh_.block[p.second]}, residual, K, C, assembler);
}

// Residual of a point: the pull p of suction along the normal n, less the force c of contact and friction.
// With the gap g and the curvature H of the bed its tangent is K = dp/dg n n^T + p H - dc/dx, C = -dc/dv. Far
// from an equilibrium w > 0, and K has the stiffness S of the secant of friction F in place of a part w of
// dF/ds, which is 0 where all friction is mobilised: w (dF/ds - S) is added.
void BedContact::evaluate(const Kinematics& trial, Assembler& assembler) {
  const bool needs_tangent = assembler.needs_tangent();
  const bool convex = assembler.convex();
  for (const Point& p : points_) {
    ContactTrial at;
    Mat3 stabilisation = Mat3::Zero();
    if (friction_ != FrictionMode::none && laid() && laid_[index_of(p)].normal_force > 0) {
      const PressedFriction f = pressed_friction_at(p, of_nodes(p, trial.x));
      if (needs_tangent) stabilisation = assembler.weights().stabilisation * (f.by_slip - f.secant);
      const Mat3 K = stabilisation - f.by_slip;
      if (friction_ == FrictionMode::pressed)
        add(p, -f.force, needs_tangent ? &K : nullptr, nullptr, assembler);
    }
    const ContactForce c = contact(p, trial, needs_tangent, at, convex);
    const Pull pulled = pull_of(law(p).suction, suction_state(p, trial), at.gap);
    if (c.along_normal.force == 0 && pulled.force == 0) continue;
    const Vec3 residual = pulled.force * at.normal - c.force;
    if (!needs_tangent) {
      add(p, residual, nullptr, nullptr, assembler);
      continue;
    }
    const Mat3 K = pulled.by_lift * at.normal * at.normal.transpose() + pulled.force * at.curvature -
                   c.by_point + (friction_ == FrictionMode::contact ? stabilisation : Mat3::Zero());
    const Mat3 C = -c.by_velocity;
    add(p, residual, &K, trial.moves() ? &C : nullptr, assembler);
  }
}

// Evaluates contact at the accepted state. The work of friction and damping in the step is that of the mean
// of the forces at its ends: the trapezoidal rule.
void BedContact::commit(const Kinematics& accepted) {
  for (Point& p : points_) {
    ContactTrial at;
    const ContactForce c = contact(p, accepted, false, at);
    const PointHistory& last = history(p);
    PointHistory next;
    if (c.along_normal.elastic > 0) {
      next = PointHistory(c, at.normal, accepted.moves());
      next.active = true;
    }
    const SuctionState before = suction_state(p, accepted);
    if (const double pulled = pull_of(law(p).suction, before, at.gap).force; pulled > 0) {
      next.normal = at.normal;
      next.force -= pulled * at.normal;
      next.damping_force -= pulled;
    }
    next.soil = suction_after(law(p).suction, before, at.gap);
    if (p.counted && accepted.moves() && (next.active || last.active || last.soil.held)) {
      const Vec3 moved = of_nodes(p, accepted.x) - starts_[index_of(p)].point;
      account_.friction -= 0.5 * (next.friction + last.friction).dot(moved);
      account_.damping -=
          0.5 * (next.damping_force * next.normal + last.damping_force * last.normal).dot(moved);
    }
    if (next.active || next.soil.held || next.soil.deepest != 0)
      store(p, next);
    else if (p.history_index >= 0)
      vacant_.push_back(std::exchange(p.history_index, -1));
  }
}

void BedContact::store(Point& p, const PointHistory& h) {
  if (p.history_index < 0 && vacant_.empty()) {
    // Doubling the capacity would use as much memory as all other data of the points.
    const size_t n = histories_.size();
    if (n == histories_.capacity()) histories_.reserve(n + n / 8 + 16);
    p.history_index = static_cast<int>(n);
    histories_.emplace_back();
  } else if (p.history_index < 0) {
    p.history_index = vacant_.back();
    vacant_.pop_back();
  }
  histories_[p.history_index] = h;
}

// Checkpoint records. Both ranks of a shared element need the contact point at its middle, but a rank reads
// only the records of its own nodes. Therefore the record is stored at both nodes. Keys: 0 for a node, 1 at
// the first node of the element, 2 at the second.
std::vector<CheckpointKind> BedContact::checkpoint_kinds() const {
  return {checkpoint_kind<PointHistory>("points"), checkpoint_kind<Account>("sums of a rank")};
}

std::vector<CheckpointRecord> BedContact::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> records;
  for (const Point& p : points_) {
    if (p.history_index < 0) continue;
    for (const int node : {p.node, p.second})
      if (mesh_.owns(node) && range.has(mesh_.global[node]))
        records.push_back(record_of(mesh_.global[node],
                                    p.second < 0     ? 0
                                    : node == p.node ? 1
                                                     : 2,
                                    history(p)));
  }
  if (mesh_.owned > 0 && range.has(mesh_.global[0]))
    records.push_back(record_of(mesh_.global[0], 0, account_, 1));
  return records;
}

void BedContact::restore(const std::vector<CheckpointRecord>& records) {
  std::map<std::pair<int, int>, size_t> at;  // by mesh node and key
  for (size_t i = 0; i < points_.size(); ++i) {
    Point& p = points_[i];
    p.history_index = -1;
    const auto global = [this](int node) { return mesh_.global[node]; };
    at[{global(p.node), p.second < 0 ? 0 : 1}] = i;
    if (p.second >= 0) at[{global(p.second), 2}] = i;
  }
  histories_.clear();
  vacant_.clear();
  account_ = {};
  for (const CheckpointRecord& r : records) {
    if (r.kind == 1) {
      const Account sum = entry<Account>(r);
      account_.friction += sum.friction;
      account_.damping += sum.damping;
      continue;
    }
    const auto found = at.find({r.node, r.key});
    if (found == at.end()) continue;
    store(points_[found->second], entry<PointHistory>(r));
  }
}

// Until a step has been committed the energy is that of the state: in statics the line search reduces it.
Energy BedContact::energy(const Kinematics& state) const {
  Energy e;
  e.friction = account_.friction;
  e.damping = account_.damping;
  for (const Point& p : points_) {
    if (!p.counted) continue;
    if (state.ends_step()) {
      e.strain += history(p).potential;
      continue;
    }
    ContactTrial trial;
    const ContactForce c = contact(p, state, false, trial);
    e.strain += c.along_normal.potential;
    if (friction_ != FrictionMode::none && laid())
      e.strain += pressed_friction_at(p, of_nodes(p, state.x)).potential;
  }
  return e;
}

Vec3 BedContact::node_force(int node) const {
  Vec3 sum = Vec3::Zero();
  for (const Point& p : points_)
    if (const double fraction = fraction_on_node(p, node); fraction > 0) sum += fraction * history(p).force;
  return sum;
}

int BedContact::active_count() const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(),
                                        [this](const Point& p) { return p.counted && history(p).active; }));
}

}  // namespace hawser
