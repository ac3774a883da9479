// Sum of contact forces over points of a body: the law at each point and its derivatives by a motion of the
// body. See docs/theory/body-contact.md.
#include "body_contact_points.hpp"

#include <algorithm>

#include "hawser/kernels/frame_point.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {

BodyContactPoints::BodyContactPoints(const BodyFrame& body, const BodyFrame& surface, const Vec3& turned,
                                     double step, const AxisContactMode& mode)
    : body_(body),
      mode_(mode),
      turn_(surface.R.transpose() * body.R),
      to_axes_(surface.R.transpose()),
      centre_(surface.to_body(body.x)),
      surface_centre_(surface.centre),
      velocity_(to_axes_ * (body.v - surface.velocity(centre_))),
      turning_(turn_ * body.w - surface.w),
      body_turning_(turn_ * body.w),
      surface_velocity_slope_(-hat(surface.w)),
      turned_(turned),
      step_(step),
      turned_by_turn_(inverse_right_jacobian(-turned)) {}

ContactTrial BodyContactPoints::trial(const SurfacePoint& at, const Vec3& z, double radius) const {
  ContactTrial t;
  t.point = z;
  t.gap = at.distance - radius;
  t.normal = at.normal;
  if (!mode_.convex) t.curvature = at.curvature;
  if (mode_.moves) t.velocity = velocity_ + turning_.cross(z - centre_);
  t.lever = radius;
  t.step = step_;
  return t;
}

// Motions (d, t) of the body are in axes of the surface, so that its points have the FramePoint with R = 1:
//   dz = d + E t,   dv = -w_s x dz + E' t,   dphi = J_l(phi)^-1 t,
// with the angular velocity w_s of the surface and the rotation vector phi since the start of the step. The
// force acts at the arm c = b - r n, where a ball touches: the moment is E_c' f, and in body axes the arm
// changes by -r (n^ t + H dz).
AxisContactPoint BodyContactPoints::add(const ContactLaw& law, const ContactStart& start,
                                        const SurfacePoint& at, const Vec3& z, double radius, double weight) {
  const Vec3 arm = z - centre_;
  const ContactTrial trial = this->trial(at, z, radius);
  const BallContact c = radius > 0 ? ball_contact(law, start, trial, turned_, mode_.tangent)
                                   : BallContact{surface_contact(law, start, trial, mode_.tangent)};
  AxisContactPoint point(c, trial.normal, mode_.moves);
  point.weight = weight;
  point.gap = trial.gap;
  if (c.along_normal.elastic > 0) {
    active_ = true;
    potential_ += weight * c.along_normal.potential;
    depth_ = std::max(depth_, -trial.gap);
  }
  if (!(c.along_normal.force > 0)) return point;
  touching_.weight += weight;
  touching_.force += weight * c.along_normal.force;
  touching_.peak = std::max(touching_.peak, point.peak);
  touching_.lever_a = std::max(touching_.lever_a, arm.norm());
  touching_.lever_b = std::max(touching_.lever_b, (z - surface_centre_).norm());
  const Vec3 f = -weight * c.force;
  const FramePoint moved{arm, Mat3::Identity(), body_turning_};
  const FramePoint touch{arm - radius * trial.normal};
  force_ += f;
  moment_ += touch.moment(f);
  if (!mode_.tangent) return point;
  const Mat3 E = moved.by_turn();
  const Mat3 to_moment = touch.by_turn().transpose();
  const auto add_to = [&to_moment](Mat6& sum, const Mat3& by_position, const Mat3& by_turn) {
    sum.topLeftCorner<3, 3>() += by_position;
    sum.topRightCorner<3, 3>() += by_turn;
    sum.bottomLeftCorner<3, 3>() += to_moment * by_position;
    sum.bottomRightCorner<3, 3>() += to_moment * by_turn;
  };
  Mat3 by_position = -weight * c.by_point;
  Mat3 by_turn = Mat3::Zero();
  if (radius > 0) by_turn -= weight * c.by_turn * turned_by_turn_;
  if (mode_.moves && (law.normal.damping > 0 || law.friction.blends())) {
    const Mat3 by_velocity = -weight * c.by_velocity;
    by_position += by_velocity * surface_velocity_slope_;
    by_turn += by_velocity * moved.velocity_by_turn();
    add_to(C_, by_velocity, by_velocity * E);
  }
  add_to(K_, by_position, by_turn + by_position * E);
  if (mode_.convex) return point;
  K_.bottomRightCorner<3, 3>() += touch.moment_by_turn(f);
  if (!(radius > 0)) return point;
  const Mat3 by_normal = -radius * touch.moment_by_position(f);
  const Mat3& H = trial.curvature;
  K_.bottomLeftCorner<3, 3>() += by_normal * H;
  K_.bottomRightCorner<3, 3>() += by_normal * (H * E + touch.components_by_turn(trial.normal));
  return point;
}

// The end stays at the same gap g(z(xi)): n . (d + t x b + z' dxi) = 0.
Vec6 BodyContactPoints::end_by_motion(const Vec3& z, const Vec3& normal, const Vec3& slope) const {
  return (Vec6() << normal, (z - centre_).cross(normal)).finished() / -normal.dot(slope);
}

// With the end e, the sum of the panel changes by d(w)/de (f, c x f) + w d(xi)/de d/dxi (f, c x f), where c =
// b - r n, c' = z' - r H z'.
void BodyContactPoints::add_moving_ends(const ContactLaw& law, const ContactStart& start,
                                        const SurfacePoint& at, const Vec3& z, double radius,
                                        const AxisContactPoint& point, const Vec3& slope, ContactRates rates,
                                        std::span<const MovingEnd> ends) {
  if (!(point.normal_force > 0)) return;
  const ContactTrial trial = this->trial(at, z, radius);
  rates.point = slope;
  if (mode_.moves) rates.velocity = turning_.cross(slope);
  const Vec3 f = -point.force;
  const Vec3 along = -ball_force_along(law, start, trial, turned_, rates);
  const Vec3 touch = z - centre_ - radius * trial.normal;
  const Vec3 touch_along = slope - radius * trial.curvature * slope;
  const Vec6 by_force = (Vec6() << f, touch.cross(f)).finished();
  const Vec6 change = (Vec6() << along, touch_along.cross(f) + touch.cross(along)).finished();
  for (const MovingEnd& end : ends)
    K_ += (end.weight * by_force + end.place * change) * end.by_motion.transpose();
}

// Positions are in space axes, rotations in body axes.
void BodyContactPoints::to_body(BlockVector& f, BlockMatrix* K, BlockMatrix* C) const {
  Mat6 T = Mat6::Zero();
  T.topLeftCorner<3, 3>() = to_axes_;
  T.bottomRightCorner<3, 3>() = turn_;
  Vec6 sum;
  sum << force_, moment_;
  f += T.transpose() * sum;
  if (K) *K += T.transpose() * K_ * T;
  if (C) *C += T.transpose() * C_ * T;
}

}  // namespace hawser
