// A wide floating type, for what doubles are to be compared with.
#pragma once

#include <algorithm>
#include <cmath>

#include "hawser/math/types.hpp"

namespace hawser::detail {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Wide;  // 113 bits on x86-64
#else
using Wide = long double;
#endif

// Enough of a vector for either precision.
template <class T>
struct Triple {
  T x, y, z;
  Triple operator+(const Triple& o) const { return {x + o.x, y + o.y, z + o.z}; }
  Triple operator-(const Triple& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Triple operator*(T s) const { return {x * s, y * s, z * s}; }
  T dot(const Triple& o) const { return x * o.x + y * o.y + z * o.z; }
  Triple cross(const Triple& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
  Vec3 vec() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};

template <class T>
Triple<T> triple(const Vec3& v) {
  return {static_cast<T>(v.x()), static_cast<T>(v.y()), static_cast<T>(v.z())};
}

// What the distance to a triangle and the height over it may be wrong by, as a part of its size: rounding
// over the sine of its largest angle, below 1e-8 of which it counts as its edges.
inline double triangle_error(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Triple<Wide> e[3] = {triple<Wide>(b) - triple<Wide>(a), triple<Wide>(c) - triple<Wide>(b),
                             triple<Wide>(a) - triple<Wide>(c)};
  double sine = 1;
  for (int i = 0; i < 3; ++i) {
    const Vec3 u = e[i].vec(), v = e[(i + 1) % 3].vec(), n = e[i].cross(e[(i + 1) % 3]).vec();
    if (u.dot(v) > 0) sine = std::min(sine, n.stableNorm() / (u.stableNorm() * v.stableNorm()));
  }
  return 1e-14 + 1e-15 / std::max(sine, 1e-8);
}

}  // namespace hawser::detail
