// The forces of contact on the axis of an element, and their exact tangent.
#include <algorithm>
#include <cmath>

#include "hawser/math/so3.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

// Ends of a panel that move with the unknowns: s is where gap(s, X) = smoothing, so ds = -n . dx(s) / (n .
// x'(s)), and the places and weights of the Gauss points follow it.
struct LineVolumeContact::Moving {
  bool on = false;
  AxisShape::Weights H{};
  Vec3 by_axis = Vec3::Zero();                 // ds / dx(s), 1/m
  std::array<Vec3, AxisShape::kMost> force{};  // dF_j / ds
  std::array<double, 2> torque{};              // dT_i / ds
};

std::array<LineVolumeContact::Moving, 2> LineVolumeContact::moving_ends(const Pair& pair,
                                                                        const AxisShape& shape,
                                                                        const ContactStretch& s) const {
  const RigidPose& pose = volumes_.trial_pose(pair.volume);
  std::array<Moving, 2> ends;
  for (size_t i = 0; i < 2; ++i) {
    if (!(i ? s.to_moves : s.from_moves)) continue;
    const double xi = i ? s.to : s.from;
    const auto p = finder_.see(pair, xi, pose.to_body(shape.point(xi)), pair.touch + 1e-9);
    if (!p) continue;
    const Vec3 normal = pose.rotation.toRotationMatrix() * p->normal;
    const double slope = normal.dot(shape.slope(xi));
    if (std::abs(slope) < 1e-9 * shape.reach()) continue;
    ends[i].on = true;
    ends[i].H = shape.functions(xi);
    ends[i].by_axis = -normal / slope;
    ends[i].force.fill(Vec3::Zero());
  }
  return ends;
}

LineVolumeContact::Rolled LineVolumeContact::rolled(const Pair& pair, const AxisShape& shape) const {
  Rolled r;
  r.on = settings(pair).rolling && shape.count() == AxisShape::kMost && friction_on_ &&
         pair.laws[0].friction.active();
  if (!r.on) return r;
  const Quat before = pair.start.pose.rotation.conjugate(),
             after = volumes_.trial_pose(pair.volume).rotation.conjugate();
  for (size_t i = 0; i < 2; ++i)
    r.ends[i] = axis_roll(before * pair.start.shape.turn(i), after * shape.turn(i), settings(pair).tangent);
  return r;
}

// Adds the forces at all places of the trial. The contact points stay for commit where no derivatives were
// asked for: with derivatives friction rounds differently, and commit would depend on what was asked last.
void LineVolumeContact::add_panels(Pair& pair, const AxisShape& shape, Forces& forces) const {
  pair.evaluated.clear();
  forces.rolled = rolled(pair, shape);
  for (size_t i = 0; i < pair.found.panels.size(); ++i) add_panel(pair, shape, i, forces);
  pair.evaluated_at = {!forces.tangent, shape, volumes_.trial_pose(pair.volume)};
  pair.evaluated_in_motion = forces.moves;
}

