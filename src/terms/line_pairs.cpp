// The class LinePairs: forces, tangent, energy and accepted steps of the pairs in the candidate list. Closest
// points are in kernels/axis_closest_point.cpp, the law of two lines in kernels/line_pair_law.cpp, its sum
// along the lines in kernels/line_pair_forces.cpp; other parts of the class in line_pairs_*.cpp.
#include "hawser/terms/line_pairs.hpp"

#include <algorithm>

namespace hawser {

double largest_depth_of(const std::vector<LinePairContactPoint>& points) {
  if (points.empty()) return 0;
  size_t deepest = 0;
  for (size_t i = 1; i < points.size(); ++i)
    if (points[i].gap < points[deepest].gap) deepest = i;
  if (points.size() < 3) return -points[deepest].gap;
  const size_t first = std::min(deepest > 0 ? deepest - 1 : 0, points.size() - 3);
  const LinePairContactPoint& a = points[first];
  const LinePairContactPoint& b = points[first + 1];
  const LinePairContactPoint& c = points[first + 2];
  const double ab = (b.gap - a.gap) / (b.xi - a.xi);
  const double bc = (c.gap - b.gap) / (c.xi - b.xi);
  const double curve = (bc - ab) / (c.xi - a.xi);
  const bool joined = a.to >= b.from && b.to >= c.from;
  if (!joined || !(curve > 0)) return -points[deepest].gap;
  const double place = std::clamp(0.5 * (a.xi + b.xi - ab / curve), a.from, c.to);
  return -(a.gap + (place - a.xi) * (ab + curve * (place - b.xi)));
}

bool LinePairs::refresh_couplings(const Kinematics& from, double h) {
  if (feeders_ && candidates_.set_elements_in_feeders(feeders_->inside())) {
    shared_.set_elements_in_feeders(feeders_->inside());
    listed_ = false;
  }
  shared_.update(from, !from.moves());
  if (!candidates_.update(from, h) && listed_) return false;
  // Histories are stored by element until the new list is available.
  for (Pair& p : pairs_)
    if (p.points) kept_[p.key] = std::move(p.points);
  pairs_.clear();
  listed_ = false;
  return true;
}

void LinePairs::renumber() {
  candidates_.locate();
  for (Pair& p : pairs_)
    if (p.points) kept_[p.key] = std::move(p.points);
  pairs_.clear();
  segments_.clear();
  start_.clear();
  std::vector<int> index(candidates_.segments().size(), -1);
  const auto segment_of_pair = [&](int candidate) {
    int& i = index[candidate];
    if (i < 0) {
      i = static_cast<int>(segments_.size());
      segments_.push_back(candidates_.segments()[candidate]);
    }
    return i;
  };
  for (const CandidatePair& c : candidates_.pairs()) {
    Pair& p = pairs_.emplace_back();
    p.a = segment_of_pair(c.a);
    p.b = segment_of_pair(c.b);
    p.counted = c.counted;
    p.key = {segment(p.a).global, segment(p.b).global};
    p.law = law(p.a, p.b);
    if (const auto k = kept_.find(p.key); k != kept_.end()) p.points = std::move(k->second);
  }
  kept_.clear();
  listed_ = true;
}

void LinePairs::prepare(const Kinematics& from, double) {
  const size_t n = segments_.size();
  start_.resize(n);
  fed_end_.assign(n, -1);
  for (size_t i = 0; i < n && feeders_; ++i)
    if (const FedLine* fed = feeders_->find(segment(static_cast<int>(i)).global))
      fed_end_[i] = static_cast<int>(fed->line_end);
  for (size_t i = 0; i < n; ++i) start_[i] = ends(from, static_cast<int>(i));
  rods_ = rods(from);
  for (Pair& p : pairs_) {
    p.trial = nullptr;
    p.range_a = p.range_b = {0, 1};
    shared_.clip(p.key.first, p.key.second, p.range_a, p.range_b);
    const Rod& a = rods_[p.a];
    const Rod& b = rods_[p.b];
    p.chords = closest_points_of_segments(a.x1, a.x2, b.x1, b.x2);
    p.clear = p.chords.distance - a.sagitta - b.sagitta - p.law.radii - p.law.normal.smoothing;
  }
}

std::vector<LinePairs::Rod> LinePairs::rods(const Kinematics& state) const {
  std::vector<Rod> out(start_.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = rod(state, static_cast<int>(i));
  return out;
}

// True if the surfaces may have touched since the start of the step, where their distance was at least
// `clear`.
bool LinePairs::may_touch(const Pair& p, const std::vector<Rod>& moved) const {
  const auto path = [&](int segment) {
    return std::max((moved[segment].x1 - rods_[segment].x1).norm(),
                    (moved[segment].x2 - rods_[segment].x2).norm()) +
           moved[segment].sagitta;
  };
  return path(p.a) + path(p.b) >= p.clear;
}

bool LinePairs::near(const Pair& p, const std::vector<Rod>& moved) const {
  if (!may_touch(p, moved)) return false;
  const Rod& a = moved[p.a];
  const Rod& b = moved[p.b];
  return closest_points_of_segments(a.x1, a.x2, b.x1, b.x2).distance - a.sagitta - b.sagitta <
         p.law.radii + p.law.normal.smoothing;
}

template <class Visit>
void LinePairs::each_pass(const Pair& pair, const PairAxis& A, const PairAxis& B, bool moves, bool convex,
                          const Visit& visit) const {
  static const std::vector<LinePairContactPoint> nothing;
  LinePairPass::Settings s;
  s.law = pair.law;
  if (!friction_on_) s.law.friction = {};
  s.moves = moves && pair.law.normal.damping > 0;  // only damping depends on velocities
  s.convex = convex;
  for (size_t k = 0; k < kPasses; ++k) {
    const auto [swapped, target] = kPassKinds[k];
    const PassRoles pass = roles(k, pair, A, B);
    const int master = pass.master_segment;
    if (!kPassKinds[k].on_element() && !joint(segment(master), target == ProjectOn::second_end)) continue;
    s.range = swapped ? pair.range_b : pair.range_a;
    if (!(s.range[0] < s.range[1])) continue;
    s.slave_radius = type_of_segment(pass.slave_segment).radius;
    s.fraction = slave_fraction(s.slave_radius, type_of_segment(master).radius);
    s.swapped = swapped;
    if (!(s.fraction > 0)) continue;
    visit(k, LinePairPass(pass.slave, pass.master, target, s, pair.points ? (*pair.points)[k] : nothing));
  }
}

LinePairs::Trial& LinePairs::find(Pair& pair, const PairAxis& A, const PairAxis& B) const {
  std::unique_ptr<Trial>& t = pair.trial;
  if (t && t->a.same_axis(A.now) && t->b.same_axis(B.now)) return *t;
  if (t)
    t->reset(A.now, B.now);
  else
    t = std::make_unique<Trial>(Trial{A.now, B.now});
  each_pass(pair, A, B, false, false, [&](size_t k, const LinePairPass& pass) {
    t->panels[k] = pass.panels();
    t->active |= !t->panels[k].empty();
  });
  return *t;
}

AttachedForces LinePairs::forces(const Pair& pair, const PairAxis& A, const PairAxis& B, Trial& in_trial,
                                 const AxisContactMode& mode) const {
  AttachedForces g = no_forces(A, B, friction_on_ && pair.law.friction.active(), mode.tangent);
  each_pass(pair, A, B, mode.moves, mode.convex, [&](size_t k, const LinePairPass& pass) {
    if (in_trial.panels[k].empty()) return;
    in_trial.points[k].clear();
    pass.add(in_trial.panels[k], mode.tangent, g, mode.tangent ? nullptr : &in_trial.points[k]);
  });
  in_trial.a = A.now;
  in_trial.b = B.now;
  in_trial.moves = mode.moves;
  in_trial.evaluated = !mode.tangent;
  return g;
}

void LinePairs::evaluate(const Kinematics& trial, Assembler& assembler) {
  const bool tangent = assembler.needs_tangent();
  const AxisContactMode mode{trial.moves(), tangent, assembler.convex()};
  BlockVector f;
  BlockMatrix K, C;
  const std::vector<Rod> moved = rods(trial);
  for (Pair& pair : pairs_) {
    if (!near(pair, moved)) continue;
    const PairAxis A = axis(trial, pair.a);
    const PairAxis B = axis(trial, pair.b);
    Trial& in_trial = find(pair, A, B);
    if (!in_trial.active) continue;
    const AttachedForces g = forces(pair, A, B, in_trial, mode);
    const Stencil stencil = stencil_of(A, B);
    const Eigen::Index size = 3 * stencil.blocks;
    f.setZero(size);
    const bool damped = tangent && trial.moves() && pair.law.normal.damping > 0;
    if (tangent) K.setZero(size, size);
    if (damped) C.setZero(size, size);
    stencil.to_blocks(g, !assembler.convex(), f, tangent ? &K : nullptr, damped ? &C : nullptr);
    int blocks[8], n = 0;
    for (const bool second : {false, true}) {
      const ContactSegment& s = segment(second ? pair.b : pair.a);
      for (const int node : {s.first, s.second}) {
        const int b = mesh_.block[node];
        blocks[n++] = b;
        if ((second ? B : A).beam()) blocks[n++] = b + 1;
      }
    }
    assembler.add({blocks, static_cast<size_t>(n)}, f, tangent ? DerivativeView(K) : DerivativeView(),
                  damped ? DerivativeView(C) : DerivativeView());
  }
}

void LinePairs::commit(const Kinematics& accepted) {
  const std::vector<Rod> moved = rods(accepted);
  const bool moves = accepted.moves();
  for (Pair& pair : pairs_) {
    if (!near(pair, moved) && !pair.points) continue;
    const PairAxis A = axis(accepted, pair.a);
    const PairAxis B = axis(accepted, pair.b);
    Trial& t = find(pair, A, B);
    if (!t.evaluated || t.moves != moves || !t.a.same_motion(A.now) || !t.b.same_motion(B.now))
      forces(pair, A, B, t, {moves});
    const ContactPoints& next = t.points;
    if (pair.counted) {
      for (size_t k = 0; k < kPasses; ++k) {
        if (!kPassKinds[k].on_element()) continue;
        const double depth = largest_depth_of(next[k]);
        if (depth > deepest_.depth) deepest_ = {depth, accepted.time, pair.key.first, pair.key.second};
      }
      if (moves) account(pair, A, B, next);
      if (moves && feeders_) feeders_->add_work(fed_work(pair, A, B, next));
    }
    const bool any = std::any_of(next.begin(), next.end(), [](const auto& pass) { return !pass.empty(); });
    pair.points = any ? std::make_unique<ContactPoints>(std::move(t.points)) : nullptr;
    pair.trial = nullptr;
  }
}

// Work of friction and damping over the step by the trapezoidal rule: half by the forces at the start on the
// material on which they acted, half by those at the end on theirs, each over the whole displacement of this
// material relative to the other line. Friction acts on the displacement of the surfaces, which is zero for a
// pair that turns as one body; a cable has no sections that could turn. Along the normal the change of the
// gap vector counts.
void LinePairs::account(const Pair& pair, const PairAxis& A, const PairAxis& B, const ContactPoints& next) {
  Account& sum = accounts_[segment(pair.a).first];
  const auto turn = [](const PairAxis& axis, double xi) -> Mat3 {
    return axis.beam() ? axis.turn_at(xi) : Mat3::Identity();
  };
  for (size_t k = 0; k < kPasses; ++k) {
    const PassRoles pass = roles(k, pair, A, B);
    const double slave_weight = type_of_segment(pass.slave_segment).radius / pair.law.radii;
    const auto add = [&](const LinePairContactPoint& h, bool step_end) {
      const double xi = step_end ? h.xi : material_of_start(pass.slave_segment, pass.slave, h.xi);
      const double eta = step_end ? h.eta : material_of_start(pass.master_segment, pass.master, h.eta);
      const Vec3 between_before = pass.slave.start.point(xi) - pass.master.start.point(eta);
      const Vec3 between_now = pass.slave.now.point(xi) - pass.master.now.point(eta);
      const Mat3 turned = slave_weight * turn(pass.slave, xi) + (1 - slave_weight) * turn(pass.master, eta);
      // The lever of the couple is the vector between the axes while the force acts.
      const Vec3 moved = step_end ? Vec3(turned.transpose() * between_now - between_before)
                                  : Vec3(between_now - turned * between_before);
      sum.friction -= 0.5 * h.weight * h.friction.dot(moved);
      // The damper of a point that separates acts until the point has left contact.
      double path = h.normal.dot(between_now - between_before);
      if (!step_end) path = std::min(path, pair.law.normal.smoothing - h.gap);
      sum.damping -= 0.5 * h.weight * h.damping_force * path;
    };
    if (pair.points)
      for (const LinePairContactPoint& h : (*pair.points)[k]) add(h, false);
    for (const LinePairContactPoint& h : next[k]) add(h, true);
  }
}

// After a step the energy of the committed state; in statics that of the trial, which the line search
// reduces.
Energy LinePairs::energy(const Kinematics& state) const {
  Energy e;
  const std::vector<Rod> moved = state.ends_step() ? std::vector<Rod>{} : rods(state);
  for (const Pair& p : pairs_) {
    if (!p.counted) continue;
    if (state.ends_step()) {
      if (p.points)
        for (const auto& pass : *p.points)
          for (const LinePairContactPoint& h : pass) e.strain += h.weight * h.potential;
      continue;
    }
    if (!near(p, moved)) continue;
    const PairAxis A = axis(state, p.a);
    const PairAxis B = axis(state, p.b);
    each_pass(p, A, B, false, false,
              [&](size_t, const LinePairPass& pass) { e.strain += pass.potential(pass.panels()); });
  }
  for (const Account& a : accounts_) {
    e.friction += a.friction;
    e.damping += a.damping;
  }
  return e;
}

}  // namespace hawser
