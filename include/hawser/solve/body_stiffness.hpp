// Stiffness of everything tied to a body against displacements of the body, by static condensation of the
// tangent. See docs/theory/frames.md.
#pragma once

#include "hawser/kernels/rigid_body.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// On the unknowns of the body's node, its centre of mass: residual (the force, in space axes, and the moment,
// in body axes, that must hold the body), and its derivative by increments of position and material rotation
// with everything else in equilibrium.
struct BodyStiffness {
  Vec6 f = Vec6::Zero();
  Mat6 K = Mat6::Zero();
};
// `held` ties all held nodes including the body; `free` the same without the body. `state` must be in
// equilibrium with `held`. Terms that act on the body directly contribute as well. body_node: mesh node.
// Leaves the system tied by `held`. The result is the same on all ranks; collective.
BodyStiffness body_stiffness(System& system, const Kinematics& state, int body_node,
                             const std::vector<TiedNode>& free, const std::vector<TiedNode>& held);

// The same about a point of the body, in space axes: minus force and moment on the body there, and the
// derivative by displacements of the point and small rotations of the body; the moment is that about the
// moved point. r: from the centre of mass to the point, m, space axes; R: rotation of the body.
BodyStiffness about_point(const BodyStiffness& s, const Vec3& r, const Mat3& R);

}  // namespace hawser
