// The part of SeabedTerm that acts: gap, normal force, friction and suction at each point, force and tangent,
// energy, and history of an accepted step; the rest is in seabed_*.cpp. Normal force and friction at a point
// are computed in kernels/volume_contact.cpp, by the laws in kernels/contact_law.hpp and friction_law.hpp.
#include "hawser/terms/seabed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {

Vec3 SeabedTerm::tangent(const Point& p, const Kinematics& at) const {
  if (p.second < 0) return line_.tangent(at, p.node);
  const Vec3 chord = at.x[static_cast<size_t>(p.second)] - at.x[static_cast<size_t>(p.node)];
  const double length = chord.norm();
  return length > 0 ? Vec3(chord / length) : Vec3::UnitX();
}

bool SeabedTerm::locate(const Point& p, const Vec3& x, double beyond, ContactTrial& trial) const {
  const double smoothing = p.law.normal.smoothing;
  trial.point = x;
  if (!surface_) {
    trial.gap = plane_.gap(x) - p.radius, trial.normal = plane_.normal;
    return trial.gap < smoothing;
  }
  trial.gap = smoothing + beyond;
  if (p.clear - (1 + 1e-9) * (x - p.centre).norm() > beyond) return false;
  const double look = std::max(2 * beyond, 0.5 * element_[static_cast<size_t>(p.node)]);
  const auto s = surface_->query(x, contact_distance(p) + look, p.hint);
  p.centre = x;
  if (!s) {
    // Of a mesh it may also lie under the bed beyond the edge: only above the box is nothing near for sure.
    const bool endless = !std::isfinite(bounds_.hi.z());
    p.clear = endless ? look : std::min(look, distance(bounds_, x) - contact_distance(p));
    return false;
  }
  p.hint = s->triangle;
  p.clear = s->distance - contact_distance(p);
  // Not what was asked before but where it is decides.
  trial.gap = std::min(s->distance - p.radius, smoothing + beyond);
  trial.normal = s->normal, trial.curvature = s->curvature;
  return p.clear < 0;
}

double SeabedTerm::gap(const Vec3& x, double most) const {
  if (!surface_) return plane_.gap(x);
  const auto s = surface_->query(x, most);
  return s ? s->distance : std::numeric_limits<double>::infinity();
}

// Only what the soil held at the start of the step is pulled, and nothing in statics, which has no way back.
// A little further, so that round-off does not keep what is let go.
double SeabedTerm::suction_range(const Point& p, double step) const {
  if (!(step > 0) || !suction_ || !p.history.held) return 0;
  return std::max(0.0, 1.01 * p.suction.length - p.history.deepest - p.law.normal.smoothing);
}

Pull SeabedTerm::pull(const Point& p, const ContactTrial& trial, double step) const {
  if (!(step > 0) || !suction_ || !p.history.held) return {};
  return pull_of(p.suction, p.history.deepest + trial.gap);
}

PointContact SeabedTerm::contact(const Point& p, const Kinematics& at, bool derivatives,
                                 ContactTrial& t) const {
  if (!locate(p, of_nodes(p, at.x), suction_range(p, at.step), t)) return {};
  if (at.step > 0) t.velocity = of_nodes(p, at.v);
  if (friction_on_) return volume_contact(p.law, p.start, t, derivatives);
  return volume_contact({p.law.normal, FrictionLaw{}}, p.start, t, derivatives);
}

// Statics comes here before every iteration: a laid line keeps where its friction is reckoned from.
void SeabedTerm::prepare(const Kinematics& committed, double h) {
  const bool statics = h <= 0;
  if (!statics) laid_ = false;
  for (Point& p : points_) {
    if (!(statics && laid_)) {
      const Vec3 x = of_nodes(p, committed.x);
      ContactTrial at;
      // So far that what it lands from in this step is known.
      locate(p, x,
             std::max(2 * h * of_nodes(p, committed.v).norm(), 0.5 * element_[static_cast<size_t>(p.node)]),
             at);
      p.start.point = x;
      p.start.gap = at.gap;
      p.start.slip = p.history.slip;
      p.start.normal = p.history.normal;
    }
    if (p.law.friction.active()) p.start.tangent = tangent(p, committed);
    ContactTrial unused;
    if (statics && friction_on_) p.pressed = contact(p, committed, false, unused).normal.force;
  }
}

// Half of what is half way along an element goes to either node.
void SeabedTerm::add(const Point& p, const Vec3& residual, const Mat3* K, const Mat3* C,
                     Assembler& assembler) const {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const int first = mesh_.block[static_cast<size_t>(p.node)];
  if (p.second < 0) {
    RowMajor k, c;
    if (K) k = *K;
    if (C) c = *C;
    assembler.add({&first, 1}, residual.data(), K ? k.data() : nullptr, C ? c.data() : nullptr, nullptr);
    return;
  }
  const Vec3 half = 0.5 * residual;
  const double f[6] = {half[0], half[1], half[2], half[0], half[1], half[2]};
  const int blocks[2] = {first, mesh_.block[static_cast<size_t>(p.second)]};
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> k, c;
  for (const auto& [from, to] : {std::pair(K, &k), std::pair(C, &c)}) {
    if (!from) continue;
    const Mat3 quarter = 0.25 * *from;
    *to << quarter, quarter, quarter, quarter;
  }
  assembler.add(blocks, f, K ? k.data() : nullptr, C ? c.data() : nullptr, nullptr);
}

