// Numbers that do not depend on the number of ranks.
#pragma once

#include <cmath>

namespace hawser {

// x to 30 bits. A sum over ranks differs by rounding with how it is shared out; what is chosen by it (a mass,
// a shift, a step) would then differ as well, and with it the last digits of a solution. Rounded so coarsely
// it is the same, but for one such sum in a million.
inline double rank_independent(double x) {
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
  return std::isfinite(x) ? std::ldexp(std::nearbyint(std::ldexp(m, 30)), exponent - 30) : x;
}

}  // namespace hawser
