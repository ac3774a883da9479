// Force of wind or current on a body from coefficients by direction, with exact derivatives.
#include "hawser/kernels/body_flow.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/kernels/table_places.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {

FlowCoefficients::FlowCoefficients(std::vector<Row> rows) {
  constexpr double kSame = 1e-9;  // rad
  for (Row& r : rows) {
    r.direction = all_round(r.direction);
    if (r.direction > 2 * M_PI - kSame) r.direction = 0;
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.direction < b.direction; });
  for (const Row& r : rows) {
    if (!direction_.empty() && r.direction - direction_.back() < kSame)
      throw std::invalid_argument("two rows have one direction");
    direction_.push_back(r.direction);
    values_.push_back(r.C);
  }
}

double FlowCoefficients::largest() const {
  double size = 0;
  for (const Vec3& C : values_) size = std::max(size, C.cwiseAbs().maxCoeff());
  return size;
}

void FlowCoefficients::at(double direction, Vec3& C, Vec3& by_direction) const {
  by_direction.setZero();
  if (none()) {
    C.setZero();
    return;
  }
  const TablePlace p = direction_place(direction_, direction);
  const Vec3 change = values_[p.high] - values_[p.low];
  C = values_[p.low] + p.weight * change;
  if (p.low != p.high) by_direction = change / all_round(direction_[p.high] - direction_[p.low]);
}

// With U² = c_x² + c_y²: d U² = 2 (c_x, c_y)·dc and U² da = (-c_y, c_x)·dc, which avoids division by U.
FlowForce flow_force(const BodyFlow& b, double cx, double cy) {
  FlowForce out;
  Vec3 C, by_direction;
  b.coefficients.at(std::atan2(cy, cx), C, by_direction);
  const Vec3 scale = 0.5 * b.density * Vec3(b.frontal, b.lateral, b.lateral * b.length);
  out.force = scale.cwiseProduct(C) * (cx * cx + cy * cy);
  out.slope.col(0) = scale.cwiseProduct(2 * cx * C - cy * by_direction);
  out.slope.col(1) = scale.cwiseProduct(2 * cy * C + cx * by_direction);
  return out;
}

Vec3 relative_flow(const BodyFlow& b, const RigidBodyState& s, const Vec3& velocity) {
  return s.q.conjugate() * (velocity - s.v) - s.w.cross(b.arm);
}

// With u' = R^T (u - v), c = u' - w x arm and the height z of the point:
//   dc = u'^ dphi - R^T dv + arm^ dw + R^T u_z dz,   dz = e_z·dx - (R^T e_z x arm)·dphi
//   d (R F) = R (dF - F^ dphi)
BodyFlowResidual body_flow(const BodyFlow& b, const RigidBodyState& s, const FlowVelocity& flow) {
  BodyFlowResidual out;
  const Mat3 Rt = s.q.conjugate().toRotationMatrix();
  const Vec3 c = relative_flow(b, s, flow.velocity);
  const FlowForce g = flow_force(b, c.x(), c.y());
  const Vec3 F(g.force.x(), g.force.y(), 0);
  out.f << -(s.q * F), -(b.arm.cross(F) + Vec3(0, 0, g.force.z()));

  using Mat36 = Eigen::Matrix<double, 3, 6>;
  const Mat3 arm = hat(b.arm);
  Mat36 c_by_place, c_by_rate;
  const Eigen::RowVector3d up = Rt.col(2).transpose();
  Eigen::RowVector<double, 6> height;
  height << 0, 0, 1, -up * arm;
  c_by_place << Mat3::Zero(), hat(Rt * (flow.velocity - s.v));
  c_by_place += Rt * flow.by_height * height;
  c_by_rate << -Rt, arm;
  Mat3 F_by_c = Mat3::Zero();
  F_by_c.topLeftCorner<2, 2>() = g.slope.topRows<2>();
  Mat3 M_by_c = arm * F_by_c;
  M_by_c.row(2).head<2>() += g.slope.row(2);
  const auto derivative = [&](const Mat36& by) {
    Mat6 out_of;
    out_of << -(Rt.transpose() * F_by_c * by), -(M_by_c * by);
    return out_of;
  };
  out.K = derivative(c_by_place);
  out.K.topRightCorner<3, 3>() += Rt.transpose() * hat(F);
  out.C = derivative(c_by_rate);
  return out;
}

}  // namespace hawser
