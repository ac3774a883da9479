// Contact data of an element of a line.
#pragma once

#include <array>

namespace hawser {

struct LineContactElement {
  double radius = 0;           // m, half the contact diameter; 0: the element takes no part
  double mass_per_length = 0;  // kg/m: the effective mass of relative_damping
  double damping_time = 0;     // s, of a beam: its damping over its stiffness; a cable bends without damping
  std::array<bool, 2> held{};  // whether each end is held by a support or a body
  bool rolling = false;        // for a beam: friction acts at the surface and turns the beam about its axis
};

}  // namespace hawser
