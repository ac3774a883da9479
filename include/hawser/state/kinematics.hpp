// What a force term may look at: the trial (or committed) motion of this rank's nodes.
#pragma once

#include <span>

#include "hawser/math/types.hpp"

namespace hawser {

// Arrays run over the local nodes (owned first, then ghosts). Cable nodes carry identity rotations.
struct Kinematics {
  double time = 0;                 // s, of this state
  double step = 0;                 // s, length of the step that led here; 0 in statics
  std::span<const Vec3> x, v, a;   // m, m/s, m/s², space axes
  std::span<const Quat> q;         // rotation: node (material) axes to space axes
  std::span<const Vec3> w, alpha;  // rad/s, rad/s², material axes
};

}  // namespace hawser
