// The class EndSprings: moment and exact tangent of a rotational spring at the end of a line, reaction on a
// floating body, and work of bodies with prescribed motion.
#include "hawser/terms/end_springs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// phi²/2 as a function of c = cos phi, and its first two derivatives.
struct Angle {
  double half_square, first, second;
};

Angle angle(double sine, double cosine) {
  const double phi = std::atan2(sine, cosine);
  if (phi < 0.05) {
    // phi² = 2u + u²/3 + 4u³/45 + u⁴/35 + ..., u = 1 - c
    const double u = phi * phi / 2 * (1 - phi * phi / 12 * (1 - phi * phi / 30));
    return {0.5 * phi * phi, -(1 + u * (1.0 / 3 + u * (2.0 / 15 + u * (2.0 / 35)))),
            1.0 / 3 + u * (4.0 / 15 + u * (6.0 / 35))};
  }
  const double s = std::max(sine, 1e-6);  // bounded at phi = pi, where the direction is undefined
  return {0.5 * phi * phi, -phi / s, (1 - phi * cosine / s) / (s * s)};
}

}  // namespace

std::vector<EndSpring> end_springs(const model::Case& c, const LocalMesh& mesh) {
  std::vector<EndSpring> out;
  for (size_t l = 0; l < c.lines.size(); ++l) {
    const LineSpan& span = mesh.mesh->lines[l];
    for (const LineEnd end : kLineEnds) {
      const model::End& e = c.lines[l].end(end);
      if (e.kind == model::EndKind::free || !(e.rotational_stiffness > 0) || !e.direction) continue;
      const int node = mesh.find(span.end_node(end));
      if (!mesh.owns(node) || !mesh.rotates(node)) continue;
      out.push_back({node, e.kind == model::EndKind::body ? c.body_index(e.carrier) : -1,
                     e.direction->normalized(), e.rotational_stiffness});
    }
  }
  return out;
}

EndSprings::EndSprings(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                       std::vector<EndSpring> springs)
    : mesh_(mesh), bodies_(std::move(bodies)), springs_(std::move(springs)), work_(springs_.size(), 0.0) {
  for (size_t i = 0; i < springs_.size(); ++i)
    if (springs_[i].body >= 0 && bodies_->moves(springs_[i].body) && !bodies_->floats(springs_[i].body))
      driven_.push_back(i);
}

// Tangent of the line at its end, and the direction of the unloaded spring.
std::array<AttachedNow, 2> EndSprings::directions(const EndSpring& s, const Kinematics& state) const {
  const Attached tangent{mesh_.global[s.node], -1, Vec3::UnitX(), true};
  return {attached_now(tangent, state, mesh_, *bodies_),
          attached_now({-1, s.body, s.direction, true}, state, mesh_, *bodies_)};
}

void EndSprings::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const EndSpring& s : springs_) {
    const auto [tangent, direction] = directions(s, trial);
    const Vec3& t = tangent.x;
    const Vec3& d = direction.x;
    const Angle a = angle(t.cross(d).norm(), t.dot(d));
    // W(c) with c = t.d: dW = W' (d.dt + t.dd).
    Vec6 f, g;
    g << d, t;
    f = s.stiffness * a.first * g;
    Mat6 K = s.stiffness * a.second * g * g.transpose();
    Mat6 exchange = Mat6::Zero();
    exchange.topRightCorner<3, 3>().setIdentity();
    exchange.bottomLeftCorner<3, 3>().setIdentity();
    K += s.stiffness * a.first * exchange;
    // Far from a solution W(c) may be concave. The tangent is then that of the convex k |t - d|²/2 at t = d,
    // where it has no force.
    if (assembler.convex()) {
      f.setZero();
      K = s.stiffness * (Mat6::Identity() - exchange);
    }
    add_pair_force(assembler, tangent, direction, f, K, Mat6::Zero());
  }
}

// The body turns the direction and changes c = d.t: W' t.(theta x d) = W' theta.(d x t).
void EndSprings::holds(const Kinematics& state, std::vector<Hold>& out) const {
  out.clear();
  for (const size_t i : driven_) {
    const EndSpring& s = springs_[i];
    const Quat rotation = bodies_->pose(s.body, state).rotation;
    const Vec3 t = rotation.conjugate() * directions(s, state)[0].x;
    const Vec3 g = s.direction.cross(t);
    out.push_back({rotation, s.stiffness * angle(g.norm(), s.direction.dot(t)).first * g});
  }
}

void EndSprings::prepare(const Kinematics& from, double) { holds(from, before_); }

// Trapezoidal rule in body axes, as for clamped ends.
void EndSprings::commit(const Kinematics& accepted) {
  if (before_.empty()) return;
  holds(accepted, now_);
  for (size_t i = 0; i < now_.size(); ++i) {
    const Hold& a = before_[i];
    const Hold& b = now_[i];
    work_[driven_[i]] += 0.5 * (a.moment + b.moment).dot(log_so3(a.rotation.conjugate() * b.rotation));
  }
}

std::vector<CheckpointKind> EndSprings::checkpoint_kinds() const {
  return {checkpoint_kind<WorkDone>("sums of an end")};
}

std::vector<CheckpointRecord> EndSprings::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const size_t i : driven_)
    if (const int node = mesh_.global[springs_[i].node]; range.has(node))
      out.push_back({node, 0, {work_[i]}});
  return out;
}

void EndSprings::restore(const std::vector<CheckpointRecord>& records) {
  for (const size_t i : driven_)
    if (const auto kept = find_entry<WorkDone>(records, mesh_.global[springs_[i].node]))
      work_[i] = kept->work;
}

Energy EndSprings::energy(const Kinematics& state) const {
  Energy e;
  for (const EndSpring& s : springs_) {
    const auto [t, d] = directions(s, state);
    e.strain += s.stiffness * angle(t.x.cross(d.x).norm(), t.x.dot(d.x)).half_square;
  }
  e.work = std::accumulate(work_.begin(), work_.end(), 0.0);
  return e;
}

}  // namespace hawser
