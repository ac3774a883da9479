// Water forces on one element of a line: buoyancy with partial wetting, Morison drag and added mass,
// Froude-Krylov force. See docs/theory/water.md.
//
// Along the element position, velocity and virtual displacement are those of its distributed loads: linear
// for a cable (two Gauss points), Hermite's cubic for a beam (three). The direction that splits normal from
// axial is the chord's. What the water does is given at the nodes and linear between. All per unstretched
// length. The formula is src/kernels/morison_formula.hpp. Cables that are wholly wet are
// computed four at once by morison_submerged.hpp.
#pragma once

#include "hawser/kernels/line_mass.hpp"

namespace hawser {

struct WaterSection {
  double length = 0;                         // m, unstretched
  double radius = 0;                         // m, of the displaced volume
  double buoyancy = 0;                       // N/m, rho g A
  double displaced_mass = 0;                 // kg/m, rho A
  double added_normal = 0, added_axial = 0;  // kg/m, rho Ca A
  double drag_normal = 0, drag_axial = 0;    // kg/m², rho Cd D/2 and rho Cd pi D/2
};

// The water at a node.
struct Water {
  Vec3 velocity = Vec3::Zero();      // m/s
  Vec3 by_height = Vec3::Zero();     // 1/s, derivative of the velocity by z
  Vec3 acceleration = Vec3::Zero();  // m/s²
  double surface = 0;                // m, z of the free surface above it
};

// Positions of the ends and motion as in MassEnds.
struct WaterEnds {
  Vec3 x1, x2;
  MassEnds motion;
  Water water1, water2;
};

// The same for a cable; references, nothing is copied.
struct CableInWater {
  const Vec3 &x1, &x2, &v1, &v2, &a1, &a2;
  const Water &water1, &water2;
};

// Residual (minus the water's force on the line) f on (x1, x2) or (x1, theta1, x2, theta2), moments in
// material axes; tangents by configuration, velocity and acceleration (directors as in beam_mass_tangent).
// convex: exclude negative stiffness from the tangent by configuration.
void cable_water_force(const WaterSection& s, const CableInWater& e, Vec6& f);
void cable_water_tangent(const WaterSection& s, const CableInWater& e, bool convex, Vec6& f, Mat6& K, Mat6& C,
                         Mat6& M);
void beam_water_force(const WaterSection& s, const WaterEnds& e, Vec12& f);
void beam_water_tangent(const WaterSection& s, const WaterEnds& e, bool convex, Vec12& f, Mat12& K, Mat12& C,
                        Mat12& M);

// Drag [N/m] of a fully wet line with the unit tangent t in water that flows past it with the velocity u
// [m/s].
Vec3 line_drag(const WaterSection& s, const Vec3& u, const Vec3& t);

// Potential of buoyancy, J (for a fully wet line: buoyancy times depth).
double water_potential(const WaterSection& s, const WaterEnds& e, bool beam);
// The other forces in the generalised coordinates (x1, L t1, x2, L t2) of a beam, (x1, x2) of a cable. Their
// sign is opposite to that of the residuals above.
struct WaterForce {
  Vec3 force[4];  // N: drag, Froude-Krylov and added mass, on the line
};
// Includes the change of buoyancy because the surface is not at `still_water_level` [m].
WaterForce flow_force_on_line(const WaterSection& s, const WaterEnds& e, bool beam, double still_water_level);
// Sum of these forces over a straight element that remains straight, without buoyancy, N.
Vec3 straight_flow_force(const WaterSection& s, const CableInWater& e, bool beam);

// Forces on a round buoy or clump weight at a node.
struct WaterBall {
  double buoyancy = 0, displaced_mass = 0, added_mass = 0;  // N, kg, kg
  double drag = 0;                                          // kg/m, rho Cd A/2
  double radius = 0;                                        // m
};
// Morison's equation for a sphere (Morison et al. 1950). Residual, N, of a ball at x [m] that moves with v
// [m/s] and a [m/s²], with the wet fraction phi of its volume and the relative velocity u = u_water - v:
//   f = phi (m_a (a - a_water) - m_d a_water - c |u| u - B e_z),
// and its derivatives K, C, M by x, v, a: all or none (null).
void ball_water(const WaterBall& b, const Vec3& x, const Vec3& v, const Vec3& a, const Water& water, Vec3& f,
                Mat3* K, Mat3* C, Mat3* M);
// Potential of its buoyancy, J.
double ball_potential(const WaterBall& b, const Vec3& x, const Water& water);

}  // namespace hawser