// The tangent is exact, moving ends included.
void LineVolumeContact::add_panel(Pair& pair, const AxisShape& shape, size_t panel, Forces& forces) const {
  const ContactStretch& s = pair.found.panels[panel];
  const RigidPose& pose = volumes_.trial_pose(pair.volume);
  const bool moves = forces.moves, tangent = forces.tangent;
  const double L = pair.length, span = s.to - s.from;
  const ContactLaw law = applied(pair.law(0.5 * (s.from + s.to)));
  const size_t n = static_cast<size_t>(shape.count());
  const Mat3 R = pose.rotation.toRotationMatrix();
  const Quat back = pose.rotation.conjugate();
  // Relative velocity in the body frame: u = R'(v - V) - omega x y.
  const Mat3 spin = hat(back * pose.angular_velocity);
  AxisShape::Generalised& g = forces.axis;
  Rolled& rolled = forces.rolled;
  std::array<Moving, 2> ends;
  if (tangent && !forces.convex) ends = moving_ends(pair, shape, s);
  for (const ContactPlace& there : pair.found.places) {
    if (there.panel != panel || !pair.sees(there.at)) continue;
    const double xi = there.xi, w = there.weight;
    const Vec3 x = shape.point(xi);
    ContactTrial trial;
    trial.point = pose.to_body(x);
    trial.gap = there.at.distance - pair.radius;
    trial.normal = there.at.normal;
    // -N H is the negative geometric stiffness of contact.
    if (!forces.convex) trial.curvature = there.at.curvature;
    if (moves) trial.velocity = back * (shape.velocity(xi) - pose.velocity_at(x));
    ContactStart begin;
    ContactRates rates;
    if (law.friction.active()) begin = finder_.start(pair, xi, ends[0].on || ends[1].on ? &rates : nullptr);
    if (rolled.on) trial.roll = rolled.angle(xi), trial.lever = pair.radius;
    const PointContact c = volume_contact(law, begin, trial, tangent);
    if (c.normal.elastic > 0 && !tangent) {
      ContactPoint& p = pair.evaluated.emplace_back(c, trial.normal);
      p.xi = xi, p.from = s.from, p.to = s.to, p.weight = w, p.gap = trial.gap;
    }
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
    const Mat3 by_point = c.by_point - (moves ? 1.0 : 0.0) * c.by_velocity * spin;
    const Mat3 K = -w * R * by_point * R.transpose();
    const Mat3 C = moves ? Mat3(-w * R * c.by_velocity * R.transpose()) : Mat3(Mat3::Zero());
    for (size_t j = 0; j < n; ++j)
      for (size_t k = 0; k < n; ++k) {
        g.K[j][k] += H[j] * H[k] * K;
        if (moves) g.C[j][k] += H[j] * H[k] * C;
      }
    if (rolled.on) {
      AxisShape::Rolling& r = rolled.forces;
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
    const Vec3 along = contact_force_along(law, begin, trial, rates), slope = -(R * along);
    const Vec3 arm_along = -trial.lever * (rates.start_tangent.cross(trial.normal) +
                                           begin.tangent.cross(trial.curvature * rates.point));
    const double torque_along = -(arm_along.dot(c.force) + arm.dot(along));
    const AxisShape::Weights dH = shape.derivatives(xi);
    for (size_t i = 0; i < 2; ++i) {
      if (!ends[i].on) continue;
      const double stretch = i ? there.part : -there.part,
                   shift = span * there.part * (i ? there.along : 1 - there.along);
      for (size_t j = 0; j < n; ++j)
        ends[i].force[j] += L * ((stretch * H[j] + shift * dH[j]) * f + shift * H[j] * slope);
      for (size_t j = 0; j < 2 && rolled.on; ++j)
        ends[i].torque[j] +=
            L * ((stretch * N[j] + (j ? shift : -shift)) * torque + shift * N[j] * torque_along);
    }
  }
  for (const Moving& m : ends) {
    if (!m.on) continue;
    for (size_t k = 0; k < n; ++k) {
      for (size_t j = 0; j < 2 && rolled.on; ++j)
        rolled.forces.by_X[j][k] += m.H[k] * m.torque[j] * m.by_axis;
      for (size_t j = 0; j < n; ++j) g.K[j][k] += m.H[k] * m.force[j] * m.by_axis.transpose();
    }
  }
}

void LineVolumeContact::evaluate(const Kinematics& trial, Assembler& assembler) {
  volumes_.pose_trial(trial);
  look(trial);
  for (const Near& near : near_) {
    Pair& pair = pairs_[near.pair];
    if (pair.found.panels.empty()) continue;
    Forces forces;
    forces.moves = trial.step > 0, forces.tangent = assembler.wants_tangent(),
    forces.convex = assembler.convex();
    add_panels(pair, near.shape, forces);
    add_forces(pair, near.shape, forces, trial, assembler);
  }
}

void LineVolumeContact::add_forces(const Pair& pair, const AxisShape& shape, Forces& forces,
                                   const Kinematics& trial, Assembler& assembler) const {
  const bool tangent = forces.tangent, beam = shape.count() == 4;
  double f[12] = {}, K[144] = {}, C[144] = {};
  shape.to_nodes(forces.axis, f, nullptr, nullptr);
  if (forces.rolled.on)
    shape.to_nodes(forces.rolled.forces, forces.rolled.ends, !forces.convex, f, tangent ? K : nullptr, C);
  if (tangent) {
    // The moment arms' turning is negative stiffness as well.
    if (forces.convex) forces.axis.F.fill(Vec3::Zero());
    double same[12] = {};
    shape.to_nodes(forces.axis, same, K, C);
  }
  const double *by_x = tangent ? K : nullptr, *by_v = tangent && trial.step > 0 ? C : nullptr;
  const LocalElement& e = local(pair);
  const int a = mesh_.block[static_cast<size_t>(e.first)], b = mesh_.block[static_cast<size_t>(e.second)];
  const int blocks[4] = {a, beam ? a + 1 : b, b, b + 1};
  const size_t count = static_cast<size_t>(shape.count());
  if (!volumes_.floats(pair.volume)) {
    assembler.add({blocks, count}, f, by_x, by_v, nullptr);
    return;
  }
  std::array<LineBlock, 4> line;
  for (size_t i = 0; i < count; ++i) {
    const size_t n = static_cast<size_t>(i < (beam ? 2U : 1U) ? e.first : e.second);
    line[i] = {blocks[i], beam && i % 2 == 1, trial.x[n], trial.v[n], trial.q[n].toRotationMatrix()};
  }
  add_against_body(assembler, {line.data(), count}, volumes_.floating_frame(pair.volume, trial), e.counted, f,
                   by_x, by_v);
}

}  // namespace hawser
