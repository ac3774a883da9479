// Derivatives of functions by differences, to compare exact ones with.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser::test {

// Fourth-order difference of f, which takes the six increments of a rigid body, along d.
template <class F>
auto slope(F f, const Vec6& d) {
  const double e = 1e-3;
  return ((8 * (f(e * d) - f(-e * d)) - (f(2 * e * d) - f(-2 * e * d))) / (12 * e)).eval();
}

}  // namespace hawser::test