void SeabedTerm::evaluate(const Kinematics& trial, Assembler& assembler) {
  const bool tangent = assembler.wants_tangent(), convex = assembler.convex();
  for (const Point& p : points_) {
    ContactTrial at;
    const Vec3 x = of_nodes(p, trial.x);
    if (kept(p, trial.step)) {
      const double k = p.law.normal.stiffness;
      const Vec3& normal = p.origin->normal;
      const Mat3 K = k * (Mat3::Identity() - normal * normal.transpose());
      add(p, k * strayed(p, x), tangent ? &K : nullptr, nullptr, assembler);
    }
    const bool touches = locate(p, x, suction_range(p, trial.step), at);
    const Pull pulled = pull(p, at, trial.step);
    if (!touches && pulled.force == 0) continue;
    if (trial.step > 0) at.velocity = of_nodes(p, trial.v);
    if (convex) at.curvature.setZero();  // of a hollow: negative stiffness
    const ContactLaw law{p.law.normal, friction_on_ ? p.law.friction : FrictionLaw{}};
    const PointContact c = volume_contact(law, p.start, at, tangent);
    if (c.normal.force == 0 && pulled.force == 0) continue;
    const Vec3 residual = pulled.force * at.normal - c.force;
    if (!tangent) {
      add(p, residual, nullptr, nullptr, assembler);
      continue;
    }
    const Mat3 K = pulled.by_lift * at.normal * at.normal.transpose() + pulled.force * at.curvature -
                   c.by_point,
               C = -c.by_velocity;
    add(p, residual, &K, trial.step > 0 ? &C : nullptr, assembler);
  }
}

// The soil takes hold of what goes deeper than it was since it landed, and lets go of what is lifted too far;
// it forgets what has left. At rest it holds what lies in it.
void SeabedTerm::hold(const Point& p, double gap, bool moves, History& next) const {
  if (!(p.suction.limit > 0)) return;
  if (moves) next.deepest = p.history.deepest, next.held = p.history.held;
  if (-gap > next.deepest) next.deepest = -gap, next.held = true;
  if (next.deepest + gap >= p.suction.length) next.held = false;
  if (!next.held && gap >= 0) next.deepest = 0;
}

Vec3 SeabedTerm::strayed(const Point& p, const Vec3& x) {
  const Vec3 d = x - p.origin->point;
  return d - p.origin->normal * p.origin->normal.dot(d);
}

// Evaluated again at the accepted state. Energies: trapezoid over the step.
void SeabedTerm::commit(const Kinematics& accepted) {
  for (Point& p : points_) {
    ContactTrial at;
    const PointContact c = contact(p, accepted, false, at);
    History next;
    if (c.normal.elastic > 0) next = History(c, at.normal), next.active = true;
    if (const double pulled = pull(p, at, accepted.step).force; pulled > 0) {
      next.normal = at.normal;
      next.force -= pulled * at.normal, next.damping_force -= pulled;
    }
    hold(p, at.gap, accepted.step > 0, next);
    next.friction_work = p.history.friction_work, next.damping_work = p.history.damping_work;
    if (accepted.step > 0 && (next.active || p.history.active || p.history.held)) {
      const Vec3 moved = of_nodes(p, accepted.x) - p.start.point;
      next.friction_work -= 0.5 * (next.friction + p.history.friction).dot(moved);
      next.damping_work -=
          0.5 * (next.damping_force * next.normal + p.history.damping_force * p.history.normal).dot(moved);
    }
    p.history = next;
  }
}

// What friction that grows from the start of a laid line has taken up, as if it were pressed by what presses
// it at the last iteration: convex, and exact for equal coefficients and lengths.
double SeabedTerm::friction_potential(const Point& p, const Vec3& x, const Vec3& normal) const {
  const FrictionLaw& f = p.law.friction;
  const Vec3 slip = p.start.slip + (x - p.start.point);
  const double along = slip.dot(p.start.tangent), up = slip.dot(normal);
  const double across2 = std::max(0.0, slip.squaredNorm() - along * along - up * up);
  double force[2] = {f.axial * p.pressed, f.lateral * p.pressed};
  double length[2] = {f.axial_length, f.lateral_length};
  if (f.stiffness > 0)
    for (int i = 0; i < 2; ++i) length[i] = std::max(force[i] / f.stiffness, 1e-12);
  const double R2 = along * along / (length[0] * length[0]) + across2 / (length[1] * length[1]);
  const double a2 = along * along, all2 = a2 + across2;
  const double share = all2 > 0 ? a2 / all2 : 1;
  const double limit = share * force[0] * length[0] + (1 - share) * force[1] * length[1];
  return limit * (R2 < 1 ? 0.5 * R2 : std::sqrt(R2) - 0.5);
}

// In statics of trials: the line search goes down this.
Energy SeabedTerm::energy(const Kinematics& at) const {
  Energy e;
  for (const Point& p : points_) {
    if (!p.counted) continue;
    e.friction += p.history.friction_work, e.damping += p.history.damping_work;
    if (at.step > 0) {
      e.strain += p.history.potential;
      continue;
    }
    ContactTrial trial;
    const PointContact c = contact(p, at, false, trial);
    e.strain += c.normal.potential;
    if (kept(p, at.step))
      e.strain += 0.5 * p.law.normal.stiffness * strayed(p, of_nodes(p, at.x)).squaredNorm();
    if (friction_on_ && laid_ && p.law.friction.active() && p.pressed > 0)
      e.strain += friction_potential(p, of_nodes(p, at.x), trial.normal);
  }
  return e;
}

Vec3 SeabedTerm::node_force(int node) const {
  Vec3 sum = Vec3::Zero();
  for (const Point& p : points_)
    if (const double part = share(p, node); part > 0) sum += part * p.history.force;
  return sum;
}

int SeabedTerm::active_count() const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(),
                                        [](const Point& p) { return p.counted && p.history.active; }));
}

}  // namespace hawser
