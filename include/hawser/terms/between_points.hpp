// Points and directions that are fixed to something, and what acts between two of them: a node of a line, a
// body (with prescribed motion, with mass, or riding on a line) or space. A point of the node that carries it
// is a FramePoint; a direction is the arm of one.
#pragma once

#include "hawser/kernels/frame_point.hpp"
#include "hawser/kernels/rigid_body.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/assembler.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

struct Attached {
  int node = -1;           // of the mesh, of a line; or
  int body = -1;           // of the case; neither: of space
  Vec3 at = Vec3::Zero();  // m, in the frame of the body or node, or in space
  bool direction = false;  // turns with it and has no place

  // The mesh node that carries it; -1: its motion is prescribed.
  int carrier(const Bodies& bodies) const { return body < 0 ? node : bodies.frame(body); }
};

// One of them in a state: what it is, its rate, and the unknowns that it depends on.
struct AttachedNow {
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, space axes
  int place = -1, turn = -1;                // local blocks; -1: it does not depend on that
  FramePoint point;                         // of the node
};
// The node that carries it must be one of this rank's.
AttachedNow attached_now(const Attached& a, const Kinematics& at, const LocalMesh& mesh,
                         const Bodies& bodies);

// Adds what acts between two, on the unknowns of both: f = (f_a, f_b) residual; k and c: its derivatives by
// (x_a, x_b) and (v_a, v_b). Far from a solution (Assembler::convex) of the turning of arms only what holds
// them. Both on one node must not be.
void add_between(Assembler& assembler, const AttachedNow& a, const AttachedNow& b, const Vec6& f,
                 const Mat6& k, const Mat6& c);

}  // namespace hawser
