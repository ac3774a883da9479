// Which volumes of a case touch as bodies do, and with what stiffness.
#pragma once

#include <cstddef>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::model {

// Volume `a` leads: what stands out of it, by the basis of its stiffness, meets the surface of volume `b`.
struct BodyPair {
  std::size_t a = 0, b = 0;
  double stiffness = 0;  // N/m, N/m² or N/m³ by the basis of a
  double share = 1;      // of the force: 1/2 where b leads as well with its faces
  Friction friction;     // the same in all directions
  // Whether they may get into each other where nothing of a is: between its corners, edges or balls.
  bool hides = false;
};

// Pairs of volumes that take part in contact, on different bodies one of which has mass at least. Round
// volumes (sphere, capsule, torus) lead, then those with a stiffness per point, per length, per area; of
// equals both lead, but round ones, where either would say the same. The softer of two of one basis counts.
// A pair without any stiffness has stiffness 0. Friction has the lowest coefficient of both volumes, along
// and across lines, and the law of a otherwise.
std::vector<BodyPair> body_pairs(const Case& c);

// Whether friction acts in one of the pairs with a volume of this body.
bool has_friction_on_bodies(const Case& c, const std::string& body);

}  // namespace hawser::model
