// Primitive shapes as plain data of a case file, body frame, m. primitives.hpp makes surfaces of them.
#pragma once

#include <variant>

#include "hawser/math/types.hpp"

namespace hawser {

struct PlaneShape {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();  // outward, need not be unit, not zero
};
struct BoxShape {
  Vec3 centre = Vec3::Zero(), size = Vec3::Ones();  // full sides, > 0
  Vec3 rotation = Vec3::Zero();                     // rad, rotation vector of the box's axes
};
struct SphereShape {
  Vec3 centre = Vec3::Zero();
  double radius = 1;  // > 0
};
struct CylinderShape {  // closed by flat ends
  Vec3 from = Vec3::Zero(), to = Vec3::UnitZ();
  double radius = 1;  // > 0
};
struct CapsuleShape {  // all points within the radius of a segment; from = to is a sphere
  Vec3 from = Vec3::Zero(), to = Vec3::UnitZ();
  double radius = 1;  // > 0
};
struct TorusShape {
  Vec3 centre = Vec3::Zero(), axis = Vec3::UnitZ();  // need not be unit, not zero
  double radius = 1;                                 // of the circle in the middle of the tube
  double tube_radius = 0.1;                          // > 0, below the radius
};
using Primitive = std::variant<PlaneShape, BoxShape, SphereShape, CylinderShape, CapsuleShape, TorusShape>;

}  // namespace hawser
