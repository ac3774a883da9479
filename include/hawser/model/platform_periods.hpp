// Natural periods of a platform from its stiffness and added mass.
#pragma once

#include <array>

#include "hawser/model/case.hpp"

namespace hawser::model {

// s, floating without lines, each of the mode with its largest participation; 0: no stiffness.
struct PlatformPeriods {
  double heave = 0, roll = 0, pitch = 0;
};
// Natural periods of a body with hydrodynamics, without damping, lines and other bodies:
// (C - omega² (M + A(omega))) x = 0 in all six degrees of freedom.
PlatformPeriods platform_periods(const Case& c, const Body& b);

struct PlatformMode {
  double period = 0;  // s; 0: none
  int freedom = 0;    // the one with the most kinetic energy of those that are not given to a longer period
};
// The six modes of a body with a stiffness of all that acts on it, about its centre of mass in body axes, in
// descending order: (K - omega² (M + A(omega))) x = 0 without damping, with A = 0 without hydrodynamics.
std::array<PlatformMode, 6> platform_modes(const Body& b, const Mat6& K);
// The same with its `stiffness_matrix` alone.
std::array<PlatformMode, 6> modes_on_stiffness_matrix(const Body& b);

}  // namespace hawser::model
