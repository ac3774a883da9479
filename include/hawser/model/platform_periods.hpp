// Periods of a platform by itself, from its hydrostatics and added mass.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// s, of one freedom each, without lines and coupling; 0: nothing pulls it back.
struct PlatformPeriods {
  double heave = 0, roll = 0, pitch = 0;
};
// Of a body with hydrodynamics: T = 2 pi sqrt((M + A(2 pi/T))/C).
PlatformPeriods platform_periods(const Case& c, const Body& b);

}  // namespace hawser::model
