// Supports of a laid pipe: roller boxes along a ramp or a stinger. Their rollers are ordinary volumes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::model {

// One box of rollers, in the frame of its body.
struct SupportBox {
  std::string name;            // "<group> <number>"
  std::string key;             // in the case file, of messages: "supports.stinger.boxes[0]"
  std::string body;            // empty: fixed in space
  std::string line;            // that is laid over it
  Vec3 at = Vec3::Zero();      // m: where the axis of a line is that just touches the roller below it
  Vec3 along = Vec3::UnitX();  // unit, the way of the line from the tensioner on
  Vec3 up = Vec3::UnitZ();     // unit, across `along`: the side on which rollers hold the line
  double rise = 0;             // m, of `at` above the axis of the roller below (V: above where they meet)
  double half_width = 0;       // m, clear of the line's way to either side
  std::size_t first = 0;       // of its rollers among the volumes of the case
  std::vector<std::string> rollers;  // below, left, right, above: what each is

  Vec3 left() const { return up.cross(along); }
};

// Where the axis of a line goes through the plane across the path at a box, as the box sees it, m.
struct SupportCrossing {
  bool known = false;  // nothing of the line goes through it
  double offset = 0;   // to the left of the middle
  double height = 0;   // above where a line that just touches the roller below has its axis
  double arc = 0;      // unstretched, of the line from its end A
};

}  // namespace hawser::model
