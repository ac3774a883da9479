// Finite differences of functions, for comparison with exact derivatives.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser::test {

// Fourth-order difference of f along d. f takes the six increments of a rigid body.
template <class F>
auto slope(F f, const Vec6& d) {
  const double e = 1e-3;
  return ((8 * (f(e * d) - f(-e * d)) - (f(2 * e * d) - f(-2 * e * d))) / (12 * e)).eval();
}

}  // namespace hawser::test
