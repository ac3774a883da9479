// Water pressure on a closed triangulated surface fixed to a rigid body: exact buoyancy of the wetted part,
// and wave pressure from given heads. See docs/theory/hulls.md.
//
// With the pressure head s = level - z + h at the height z, where h is the dynamic head, linear on each
// triangle, the pressure is p = rho g s where s > 0, else 0. For a triangle with the area vector N and
// barycentric coordinates lambda, with J_ij the mean of lambda_i lambda_j over the triangle with zero where
// it is dry:
//   force -rho g N 1'J s,   moment -rho g sum_i (J s)_i y_i x N,   d(J s) = J ds
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hawser/kernels/rigid_body.hpp"

namespace hawser {

// Corners relative to the centre of mass, m, body axes; triangles anticlockwise as viewed from the water,
// with their outward area vectors, m².
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

// Residual (minus force and moment) by the position of the centre of mass (space axes) and rotation (body
// axes), as in rigid_body(); K: its derivative at fixed heads.
struct HullPressure {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero();
  // Potential of f without heads, J:
  //   rho g times the integral of (level - z) over the displaced volume = -rho g/2 sum N_z s'J s
  double potential = 0;
};

// weight_density: rho g, N/m³; level: z of the still water, m; heads: one per corner, m, or empty.
HullPressure hull_pressure(const HullSurface& hull, double weight_density, double level,
                           std::span<const double> heads, const RigidBodyState& s, bool tangent);

// Displaced volume [m³] below a level surface from the flux of x, of y and of z through the wetted surface;
// the three are equal if the surface is closed below the water.
Vec3 displaced_volumes(const HullSurface& hull, double level, const RigidBodyState& s);

}  // namespace hawser
