// Points and directions fixed to a node, a body or space: their positions, and exact residual and tangent of
// forces between two of them (links, end springs). Ends of lines on bodies are in system/tied_nodes.hpp.
#include "hawser/terms/between_points.hpp"

#include <array>

#include "hawser/kernels/stencil.hpp"

namespace hawser {

AttachedNow attached_now(const Attached& a, const Kinematics& state, const LocalMesh& mesh,
                         const Bodies& bodies) {
  AttachedNow now;
  const int frame = a.frame_node(bodies);
  if (frame < 0) {
    const RigidPose p = bodies.pose(a.body, state.time);
    now.x = a.direction ? p.rotation * a.position : p.to_space(a.position);
    now.v = a.direction ? p.angular_velocity.cross(now.x) : p.velocity_at(now.x);
    return now;
  }
  const int local = mesh.find(frame);
  const Vec3 y = a.body < 0 ? a.position : bodies.in_node_axes(a.body, a.position, a.direction);
  now.point = {y, state.q[local].toRotationMatrix(), state.w[local]};
  now.x = now.point.arm();
  now.v = now.point.velocity();
  if (!y.isZero(0) && mesh.rotates(local)) now.turn = mesh.block[local] + 1;
  if (a.direction) return now;
  now.place = mesh.block[local];
  now.x += state.x[local];
  now.v += state.v[local];
  return now;
}

void add_pair_force(Assembler& assembler, const AttachedNow& a, const AttachedNow& b, const Vec6& f,
                    const Mat6& k, const Mat6& c) {
  std::array<int, 4> blocks{};
  Stencil stencil;
  const auto number = [&](int block) {
    if (block >= 0) blocks[stencil.blocks] = block;
    return block >= 0 ? stencil.blocks++ : -1;
  };
  for (const AttachedNow* side : {&a, &b}) {
    const int place = number(side->place);
    stencil.add({place, number(side->turn), side->point});
  }
  if (stencil.blocks == 0) return;
  const bool tangent = assembler.needs_tangent();
  AttachedForces g(2, false, tangent);
  for (const int i : {0, 1}) {
    g.F[i] = f.segment<3>(3 * i);
    if (!tangent) continue;
    for (const int j : {0, 1}) {
      block_of(g.K, i, j) = k.block<3, 3>(3 * i, 3 * j);
      block_of(g.C, i, j) = c.block<3, 3>(3 * i, 3 * j);
    }
  }
  const int m = 3 * stencil.blocks;
  BlockVector force = BlockVector::Zero(m);
  BlockMatrix K, C;
  if (tangent) {
    K.setZero(m, m);
    C.setZero(m, m);
  }
  stencil.to_blocks(g, !assembler.convex(), force, tangent ? &K : nullptr, tangent ? &C : nullptr);
  for (const size_t i : {0, 1})
    if (const AttachedPosition& p = stencil.attached[i]; tangent && assembler.convex() && p.rotation >= 0)
      K.block<3, 3>(3 * p.rotation, 3 * p.rotation) += p.point.convex_moment_by_turn(g.F[i]);
  assembler.add({blocks.data(), static_cast<size_t>(stencil.blocks)}, force, K, C);
}

}  // namespace hawser
