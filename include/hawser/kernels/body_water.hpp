// Water forces on a rigid body that is small compared with the waves: buoyancy, drag, added mass and
// Froude-Krylov force in body axes, with a wet fraction. See docs/theory/bodies-in-water.md.
#pragma once

#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

struct BodyInWater {
  Vec3 centre = Vec3::Zero(), drag_centre = Vec3::Zero();  // m, from the centre of mass, body axes
  double height = 1;                                       // m, height over which it gets wet
  double buoyancy = 0, displaced_mass = 0;                 // N, kg, of the full volume
  Vec3 added = Vec3::Zero(), drag = Vec3::Zero();          // kg; kg/m, rho Cd A/2: by body axis
  // Part of a member along z: transverse drag depends on the transverse velocity and axial drag on the axial
  // velocity, instead of on the whole velocity.
  bool cross_flow = false;
};

// Drag [N], body axes, for the relative velocity u of the water, and its derivative:
//   |u| c o u,   or with cross_flow  c o (|u_n| u_x, |u_n| u_y, |u_z| u_z),   u_n = (u_x, u_y)
Vec3 body_drag(const BodyInWater& body, const Vec3& u);
Mat3 body_drag_by_velocity(const BodyInWater& body, const Vec3& u);

// Forces on the body at the centre of buoyancy and at that of drag, N, space axes.
struct BodyWaterForce {
  Vec3 at_centre, at_drag;
};

// Residual (minus the forces) by the position of the centre of mass (space axes) and rotation (body axes), as
// in rigid_body(). `centre`, `drag`: water at both centres; surface and acceleration are taken at the centre
// of buoyancy, velocity at that of drag. convex: only the stabilising part of the derivatives by
// configuration.
struct BodyWaterResidual {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero(), C = Mat6::Zero(), M = Mat6::Zero();
};
BodyWaterForce body_water_force(const BodyInWater& body, const RigidBodyState& s, const Water& centre,
                                const Water& drag);
void body_water(const BodyInWater& body, const RigidBodyState& s, const Water& centre, const Water& drag,
                bool tangent, bool convex, BodyWaterResidual& out);

// Potential of buoyancy below a level surface, J.
double body_water_potential(const BodyInWater& body, const RigidBodyState& s, double surface);

}  // namespace hawser
