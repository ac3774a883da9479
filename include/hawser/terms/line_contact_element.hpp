// The data of an element of a line that contact needs.
#pragma once

#include <array>

namespace hawser {

struct LineContactElement {
  double radius = 0;           // m, half the contact diameter; 0: the element takes no part
  double mass_per_length = 0;  // kg/m: the effective mass of relative_damping
  std::array<bool, 2> held{};  // its ends: by a support or a body
  bool rolling = false;        // of a beam: friction acts at the line's surface and turns it about its axis
};

}  // namespace hawser
