// Contact point of an accepted state, for any kind of contact, with history, energies and output.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Forces on the touching object, per unit of `weight`: N/m if the weight is a length of line, N if it is 1.
// In the axes of the touched object: of space or of a body.
struct ContactPoint {
  double weight = 1, gap = 0;                          // quadrature weight, - or m; gap, m
  Vec3 normal = Vec3::UnitZ();                         // outward from the touched object
  Vec3 force = Vec3::Zero(), friction = Vec3::Zero();  // total force; friction part
  double normal_force = 0, damping_force = 0;          // normal force; damping part
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
