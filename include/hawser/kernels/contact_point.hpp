// What an accepted state leaves at a point of contact, of whatever with whatever: what is committed,
// accounted for, shown and saved.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Forces on the one that is said to touch, per unit of `weight`: N/m where that is a length of line, N where
// it is 1. Axes of what is touched: of space, or of a body.
struct ContactPoint {
  double weight = 1, gap = 0;                          // -, m: of the integral over all points; m
  Vec3 normal = Vec3::UnitZ();                         // out of what is touched
  Vec3 force = Vec3::Zero(), friction = Vec3::Zero();  // all of it; of which friction
  double normal_force = 0, damping_force = 0;          // of which damping
  double potential = 0;                                // J or J/m, of the spring

  double elastic_force() const { return normal_force - damping_force; }

  // force, energy: their units.
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each, const char* force, const char* energy) {
    each("normal", "", self.normal);
    each("force", force, self.force);
    each("friction force", force, self.friction);
    each("normal force", force, self.normal_force);
    each("damping force", force, self.damping_force);
    each("potential", energy, self.potential);
  }
};

}  // namespace hawser
