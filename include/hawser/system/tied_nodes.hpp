// Nodes with given motion: fixed in space, carried by a body with prescribed motion, or tied to a frame of
// the state (a body with mass, a rigid joint), with or without rotation. A node tied to a frame has
//   x = X + R y,  v = V + R (w x y),  a = A + D y
// with the frame's position X, rotation R, rates w and accelerations D of the directors, the columns of the
// rotation matrix (docs/theory/frames.md).
#pragma once

#include <functional>
#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"

namespace hawser {

// A local node with prescribed components of its position and (material) rotation increments.
struct TiedNode {
  int node = 0;            // local
  int body = -1;           // with prescribed motion; -1: fixed in space
  int frame = -1;          // local node of the frame it is tied to; -1: prescribed
  Vec3 at = Vec3::Zero();  // m, in the body's frame (or space); for a frame, relative to its node in its axes
  Quat rotation = Quat::Identity();  // node axes in the body's frame (or space), when clamped
  unsigned char position_mask = 7;   // bits of the held components, space axes
  unsigned char rotation_mask = 0;   // bits of the held components, material axes; 7: follows the body
};

using BodyMotion = std::function<RigidPose(int body, double time)>;

class TiedNodes {
 public:
  TiedNodes() = default;
  TiedNodes(const LocalMesh& mesh, std::vector<TiedNode> nodes, BodyMotion motion);

  // Held components by local block, one bit for each component.
  const std::vector<unsigned char>& held() const { return held_; }
  const std::vector<TiedNode>& nodes() const { return nodes_; }
  const BodyMotion& motion() const { return motion_; }
  // Indices into nodes() of the nodes that are tied to a frame of the state.
  const std::vector<int>& to_frames() const { return to_frames_; }

  // Writes the prescribed entries of the local increment u that takes `from` to time t.
  void increments(const State& from, double t, double* u) const;
  // Sets prescribed velocities and accelerations at time t in the state.
  void rates(double t, State& s) const;
  // Sets positions, rotations and all rates of tied nodes from their frames.
  void move_with_frames(State& s) const;

 private:
  const LocalMesh* mesh_ = nullptr;
  std::vector<TiedNode> nodes_;
  BodyMotion motion_;
  std::vector<unsigned char> held_;
  std::vector<int> to_frames_;
};

}  // namespace hawser
