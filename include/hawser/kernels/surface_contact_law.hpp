// Contact of one point of a line with the surface of a body, in the body's frame: force, history and exact
// tangent from a surface query. It is a pure function of the state at the start of the step and the trial.
#pragma once

#include "hawser/kernels/contact_law.hpp"
#include "hawser/kernels/friction_law.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct ContactLaw {
  NormalLaw normal;
  FrictionLaw friction;
  bool operator==(const ContactLaw&) const = default;
};

// State at the start of the step, body frame. U is a scalar with derivatives if the state varies along the
// line.
template <class U>
struct ContactStartOf {
  Vector3<U> point = Vector3<U>::Zero();     // m, the point of the line
  U gap = U(0);                              // m
  Vector3<U> tangent = Vector3<U>::UnitX();  // of the line, unit
  Vector3<U> slip = Vector3<U>::Zero();      // m, elastic slip; zero if the point did not touch
  Vector3<U> normal = Vector3<U>::UnitZ();   // surface normal to which the slip belongs
  U peak = U(0);                             // N, largest normal force since the point touched; 0: none yet
};
using ContactStart = ContactStartOf<double>;

// The trial, body frame. The gap is the signed distance to the surface minus the radius of the line.
struct ContactTrial {
  Vec3 point = Vec3::Zero();      // m
  Vec3 velocity = Vec3::Zero();   // m/s, relative to the body's material point there
  double gap = 0;                 // m
  Vec3 normal = Vec3::UnitZ();    // unit gradient of the gap
  Mat3 curvature = Mat3::Zero();  // 1/m, its Hessian
  // Friction at the line's surface. roll: rotation of the line about its axis relative to the body since the
  // start of the step, rad. lever: the line's radius, m; 0: friction acts at the axis.
  double roll = 0, lever = 0;
  double step = 0;  // s, length of the step, for the damping of friction between bodies; 0: no damping
};

struct ContactForce {
  NormalForce along_normal;
  Vec3 force = Vec3::Zero();     // N, on the line: normal and friction
  Vec3 friction = Vec3::Zero();  // N
  Vec3 slip = Vec3::Zero();      // m, elastic slip that remains
  double peak = 0;               // N, largest normal force since the point touched; 0 without friction
  bool slides = false;
  Mat3 by_point = Mat3::Zero();     // N/m, d force / d point at fixed velocity; filled on request
  Mat3 by_velocity = Mat3::Zero();  // N s/m
  Vec3 by_roll = Vec3::Zero();      // N, d force / d roll
};

// The trial slip is the old slip, rotated with the normal, plus the tangential displacement of the point
// since it touched. If the point met the surface within the step, only the displacement after that counts.
ContactForce surface_contact(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                             bool derivatives);

struct BallContact : ContactForce {
  Mat3 by_turn = Mat3::Zero();  // N, d force / d turn
};

// Contact of a ball of the radius trial.lever [m] about the point, fixed to a body that has rotated by the
// rotation vector `turn` [rad], axes of the surface, relative to it since the start of the step. Friction
// acts at the contact point with the arm -lever n, which the rotation moves by -lever turn x n.
BallContact ball_contact(const ContactLaw& law, const ContactStart& start, const ContactTrial& trial,
                         const Vec3& turn, bool derivatives);

}  // namespace hawser
