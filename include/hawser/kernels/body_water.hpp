// What water does to a rigid body that is small beside the waves: buoyancy, drag, added mass and
// Froude-Krylov force in the body's axes, with a share that is wet. See docs/theory/bodies-in-water.md.
#pragma once

#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

struct BodyInWater {
  Vec3 centre = Vec3::Zero(), drag_centre = Vec3::Zero();  // m, from the centre of mass, body axes
  double height = 1;                                       // m, over which it gets wet
  double buoyancy = 0, displaced_mass = 0;                 // N, kg, of the whole volume
  Vec3 added = Vec3::Zero(), drag = Vec3::Zero();          // kg; kg/m, rho Cd A/2: along the body's axes
  // A part of a member along z: drag across it goes with the velocity across it, and along it with that along
  // it, in place of the whole velocity.
  bool cross_flow = false;
};

// N, axes of the body, by the relative velocity u of the water:
//   |u| c o u,   or with cross_flow  c o (|u_n| u_x, |u_n| u_y, |u_z| u_z),   u_n = (u_x, u_y)
// and its derivative.
Vec3 body_drag(const BodyInWater& body, const Vec3& u);
Mat3 body_drag_by_velocity(const BodyInWater& body, const Vec3& u);

// Forces on the body, N, space axes: at the centre of buoyancy and at that of drag.
struct BodyWaterForce {
  Vec3 at_centre, at_drag;
};

// Residual (minus the forces) by the position of the centre of mass (space axes) and rotation (body axes), as
// in rigid_body(). `centre`, `drag`: the water at both centres; at the former its surface and acceleration
// count, at the latter its velocity. convex: of the derivatives by configuration only what holds the body.
struct BodyWaterResidual {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero(), C = Mat6::Zero(), M = Mat6::Zero();
};
BodyWaterForce body_water_force(const BodyInWater& body, const RigidBodyState& s, const Water& centre,
                                const Water& drag);
void body_water(const BodyInWater& body, const RigidBodyState& s, const Water& centre, const Water& drag,
                bool tangent, bool convex, BodyWaterResidual& out);

// J: potential of buoyancy below a level surface.
double body_water_potential(const BodyInWater& body, const RigidBodyState& s, double surface);

}  // namespace hawser
