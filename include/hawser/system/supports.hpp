// Prescribed motion of line ends: anchored in space or carried by a moving body, with or without rotation.
#pragma once

#include <functional>
#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"

namespace hawser {

// One support of a local node. Components of its position (and material rotation) increments are prescribed.
struct Support {
  int node = 0;                      // local
  int body = -1;                     // -1: fixed in space
  Vec3 at = Vec3::Zero();            // m, in the body's frame (or space)
  Quat rotation = Quat::Identity();  // node axes in the body's frame (or space), when clamped
  unsigned char position_mask = 7;   // bits of the held components, space axes
  unsigned char rotation_mask = 0;   // bits of the held components, material axes; 7: follows the body
};

using BodyMotion = std::function<RigidPose(int body, double time)>;

class Supports {
 public:
  Supports() = default;
  Supports(const LocalMesh& mesh, std::vector<Support> supports, BodyMotion motion);

  // Held components by local block, one bit a component.
  const std::vector<unsigned char>& held() const { return held_; }
  const std::vector<Support>& list() const { return supports_; }
  const BodyMotion& motion() const { return motion_; }

  // Writes the prescribed entries of the local increment u that take `from` to time t.
  void increments(const State& from, double t, double* u) const;
  // Puts prescribed velocities and accelerations of time t into the state.
  void rates(double t, State& s) const;

 private:
  RigidPose pose(const Support& s, double t) const;
  const LocalMesh* mesh_ = nullptr;
  std::vector<Support> supports_;
  BodyMotion motion_;
  std::vector<unsigned char> held_;
};

}  // namespace hawser
