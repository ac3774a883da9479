// Buoyancy, drag and inertia of the water on a rigid body: force, exact matrices by position, rotation and
// their rates, and the potential of buoyancy.
#include "hawser/kernels/body_water.hpp"

#include <cmath>

#include "hawser/kernels/frame_point.hpp"
#include "hawser/kernels/wetting.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

double depth(const BodyInWater& b, const RigidBodyState& s, double surface) {
  return (surface - s.x.z() - (s.q * b.centre).z()) / (0.5 * b.height);
}

// Forces on a fully submerged body, body axes.
struct SubmergedForces {
  Vec3 at_centre, at_drag;
  Vec3 steady;    // part of at_centre that does not turn with the body
  Vec3 relative;  // m/s², acceleration of the water minus that of the body
  Vec3 flow;      // m/s, velocity of the water minus that of the body
  Vec3 g;         // m/s², acceleration of the centre minus that of the centre of mass
};

SubmergedForces submerged_forces(const BodyInWater& b, const RigidBodyState& s, const Water& centre,
                                 const Water& drag) {
  SubmergedForces o;
  const Quat back = s.q.conjugate();
  o.g = s.alpha.cross(b.centre) + s.w.cross(s.w.cross(b.centre));
  o.steady = back * Vec3(b.buoyancy * Vec3::UnitZ() + b.displaced_mass * centre.acceleration);
  o.relative = back * Vec3(centre.acceleration - s.a) - o.g;
  o.at_centre = o.steady + b.added.cwiseProduct(o.relative);
  o.flow = back * Vec3(drag.velocity - s.v) - s.w.cross(b.drag_centre);
  o.at_drag = body_drag(b, o.flow);
  return o;
}

}  // namespace

Vec3 body_drag(const BodyInWater& b, const Vec3& u) {
  if (!b.cross_flow) return u.norm() * b.drag.cwiseProduct(u);
  const double across = u.head<2>().norm();
  return b.drag.cwiseProduct(Vec3(across * u.x(), across * u.y(), std::abs(u.z()) * u.z()));
}

// d(|u| c o u) = (|u| diag(c) + (c o u) u'/|u|) du, likewise for the transverse velocity; d(|u_z| u_z) = 2
// |u_z| du_z.
Mat3 body_drag_by_velocity(const BodyInWater& b, const Vec3& u) {
  const Vec3 counts = b.cross_flow ? Vec3(u.x(), u.y(), 0) : u;
  const double speed = counts.norm();
  Mat3 D = speed * Mat3(b.drag.asDiagonal());
  if (speed > 0) D += b.drag.cwiseProduct(counts) * counts.transpose() / speed;
  if (b.cross_flow) D(2, 2) = 2 * b.drag.z() * std::abs(u.z());
  return D;
}

// f_b = F [rho g V e_z + rho V a_w + R A R' (a_w - a_b)]      at b: buoyancy, Froude-Krylov, added mass
// f_d = F R (|u| c o u),  u = R' (u_w - v_d)                  at d: drag (docs/theory/bodies-in-water.md)
BodyWaterForce body_water_force(const BodyInWater& b, const RigidBodyState& s, const Water& centre,
                                const Water& drag) {
  const double wet = even_wetting(depth(b, s, centre.surface)).fraction;
  const SubmergedForces o = submerged_forces(b, s, centre, drag);
  return {wet * (s.q * o.at_centre), wet * (s.q * o.at_drag)};
}

// With F = 1, r_b = R' f_b = q + A e, r_d = R' f_d, g = alpha x b + w x (w x b), D = |u| diag(c) + (c o u)
// u'/|u|:
//   dr_b = [q^ + A (e + g)^] theta + A [(w x b)^ + w^ b^] dw + A [b^ dalpha - R' da]
//   dr_d = D [(u + w x d)^ theta + d^ dw - R' dv + R' u_w,z (dz + (d x R' e_z).theta)]
//   dF   = -F'/(H/2) (dz + (b x R' e_z).theta)
void body_water(const BodyInWater& b, const RigidBodyState& s, const Water& centre, const Water& drag,
                bool tangent, bool convex, BodyWaterResidual& out) {
  using Columns = Eigen::Matrix<double, 3, 6>;  // position, rotation
  const Wetting wet = even_wetting(depth(b, s, centre.surface));
  const SubmergedForces o = submerged_forces(b, s, centre, drag);
  const Vec3 all = o.at_centre + o.at_drag;
  out.f << -wet.fraction * (s.q * all),
      -wet.fraction * (b.centre.cross(o.at_centre) + b.drag_centre.cross(o.at_drag));
  if (!tangent) return;
  const Mat3 R = s.q.toRotationMatrix();
  const Mat3 c = hat(b.centre);
  const Mat3 d = hat(b.drag_centre);
  const Vec3 up = R.row(2);  // body axes
  // Derivative of the wet fraction by position and rotation: it decreases as the centre rises.
  Vec6 rise;
  rise << Vec3::UnitZ(), b.centre.cross(up);
  const Vec6 shares = -wet.slope / (0.5 * b.height) * rise;
  if (convex) {
    out.K = -b.buoyancy * rise * shares.transpose();
    out.K.bottomRightCorner<3, 3>() +=
        FramePoint{b.centre, R}.convex_moment_by_turn(-wet.fraction * b.buoyancy * Vec3::UnitZ());
    return;
  }
  // Derivative of drag by the water velocity.
  const Mat3 D = body_drag_by_velocity(b, o.flow);
  const Mat3 A = b.added.asDiagonal();
  // Derivatives of the two forces in body axes by (x, theta), (v, w), (a, alpha).
  Columns centre_K = Columns::Zero(), centre_C = Columns::Zero(), centre_M = Columns::Zero();
  Columns drag_K = Columns::Zero(), drag_C = Columns::Zero();
  centre_K.rightCols<3>() = hat(o.steady) + A * hat(o.relative + o.g);
  centre_C.rightCols<3>() = A * (hat(s.w.cross(b.centre)) + hat(s.w) * c);
  centre_M << -A * R.transpose(), A * c;
  drag_K.rightCols<3>() = D * hat(o.flow + s.w.cross(b.drag_centre));
  Vec6 deeper;
  deeper << Vec3::UnitZ(), b.drag_centre.cross(up);
  drag_K += D * (R.transpose() * drag.by_height) * deeper.transpose();
  drag_C << -D * R.transpose(), D * d;
  const auto put = [&](const Columns& at_centre, const Columns& at_drag, Mat6& to) {
    to.topRows<3>() = -wet.fraction * R * (at_centre + at_drag);
    to.bottomRows<3>() = -wet.fraction * (c * at_centre + d * at_drag);
  };
  put(centre_K, drag_K, out.K);
  put(centre_C, drag_C, out.C);
  put(centre_M, Columns::Zero(), out.M);
  out.K.topRightCorner<3, 3>() += wet.fraction * R * hat(all);
  Vec6 wholly;
  wholly << R * all, b.centre.cross(o.at_centre) + b.drag_centre.cross(o.at_drag);
  out.K -= wholly * shares.transpose();
}

double body_water_potential(const BodyInWater& b, const RigidBodyState& s, double surface) {
  return 0.5 * b.height * b.buoyancy * even_wetting(depth(b, s, surface)).integral;
}

}  // namespace hawser
