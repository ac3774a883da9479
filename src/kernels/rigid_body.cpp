// Inertia, gyroscopic moment, springs and dampers of a rigid body: residual, exact matrices by position,
// velocity and acceleration, kinetic and spring energy.
#include "hawser/kernels/rigid_body.hpp"

#include <array>

#include "hawser/kernels/coupled_mass.hpp"
#include "hawser/kernels/frame_point.hpp"
#include "hawser/kernels/spring_matrices.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

Vec3 turned(const RigidBodyState& s, const RigidPose& rest) {
  return log_so3(rest.rotation.conjugate() * s.q);
}

}  // namespace

// f = m a - W + k (x - x0) + c (v - v0)                             in space axes,
// t = J alpha + w x J w + T(phi)^-T k_r phi + c_r (w - R' W0)       in body axes,   phi = log(R0' R)
// (docs/theory/body-contact.md).
RigidBodyResidual rigid_body(const RigidBodyData& b, const RigidBodyState& s, const RigidPose& rest) {
  RigidBodyResidual r;
  const Vec3 phi = turned(s, rest);
  const Vec3 p = b.turning_stiffness.cwiseProduct(phi);
  const Vec3 W0 = s.q.conjugate() * rest.angular_velocity;
  const Vec3 Jw = b.inertia * s.w;
  const Mat3 T = inverse_right_jacobian(phi);
  r.inertia.head<3>() = b.mass * s.a;
  r.inertia.tail<3>() = b.inertia * s.alpha;
  r.applied.head<3>() = -b.weight;
  r.applied.tail<3>() = s.w.cross(Jw);
  r.springs.head<3>() =
      b.stiffness.cwiseProduct(s.x - rest.position) + b.damping.cwiseProduct(s.v - rest.velocity);
  r.springs.tail<3>() = T.transpose() * p + b.turning_damping.cwiseProduct(s.w - W0);
  r.K.topLeftCorner<3, 3>() = b.stiffness.asDiagonal();
  r.K.bottomRightCorner<3, 3>() =
      (inverse_jacobian_transposed_slope(phi, p) + T.transpose() * Mat3(b.turning_stiffness.asDiagonal())) *
          T -
      Mat3(b.turning_damping.asDiagonal()) * hat(W0);
  r.C.topLeftCorner<3, 3>() = b.damping.asDiagonal();
  r.C.bottomRightCorner<3, 3>() = hat(s.w) * b.inertia - hat(Jw) + Mat3(b.turning_damping.asDiagonal());
  r.M.topLeftCorner<3, 3>() = b.mass * Mat3::Identity();
  r.M.bottomRightCorner<3, 3>() = b.inertia;
  if (!b.coupled.isZero(0)) add_coupled_mass(b.coupled, s, r);
  const SpringMatrixForces full = spring_matrix_forces(b.matrices, s, rest);
  r.springs += full.f;
  r.K += full.K;
  r.C += full.C;
  return r;
}

namespace {

// Force and moment about the centre of mass, body axes.
std::array<Vec3, 2> load_in_body(const RigidBodyLoad& load, const RigidBodyState& s) {
  const Quat to_body = load.body_fixed ? Quat::Identity() : s.q.conjugate();
  const Vec3 F = to_body * load.force;
  return {F, load.arm.cross(F) + to_body * load.moment};
}

}  // namespace

void add_load(const RigidBodyLoad& load, const RigidBodyState& s, RigidBodyResidual& to) {
  const auto [F, moment] = load_in_body(load, s);
  to.applied.head<3>() -= s.q * F;
  to.applied.tail<3>() -= moment;
  const FramePoint point{load.arm, s.q.toRotationMatrix()};
  if (load.body_fixed)
    to.K.topRightCorner<3, 3>() -= point.vector_by_turn(s.q * F);
  else
    to.K.bottomRightCorner<3, 3>() -=
        point.moment_by_turn(load.force) + point.components_by_turn(load.moment);
}

double load_potential(const RigidBodyLoad& load, const RigidBodyState& s) {
  return load.body_fixed ? 0 : -load.force.dot(s.x + s.q * load.arm);
}

// F·(dx + dR arm) + M·theta, with theta the rotation vector of the displacement in space.
double load_work(const RigidBodyLoad& load, const RigidBodyState& start, const RigidBodyState& s) {
  const Vec3 theta = start.q * log_so3(start.q.conjugate() * s.q);
  const Vec3 displacement = s.x - start.x + s.q * load.arm - start.q * load.arm;
  if (load.body_fixed) return (start.q * load.force).dot(displacement) + (start.q * load.moment).dot(theta);
  return load.moment.dot(theta) + (load.constant ? 0 : load.force.dot(displacement));
}

double load_power(const RigidBodyLoad& load, const RigidBodyState& s) {
  if (!load.body_fixed) {
    const double moments = load.moment.dot(s.q * s.w);
    return load.constant ? moments : moments + load.force.dot(s.v + s.q * s.w.cross(load.arm));
  }
  return (s.q * load.force).dot(s.v) + (load.arm.cross(load.force) + load.moment).dot(s.w);
}

double rigid_body_kinetic(const RigidBodyData& b, const RigidBodyState& s) {
  return 0.5 * b.mass * s.v.squaredNorm() + 0.5 * s.w.dot(b.inertia * s.w) + coupled_kinetic(b.coupled, s);
}

double rigid_body_strain(const RigidBodyData& b, const RigidBodyState& s, const RigidPose& rest) {
  const Vec3 d = s.x - rest.position;
  const Vec3 phi = turned(s, rest);
  return 0.5 * d.dot(b.stiffness.cwiseProduct(d)) + 0.5 * phi.dot(b.turning_stiffness.cwiseProduct(phi)) +
         spring_matrix_forces(b.matrices, s, rest).potential;
}

}  // namespace hawser
