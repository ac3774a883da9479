// Forces between two attached points or directions. Each is fixed to a node of a line, to a body (with
// prescribed motion, with mass, or riding on a line) or to space. An attached point is a FramePoint of the
// node of the frame to which it is fixed, a direction is the arm of a FramePoint.
#pragma once

#include "hawser/kernels/frame_point.hpp"
#include "hawser/kernels/rigid_body.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/assembler.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

struct Attached {
  int node = -1;                 // node of a line, index in the mesh; or
  int body = -1;                 // body of the case; both -1: fixed in space
  Vec3 position = Vec3::Zero();  // m, in the frame of the node or body, or in space axes
  bool direction = false;        // a direction, which rotates with the frame and has no position

  // Mesh node of the frame to which the point is fixed; -1: none, the motion is prescribed.
  int frame_node(const Bodies& bodies) const { return body < 0 ? node : bodies.frame(body); }
};

// Attached point or direction in a state: position, rate, and the unknowns that they depend on.
struct AttachedNow {
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, space axes
  int place = -1, turn = -1;                // local blocks of position and rotation; -1: no dependence
  FramePoint point;                         // relative to the node of the frame
};
// The frame_node() of `a` must be local to this rank.
AttachedNow attached_now(const Attached& a, const Kinematics& state, const LocalMesh& mesh,
                         const Bodies& bodies);

// Adds forces between two attached points to the unknowns of both. f = (f_a, f_b): residual; k, c: its
// derivatives by (x_a, x_b) and (v_a, v_b). Far from a solution (Assembler::convex) only the stabilising part
// of the derivative by the rotation of the arms is added. The two points must not be on the same node.
void add_pair_force(Assembler& assembler, const AttachedNow& a, const AttachedNow& b, const Vec6& f,
                    const Mat6& k, const Mat6& c);

}  // namespace hawser
