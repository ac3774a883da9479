// Axis of an element for contact, and its attachment to the nodes.
//
// x(xi) = sum H_j(xi) X_j, xi in [0, 1]. A beam has Hermite's cubic with X = (x1, L t1, x2, L t2), where t =
// Q c is the unit tangent that turns with the node (the shape of line_mass.hpp). A cable is straight with X =
// (x1, x2).
#pragma once

#include <algorithm>
#include <array>

#include "hawser/kernels/bezier_axis.hpp"
#include "hawser/kernels/stencil.hpp"

namespace hawser {

struct AxisEnds {
  bool beam = true;
  double length = 0;                          // m, unstretched
  Vec3 tangent = Vec3::UnitX();               // c, direction of the line in the nodes' material axes
  Vec3 x1, x2;                                // m
  Vec3 v1 = Vec3::Zero(), v2 = Vec3::Zero();  // m/s
  Quat q1 = Quat::Identity(), q2 = Quat::Identity();
  Vec3 w1 = Vec3::Zero(), w2 = Vec3::Zero();  // rad/s, material
};

class AxisShape {
 public:
  static constexpr int kMaxPositions = 4;
  using Weights = std::array<double, kMaxPositions>;

  explicit AxisShape(const AxisEnds& ends);

  int count() const { return count_; }  // number of generalised positions: 4 for a beam, 2 for a cable
  // Inline, because contact evaluates them many times at each of its points.
  Weights functions(double xi) const {
    if (count_ == 2) return {1 - xi, xi, 0, 0};
    const double z2 = xi * xi;
    const double z3 = z2 * xi;
    return {1 - 3 * z2 + 2 * z3, xi - 2 * z2 + z3, 3 * z2 - 2 * z3, z3 - z2};
  }
  Weights derivatives(double xi) const {
    if (count_ == 2) return {-1, 1, 0, 0};
    const double z2 = xi * xi;
    return {-6 * xi + 6 * z2, 1 - 4 * xi + 3 * z2, 6 * xi - 6 * z2, 3 * z2 - 2 * xi};
  }
  Weights second_derivatives(double xi) const {
    if (count_ == 2) return {0, 0, 0, 0};
    return {-6 + 12 * xi, -4 + 6 * xi, 6 - 12 * xi, 6 * xi - 2};
  }
  Vec3 point(double xi) const { return combine(functions(xi), X_); }
  Vec3 slope(double xi) const { return combine(derivatives(xi), X_); }        // dx/dxi, m
  Vec3 bend(double xi) const { return combine(second_derivatives(xi), X_); }  // d²x/dxi², m
  Vec3 velocity(double xi) const { return combine(functions(xi), V_); }
  Vec3 velocity_slope(double xi) const { return combine(derivatives(xi), V_); }  // dv/dxi, m/s
  // True if the axis is identical to the last bit, regardless of velocities.
  bool same_axis(const AxisShape& o) const { return count_ == o.count_ && X_ == o.X_; }
  // True if also the velocities and rotations of the ends are identical.
  bool same_motion(const AxisShape& o) const {
    return same_axis(o) && V_ == o.V_ && q_[0].coeffs() == o.q_[0].coeffs() &&
           q_[1].coeffs() == o.q_[1].coeffs();
  }
  // Upper bound of |dx/dxi| over the element, m.
  double slope_bound() const { return slope_bound_; }
  // Largest |d²x/dxi²|, m; it is linear in xi.
  double bend_bound() const { return count_ == 2 ? 0 : std::max(bend(0).norm(), bend(1).norm()); }

  BezierAxis bezier() const;

  // Adds the X_j to a stencil, attached to its next blocks: (x1, theta1, x2, theta2) of a beam, (x1, x2) of a
  // cable. first_turn: index in the stencil of the rotation of a beam's first node, of two.
  void attach(Stencil& to, size_t first_turn = 0) const;
  // Rotation of a beam's node to space axes.
  const Mat3& axes(size_t end) const { return R_[end]; }
  const Quat& turn(size_t end) const { return q_[end]; }

 private:
  Vec3 combine(const Weights& w, const std::array<Vec3, kMaxPositions>& v) const {
    Vec3 s = w[0] * v[0] + w[1] * v[1];
    if (count_ == 4) s += w[2] * v[2] + w[3] * v[3];
    return s;
  }

  int count_;
  double length_, slope_bound_;
  Vec3 c_;
  std::array<Vec3, kMaxPositions> X_, V_;
  std::array<Quat, 2> q_;
  std::array<Mat3, 2> R_;
  std::array<Vec3, 2> w_;
};

}  // namespace hawser
