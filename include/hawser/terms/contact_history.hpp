// What an accepted step leaves at a place of contact.
#pragma once

#include "hawser/kernels/volume_contact.hpp"

namespace hawser {

// Body frame. Forces are N at a node, N/m along a line.
struct ContactHistory {
  Vec3 slip = Vec3::Zero(), normal = Vec3::UnitZ();    // m, -
  Vec3 force = Vec3::Zero(), friction = Vec3::Zero();  // N or N/m
  double normal_force = 0, damping_force = 0;          // N or N/m, of which damping
  double potential = 0;                                // J or J/m

  double elastic_force() const { return normal_force - damping_force; }

  // force, energy: their units.
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each, const char* force, const char* energy) {
    each("slip", "m", self.slip), each("normal", "", self.normal);
    each("force", force, self.force), each("friction force", force, self.friction);
    each("normal force", force, self.normal_force), each("damping force", force, self.damping_force);
    each("potential", energy, self.potential);
  }

  ContactHistory() = default;
  ContactHistory(const PointContact& c, const Vec3& n)
      : slip(c.slip),
        normal(n),
        force(c.force),
        friction(c.friction),
        normal_force(c.normal.force),
        damping_force(c.normal.force - c.normal.elastic),
        potential(c.normal.potential) {}
};

}  // namespace hawser
