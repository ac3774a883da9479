// Natural periods of a platform from hydrostatics and added mass.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// s, floating without lines, each of the mode with its largest participation; 0: no stiffness.
struct PlatformPeriods {
  double heave = 0, roll = 0, pitch = 0;
};
// Natural periods of a body with hydrodynamics, without damping, lines and other bodies:
// (C - omega² (M + A(omega))) x = 0 in all six degrees of freedom.
PlatformPeriods platform_periods(const Case& c, const Body& b);

}  // namespace hawser::model
