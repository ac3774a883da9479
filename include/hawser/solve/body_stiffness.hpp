// The stiffness of what is tied to a body against its displacements, by static condensation of the tangent.
// See docs/theory/frames.md.
#pragma once

#include "hawser/kernels/rigid_body.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// On the unknowns of the body's node, its centre of mass: force in axes of space and moment in axes of the
// body, as the residual (what must hold the body), and their derivative by increments of position and
// material rotation while all else keeps in balance.
struct BodyStiffness {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero();
};
// `held` ties all that is held, with the body; `free` the same without it. `at` is in balance with `held`,
// and no term of the system acts on the body by itself. body_node: of the mesh. Leaves the system tied by
// `held`. The same on all ranks; collective.
BodyStiffness body_stiffness(System& system, const Kinematics& at, int body_node,
                             const std::vector<TiedNode>& free, const std::vector<TiedNode>& held);

// The same about a point of the body, all in axes of space: minus force and moment on the body there, and the
// derivative by displacements of the point and small rotations of the body about axes of space; the moment is
// that about the moved point. r: m, the point from the centre of mass, axes of space; R: of the body.
BodyStiffness about_point(const BodyStiffness& s, const Vec3& r, const Mat3& R);

}  // namespace hawser
