// Three classical tests whether a point is inside a closed triangle mesh, which can check one another; each
// visits every triangle. (For many points near one mesh use MeshSurface.)
//
//   tetrahedra   signed volume of the tetrahedron of the point and each face; convex meshes only
//   ray          crossings of a ray along an axis; rays through vertices and edges are decided by exact
//                signs and a symbolic shift (Edelsbrunner & Mücke 1990, "Simulation of simplicity")
//   solid_angle  sum of the solid angles of the faces (van Oosterom & Strackee 1983, IEEE Trans. Biomed.
//                Eng. 30(2)): 4 pi inside, 0 outside
//
// For a point on the surface either result is valid.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// The mesh must be closed and outward (MeshReport::valid), for `tetrahedra` also convex; not checked here.
bool inside_by_tetrahedra(const MeshView& mesh, const Vec3& p);
// Along +axis (0, 1, 2).
bool inside_by_ray(const MeshView& mesh, const Vec3& p, int axis = 0);
bool inside_by_solid_angle(const MeshView& mesh, const Vec3& p);

// Solid angle [rad²] of a triangle from p, in [-2pi, 2pi]: positive if p is behind it (inside).
double solid_angle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
// Sum of the solid angles over 4 pi: 1 inside and 0 outside a closed outward mesh, in between near holes.
double winding_number(const MeshView& mesh, const Vec3& p);

// True if no vertex is above the plane of a face by more than `tolerance` [m], so that `tetrahedra` is valid.
// Checks the edges of a closed oriented manifold mesh of one piece.
bool is_convex(const TriangleMesh& mesh, double tolerance = 0);

}  // namespace hawser
