// Random elements and numbers for tests of element axes and of pairs of lines.
#pragma once

#include <cmath>

#include "hawser/kernels/axis_shape.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::test::axis_elements {

inline double noise(int i, int purpose) {
  const double x = std::sin(12.9898 * (i + 1) + 78.233 * purpose) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}
inline Vec3 noise3(int i, int p) { return {noise(3 * i, p), noise(3 * i + 1, p), noise(3 * i + 2, p)}; }

// Element from a to b. The axis directions at its nodes differ from the chord by up to `bend`.
inline AxisEnds element(bool beam, const Vec3& a, const Vec3& b, int seed, double bend = 0.05) {
  AxisEnds e;
  e.beam = beam;
  e.length = 1.01 * (b - a).norm();
  e.x1 = a;
  e.x2 = b;
  e.v1 = noise3(seed, 1);
  e.v2 = noise3(seed, 2);
  if (!beam) return e;
  e.tangent = Vec3(0.8, 0.6, 0);
  const Quat along = minimal_rotation(e.tangent, b - a);
  e.q1 = exp_so3(bend * noise3(seed, 3)) * along;
  e.q2 = exp_so3(bend * noise3(seed, 4)) * along;
  e.w1 = noise3(seed, 5);
  e.w2 = noise3(seed, 6);
  return e;
}

}  // namespace hawser::test::axis_elements
