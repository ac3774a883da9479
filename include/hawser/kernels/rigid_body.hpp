// Rigid body with mass, held by springs and dampers: residual and exact derivatives.
//
// Unknowns: position x of the centre of mass (space axes) and material rotation increments. The residual is
// inertia + holding force - applied; its moments are in body axes.
//   f = m (a + g) + k (x - x0) + c (v - v0)
//   t = J alpha + w x J w + T(phi)^-T kr phi + cr (w - R^T W0),  phi = log(R0^T R)
// T is the right Jacobian of the exponential, so the moment is the gradient of phi . kr phi / 2. Springs and
// dampers with full matrices (spring_matrices.hpp) add to the holding force.
#pragma once

#include "hawser/kernels/motion.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// Springs and dampers with full matrices between a point of the body and the same point of the body at rest.
struct SpringMatrices {
  // N/m, N, N m/rad (symmetric) and N s/m, N s, N m s, in axes of the body at rest.
  Mat6 stiffness = Mat6::Zero();
  Mat6 damping = Mat6::Zero();
  Vec3 arm = Vec3::Zero();  // m, from the centre of mass to the point, body axes

  bool none() const { return stiffness.isZero(0) && damping.isZero(0); }
};

struct RigidBodyData {
  double mass = 0;              // kg
  Mat3 inertia = Mat3::Zero();  // kg m², about the centre of mass, body axes
  Mat6 coupled = Mat6::Zero();  // full inertia matrix in addition to these (coupled_mass.hpp)
  Vec3 weight = Vec3::Zero();   // N, weight not carried otherwise
  Vec3 stiffness = Vec3::Zero(), damping = Vec3::Zero();                  // N/m, N s/m, space axes
  Vec3 turning_stiffness = Vec3::Zero(), turning_damping = Vec3::Zero();  // N m/rad, N m s/rad, body axes
  SpringMatrices matrices;
};

struct RigidBodyState {
  Vec3 x = Vec3::Zero();  // m, centre of mass
  Quat q = Quat::Identity();
  Vec3 v = Vec3::Zero(), a = Vec3::Zero();      // m/s, m/s², space axes
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();  // rad/s, rad/s², body axes
};

// Parts of the residual, stored separately because their sum does not show the magnitude of the forces where
// they cancel (a body in free fall or tumbling).
struct RigidBodyResidual {
  // N, space axes; N m, body axes.
  Vec6 inertia = Vec6::Zero();  // m a; J alpha
  Vec6 applied = Vec6::Zero();  // - W; w x J w
  Vec6 springs = Vec6::Zero();  // including dampers
  // Derivatives of the sum by position [m] and rotation [rad, body axes], their rates and accelerations.
  Mat6 K = Mat6::Zero(), C = Mat6::Zero(), M = Mat6::Zero();

  Vec6 f() const { return inertia + applied + springs; }
};

// `rest`: pose and velocities of the centre of mass at which the springs are at rest. The energy has a kink
// at rotations of half a turn from there, because phi is the shortest rotation.
RigidBodyResidual rigid_body(const RigidBodyData& body, const RigidBodyState& s, const RigidPose& rest);

// Force and moment on a body, in space axes or turning with the body. arm: from the centre of mass to the
// force, m, body axes.
struct RigidBodyLoad {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
  Vec3 arm = Vec3::Zero();
  bool body_fixed = false;
  bool constant = true;
};
// Adds the load to `applied` and K: with F, N in body axes f = -R F, t = -(arm x F + N).
void add_load(const RigidBodyLoad& load, const RigidBodyState& s, RigidBodyResidual& to);
// A constant force in space axes has a potential, J; moments and varying or turning loads supply power, W.
double load_potential(const RigidBodyLoad& load, const RigidBodyState& s);
double load_power(const RigidBodyLoad& load, const RigidBodyState& s);
// Work of loads without a potential from `start` to s, J, for the force and moment in space that they have at
// `start`.
double load_work(const RigidBodyLoad& load, const RigidBodyState& start, const RigidBodyState& s);

// Kinetic energy, and energy of the springs, J.
double rigid_body_kinetic(const RigidBodyData& body, const RigidBodyState& s);
double rigid_body_strain(const RigidBodyData& body, const RigidBodyState& s, const RigidPose& rest);

}  // namespace hawser
