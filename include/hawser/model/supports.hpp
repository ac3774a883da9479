// Supports of a laid pipe: roller boxes along a ramp or a stinger. The rollers are ordinary volumes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::model {

// One roller box, in the frame of its body.
struct SupportBox {
  std::string name;            // "<group> <number>"
  std::string key;             // key in the case file, for messages: "supports.stinger.boxes[0]"
  std::string body;            // empty: fixed in space
  std::string line;            // laid over this box
  Vec3 at = Vec3::Zero();      // m: axis of a line that just touches the roller below
  Vec3 along = Vec3::UnitX();  // unit, laying direction, away from the tensioner
  Vec3 up = Vec3::UnitZ();     // unit, normal to `along`, away from the supporting roller
  double rise =
      0;  // m, height of `at` above the axis of the roller below (V: above the intersection of the axes)
  double half_width = 0;             // m, clearance of the line on either side
  std::size_t first = 0;             // index of the first roller among the volumes of the case
  std::vector<std::string> rollers;  // position of each: below, left, right or above

  Vec3 left() const { return up.cross(along); }
};

// Position of a line's axis in the plane normal to the path at a box, in the frame of the box, m.
struct SupportCrossing {
  bool known = false;  // false: the line does not cross the plane
  double offset = 0;   // to the left of the centre
  double height = 0;   // above the axis position of a line that just touches the roller below
  double arc = 0;      // unstretched arc length from end A
};

}  // namespace hawser::model
