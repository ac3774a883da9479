// How much of a round section, of a ball, or of a body of some height is under water.
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

// A body that gets wet evenly over its height: share = (1 + u)/2, u in half heights, with parabolas where it
// begins and ends, so that it is continuous with its slope. Exact in between.
inline Wetting even_wetting(double u) {
  constexpr double d = 0.1;  // of the half height, on either side of both ends
  if (u >= 1 + d) return {1, 0, u};
  if (u <= -1 - d) return {};
  if (u > 1 - d) {
    const double s = 1 + d - u;
    return {1 - s * s / (8 * d), s / (4 * d), u + s * s * s / (24 * d)};
  }
  if (u < d - 1) {
    const double s = 1 + d + u;
    return {s * s / (8 * d), s / (4 * d), s * s * s / (24 * d)};
  }
  return {0.5 * (1 + u), 0.5, 0.25 * (1 + u) * (1 + u) + d * d / 12};
}

}  // namespace hawser
