// How much of a round section, or of a ball, is under water.
#pragma once

#include <cmath>

namespace hawser {

// As functions of u = (height of the surface above the centre)/radius: the wet share, its derivative and its
// integral from -infinity, all continuous.
struct Wetting {
  double share = 0, slope = 0, integral = 0;
};

// Segment of a circle: share = 1/2 + (u sqrt(1 - u²) + asin u)/pi.
inline Wetting circle_wetting(double u) {
  if (u >= 1) return {1, 0, u};
  if (u <= -1) return {};
  const double c2 = 1 - u * u, c = std::sqrt(c2), a = std::asin(u);
  return {0.5 + (u * c + a) / M_PI, 2 * c / M_PI, 0.5 * u + (c - c * c2 / 3 + u * a) / M_PI};
}

// Cap of a ball: share = (2 + 3 u - u³)/4.
inline Wetting ball_wetting(double u) {
  if (u >= 1) return {1, 0, u};
  if (u <= -1) return {};
  const double u2 = u * u;
  return {0.25 * (2 + 3 * u - u * u2), 0.75 * (1 - u2), 0.5 * u + 0.375 * u2 - u2 * u2 / 16 + 0.1875};
}

}  // namespace hawser
