// Natural periods of a platform from hydrostatics and added mass.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// s, for each freedom separately, without lines and coupling; 0: no restoring stiffness.
struct PlatformPeriods {
  double heave = 0, roll = 0, pitch = 0;
};
// For a body with hydrodynamics: T = 2 pi sqrt((M + A(2 pi/T))/C).
PlatformPeriods platform_periods(const Case& c, const Body& b);

}  // namespace hawser::model
