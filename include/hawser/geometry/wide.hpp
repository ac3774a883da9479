// Extended-precision floating type for triangles of nearly zero height, where double is not sufficient.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser::detail {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Wide;  // 113 bits on x86-64
#else
using Wide = long double;
#endif

// Minimal vector for either precision.
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

}  // namespace hawser::detail
