// Vectors of three numbers of another type than double: of higher precision, or of several numbers at once
// (math/wide3.hpp).
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

template <class T>
struct Triple {
  T c[3];
  Triple operator+(const Triple& o) const { return {{c[0] + o.c[0], c[1] + o.c[1], c[2] + o.c[2]}}; }
  Triple operator-(const Triple& o) const { return {{c[0] - o.c[0], c[1] - o.c[1], c[2] - o.c[2]}}; }
  T dot(const Triple& o) const { return c[0] * o.c[0] + c[1] * o.c[1] + c[2] * o.c[2]; }
  Triple cross(const Triple& o) const {
    return {{c[1] * o.c[2] - c[2] * o.c[1], c[2] * o.c[0] - c[0] * o.c[2], c[0] * o.c[1] - c[1] * o.c[0]}};
  }
  Vec3 vec() const {
    return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
  }
  // s: T or double.
  template <class Scalar>
  friend Triple operator*(Scalar s, const Triple& a) {
    return {{s * a.c[0], s * a.c[1], s * a.c[2]}};
  }
  friend T dot(const Triple& a, const Triple& b) { return a.dot(b); }
};

template <class T>
Triple<T> triple(const Vec3& v) {
  return {{static_cast<T>(v.x()), static_cast<T>(v.y()), static_cast<T>(v.z())}};
}

}  // namespace hawser
