// A rigid body with mass that springs and dampers hold at a place: its residual and exact derivatives.
//
// Unknowns: position x of the centre of mass (space axes) and material rotation increments. The residual is
// inertia + holding force - applied; its moments are in the body's axes.
//   f = m (a + g) + k (x - x0) + c (v - v0)
//   t = J alpha + w x J w + T(phi)^-T kr phi + cr (w - R^T W0),  phi = log(R0^T R)
// T is the right Jacobian of the exponential, so the moment is the gradient of phi . kr phi / 2.
#pragma once

#include "hawser/kernels/motion.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct RigidBodyData {
  double mass = 0;                                        // kg
  Mat3 inertia = Mat3::Zero();                            // kg m², about the centre of mass, body axes
  Mat6 coupled = Mat6::Zero();                            // of a full matrix beyond them (coupled_mass.hpp)
  Vec3 weight = Vec3::Zero();                             // N, force of gravity that nothing else carries
  Vec3 stiffness = Vec3::Zero(), damping = Vec3::Zero();  // N/m, N s/m, space axes
  Vec3 turning_stiffness = Vec3::Zero(), turning_damping = Vec3::Zero();  // N m/rad, N m s/rad, body axes
};

struct RigidBodyState {
  Vec3 x = Vec3::Zero();  // m, centre of mass
  Quat q = Quat::Identity();
  Vec3 v = Vec3::Zero(), a = Vec3::Zero();      // m/s, m/s², space axes
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();  // rad/s, rad/s², body axes
};

// Its parts apart: where they cancel (a body that falls, or tumbles freely) their sum does not say how large
// the forces are.
struct RigidBodyResidual {
  Vec6 inertia = Vec6::Zero();  // m a; J alpha
  Vec6 applied = Vec6::Zero();  // - W; w x J w
  Vec6 springs = Vec6::Zero();  // and dampers
  Mat6 K = Mat6::Zero(), C = Mat6::Zero(), M = Mat6::Zero();

  Vec6 f() const { return inertia + applied + springs; }
};

// `rest`: where the springs pull the centre of mass to, with its velocities. Rotations of half a turn from
// there are a kink of the energy: phi is the shortest rotation.
RigidBodyResidual rigid_body(const RigidBodyData& body, const RigidBodyState& s, const RigidPose& rest);

// A force and moment on it. In axes of space, or turning with the body; `arm` [m] of the force from the
// centre of mass, body axes.
struct RigidBodyLoad {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
  Vec3 arm = Vec3::Zero();
  bool body_fixed = false;
  bool constant = true;
};
// Adds what they have in `applied` and K: with F, N in body axes f = -R F, t = -(arm x F + N).
void add_load(const RigidBodyLoad& load, const RigidBodyState& s, RigidBodyResidual& to);
// A constant force that stays has a potential, J. Moments, and what changes or follows the body, bring in
// power, W.
double load_potential(const RigidBodyLoad& load, const RigidBodyState& s);
double load_power(const RigidBodyLoad& load, const RigidBodyState& s);
// J, work on the way from `start` to s of what has no potential, which keeps there the force and moment in
// space that it has at `start`.
double load_work(const RigidBodyLoad& load, const RigidBodyState& start, const RigidBodyState& s);

// J: kinetic, and stored by the springs.
double rigid_body_kinetic(const RigidBodyData& body, const RigidBodyState& s);
double rigid_body_strain(const RigidBodyData& body, const RigidBodyState& s, const RigidPose& rest);

}  // namespace hawser
