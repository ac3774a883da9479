// Angles given in degrees that are probably radians.
#pragma once

#include <cmath>

namespace hawser::model {

// True for multiples of 15 degrees in radians to 1e-3, up to a whole turn, such as 1.57 and 3.14.
inline bool is_in_radians(double angle) {
  constexpr double kStep = M_PI / 12, kRounded = 1e-3;
  const double size = std::abs(angle);
  const double steps = std::round(size / kStep);
  // 0.25 to 0.27 could be one step of 0.2618; with so few digits a small angle in degrees is more likely.
  return steps > 0 && size < 2 * M_PI * (1 + kRounded) && std::abs(size - steps * kStep) < kRounded * size;
}

}  // namespace hawser::model
