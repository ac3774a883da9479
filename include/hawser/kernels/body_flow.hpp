// Force of a steady flow (wind, current) on a body from coefficients by flow direction, in the form of
// OCIMF's tables. See docs/theory/wind-and-current.md.
#pragma once

#include <vector>

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

// Coefficients C_x, C_y, C_n by the direction towards which the flow goes, from the body's x axis,
// anticlockwise; linear and periodic interpolation.
class FlowCoefficients {
 public:
  struct Row {
    double direction = 0;  // rad
    Vec3 C = Vec3::Zero();
  };
  FlowCoefficients() = default;
  // Rows in any order; throws std::invalid_argument if two have the same direction.
  explicit FlowCoefficients(std::vector<Row> rows);

  bool none() const { return direction_.empty(); }
  // Largest absolute value of C_x, C_y and C_n in the table; 0 without rows.
  double largest() const;
  // by_direction: 1/rad, slope between the neighbouring rows; at a row the slope on its left.
  void at(double direction, Vec3& C, Vec3& by_direction) const;

 private:
  std::vector<double> direction_;
  std::vector<Vec3> values_;
};

// Force on the body at a reference point, with c the flow velocity relative to that point in body axes and a
// the direction of (c_x, c_y):
//   F = rho/2 (c_x² + c_y²) (C_x(a) A_T, C_y(a) A_L, 0),   M = rho/2 (c_x² + c_y²) C_n(a) A_L L  about z
struct BodyFlow {
  FlowCoefficients coefficients;
  double density = 0;               // kg/m³, of the medium
  double frontal = 0, lateral = 0;  // m², A_T and A_L
  double length = 0;                // m, L
  Vec3 arm = Vec3::Zero();          // m, from the centre of mass to the point, body axes
};

// Velocity of the flow at the point, space axes, and its derivative by height.
struct FlowVelocity {
  Vec3 velocity = Vec3::Zero();   // m/s
  Vec3 by_height = Vec3::Zero();  // 1/s
};

// F_x, F_y [N] and M [N m], and their derivatives by c_x and c_y [m/s].
struct FlowForce {
  Vec3 force = Vec3::Zero();
  Eigen::Matrix<double, 3, 2> slope = Eigen::Matrix<double, 3, 2>::Zero();
};
FlowForce flow_force(const BodyFlow& b, double cx, double cy);

// Flow velocity c relative to the point, body axes, m/s.
Vec3 relative_flow(const BodyFlow& b, const RigidBodyState& s, const Vec3& velocity);

// Residual on the body's unknowns, minus force [N, space axes] and moment [N m, body axes], and its
// derivatives by increments of position [m] and material rotation [rad] (K) and by v [m/s] and w [rad/s] (C).
struct BodyFlowResidual {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero(), C = Mat6::Zero();
};
BodyFlowResidual body_flow(const BodyFlow& b, const RigidBodyState& s, const FlowVelocity& flow);

}  // namespace hawser
