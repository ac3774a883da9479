// Primitive shapes as plain data of a case file, body frame, m. primitives.hpp makes surfaces of them.
#pragma once

#include <variant>
#include <vector>

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
struct TubeShape {                  // wall of a pipe, open at both ends, with rounded rims
  std::vector<Vec3> path;           // of the axis, two points or more; bends round the corners off
  std::vector<double> bend_radius;  // of the axis at each corner, or one for all; above the outer radius
  double inner_radius = 1;          // > 0
  double wall_thickness = 0.1;      // > 0

  double outer_radius() const { return inner_radius + wall_thickness; }
  double middle_radius() const { return inner_radius + 0.5 * wall_thickness; }
};
using Primitive =
    std::variant<PlaneShape, BoxShape, SphereShape, CylinderShape, CapsuleShape, TorusShape, TubeShape>;

}  // namespace hawser
