// Is a point inside a closed triangle mesh? Three classical tests that can check one another; each looks
// at every triangle. (For many points near one mesh use MeshSurface.)
//
//   tetrahedra   signed volume of the tetrahedron of the point and each face; convex meshes only
//   ray          crossings of a ray along an axis; rays through vertices and edges are decided by exact
//                signs and a symbolic shift (Edelsbrunner & Mücke 1990, "Simulation of simplicity")
//   solid_angle  sum of the solid angles of the faces (van Oosterom & Strackee 1983, IEEE Trans. Biomed.
//                Eng. 30(2)): 4 pi inside, 0 outside
//
// Whatever they answer for a point of the surface itself is right.
#pragma once

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser {

// The mesh is closed and outward (MeshReport::valid), and for `tetrahedra` convex: not checked here.
bool inside_by_tetrahedra(const MeshView& mesh, const Vec3& p);
// Along +axis (0, 1, 2).
bool inside_by_ray(const MeshView& mesh, const Vec3& p, int axis = 0);
bool inside_by_solid_angle(const MeshView& mesh, const Vec3& p);

// Solid angle [rad²] of a triangle seen from p: positive when p sees its back (is inside); in [-2pi, 2pi].
double solid_angle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
// Sum over 4 pi: 1 inside, 0 outside of a closed outward mesh; in between for one with holes.
double winding_number(const MeshView& mesh, const Vec3& p);

// No vertex is above the plane of a face by more than `tolerance` [m] (where `tetrahedra` is valid).
// Looks along edges of a closed oriented manifold mesh of one piece.
bool is_convex(const TriangleMesh& mesh, double tolerance = 0);

}  // namespace hawser
