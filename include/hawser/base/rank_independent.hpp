// Numbers that do not depend on the number of ranks.
#pragma once

#include <cmath>

namespace hawser {

// Rounds x to 30 bits. A sum over ranks differs by rounding with its distribution, and so would what is
// derived from it (a mass, a shift, a step) and the last digits of a solution. With this rounding the result
// is equal, except for about one in a million sums.
inline double rank_independent(double x) {
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
  return std::isfinite(x) ? std::ldexp(std::nearbyint(std::ldexp(m, 30)), exponent - 30) : x;
}

}  // namespace hawser
