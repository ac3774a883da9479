// Pressure of the water on a closed surface of triangles that is fixed to a rigid body: buoyancy on the
// wetted part, exactly, and the pressure of waves where heads are given. See docs/theory/hulls.md.
//
// With s = level - z + h the pressure head at a place of the height z, h the dynamic head, linear on each
// triangle, p = rho g s where s > 0 and none elsewhere. On a triangle of the area vector N and the
// barycentric coordinates lambda, with J_ij the mean of lambda_i lambda_j over the triangle where it is wet:
//   force -rho g N 1'J s,   moment -rho g sum_i (J s)_i y_i x N,   d(J s) = J ds
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

// Corners from the centre of mass, m, axes of the body; triangles anticlockwise seen from the water, with
// their area vectors, m², outwards.
struct HullSurface {
  std::vector<Vec3> corners;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vec3> areas;

  void add(const std::array<int, 3>& triangle) {
    const Vec3& a = corners[static_cast<std::size_t>(triangle[0])];
    const Vec3 ab = corners[static_cast<std::size_t>(triangle[1])] - a;
    const Vec3 ac = corners[static_cast<std::size_t>(triangle[2])] - a;
    triangles.push_back(triangle);
    areas.push_back(0.5 * ab.cross(ac));
  }
};

// The residual by the position of the centre of mass (space axes) and rotation (body axes) as in
// rigid_body(): minus the force and moment; K: its derivative at fixed heads.
struct HullPressure {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero();
  // J, of which f is the gradient where there are no heads:
  //   rho g times the integral of (level - z) over the displaced volume = -rho g/2 sum N_z s'J s
  double potential = 0;
};

// weight_density: rho g, N/m³; level: m, z of the still water; heads: m, one a corner, or none.
HullPressure hull_pressure(const HullSurface& hull, double weight_density, double level,
                           std::span<const double> heads, const RigidBodyState& s, bool tangent);

// The displaced water below a level surface by the flux of x, y and z through the wetted surface [m³]: equal
// where the surface is closed below the water.
Vec3 displaced_volumes(const HullSurface& hull, double level, const RigidBodyState& s);

}  // namespace hawser
