// Springs and dampers between two points of a case.
#pragma once

#include <string>

#include "hawser/kernels/link.hpp"
#include "hawser/math/types.hpp"

namespace hawser::model {

// A point of a body, of a line (its nearest node) or of space.
struct LinkEnd {
  std::string body, line;  // one or none is set
  Vec3 at = Vec3::Zero();  // m, in the body's frame or in space
  double arc = 0;          // m, arc length from end A of the line
};

struct Link {
  std::string name;
  LinkEnd end_a, end_b;
  LinkLaw law;
  bool rest_given = false;  // else the rest length is the distance of the ends in the start shape
};

}  // namespace hawser::model
