// Random numbers and points, and an irregular mesh.
#pragma once

#include <cmath>
#include <random>

#include "support/shapes.hpp"

namespace hawser::test {

class Random {
 public:
  explicit Random(unsigned seed) : gen_(seed) {}
  double operator()(double lo = -1, double hi = 1) {
    return std::uniform_real_distribution<double>(lo, hi)(gen_);
  }
  Vec3 vec() {
    const double x = (*this)();
    const double y = (*this)();
    return Vec3(x, y, (*this)());
  }
  std::size_t below(std::size_t n) { return gen_() % n; }

 private:
  std::mt19937 gen_;
};

// An irregular sphere with dents, bumps and displaced corners.
inline TriangleMesh rough_mesh(double noise, unsigned seed = 5) {
  TriangleMesh m = sphere_mesh(3);
  Random random(seed);
  for (Vec3& v : m.vertices)
    v = v * (1 + 0.15 * std::sin(3 * v.x()) * std::cos(4 * v.y())) + noise * random.vec();
  return m;
}

}  // namespace hawser::test
