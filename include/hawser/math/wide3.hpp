// 3-vectors and 3x3 matrices in vector registers of four doubles, for the element kernels: a matrix is three
// rows, so a product is nine multiply-adds on full rows. The fourth lane is not used. GCC's vector extensions
// work on any target and use AVX if available.
#pragma once

#include <cmath>

#include "hawser/math/types.hpp"

namespace hawser::wide {

using Row = double __attribute__((vector_size(32)));
using Lanes4 = Row;  // one quantity of four elements, in place of a vector of one

inline Row load(const Vec3& v) { return Row{v[0], v[1], v[2], 0}; }
inline Row all(double s) { return Row{s, s, s, s}; }
inline Vec3 vec(Row r) { return {r[0], r[1], r[2]}; }
inline double dot(Row a, Row b) {
  const Row p = a * b;
  return p[0] + p[1] + p[2];
}
inline Row cross(Row a, Row b) {
  const auto next = [](Row r) -> Row { return __builtin_shufflevector(r, r, 1, 2, 0, 3); };
  return next(a * next(b) - next(a) * b);
}
// Square root of each lane.
[[gnu::always_inline]] inline Row sqrt(Row a) {
  Row r;
  for (int i = 0; i < 4; ++i) r[i] = std::sqrt(a[i]);
  return r;
}
[[gnu::always_inline]] inline Row abs(Row a) { return a < 0 ? -a : a; }
inline Row unit(int i) { return Row{i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0., 0}; }

struct Mat {
  Row r[3];
};

inline Mat operator+(const Mat& a, const Mat& b) {
  return {{a.r[0] + b.r[0], a.r[1] + b.r[1], a.r[2] + b.r[2]}};
}
inline Mat operator-(const Mat& a, const Mat& b) {
  return {{a.r[0] - b.r[0], a.r[1] - b.r[1], a.r[2] - b.r[2]}};
}
inline Mat operator-(const Mat& a) { return {{-a.r[0], -a.r[1], -a.r[2]}}; }
inline Mat operator*(double s, const Mat& a) { return {{s * a.r[0], s * a.r[1], s * a.r[2]}}; }
inline Mat& operator+=(Mat& a, const Mat& b) { return a = a + b; }
inline Mat& operator-=(Mat& a, const Mat& b) { return a = a - b; }

inline Mat operator*(const Mat& a, const Mat& b) {
  Mat c;
  for (int i = 0; i < 3; ++i) c.r[i] = a.r[i][0] * b.r[0] + a.r[i][1] * b.r[1] + a.r[i][2] * b.r[2];
  return c;
}
inline Mat transpose(const Mat& a) {
  Mat t;
  for (int i = 0; i < 3; ++i) t.r[i] = Row{a.r[0][i], a.r[1][i], a.r[2][i], 0};
  return t;
}
// a' b without forming a'.
inline Mat transposed_times(const Mat& a, const Mat& b) {
  Mat c;
  for (int i = 0; i < 3; ++i) c.r[i] = a.r[0][i] * b.r[0] + a.r[1][i] * b.r[1] + a.r[2][i] * b.r[2];
  return c;
}
// A v as a row, and v' A.
inline Row times(const Mat& a, Row v) { return Row{dot(a.r[0], v), dot(a.r[1], v), dot(a.r[2], v), 0}; }
inline Row left(Row v, const Mat& a) { return v[0] * a.r[0] + v[1] * a.r[1] + v[2] * a.r[2]; }

inline Mat identity(double s) { return {{s * unit(0), s * unit(1), s * unit(2)}}; }
inline Mat outer(Row a, Row b) { return {{a[0] * b, a[1] * b, a[2] * b}}; }
inline Mat hat(Row a) { return {{Row{0, -a[2], a[1], 0}, Row{a[2], 0, -a[0], 0}, Row{-a[1], a[0], 0, 0}}}; }
// hat(a) b and b hat(a).
inline Mat hat_times(Row a, const Mat& b) {
  return {{a[1] * b.r[2] - a[2] * b.r[1], a[2] * b.r[0] - a[0] * b.r[2], a[0] * b.r[1] - a[1] * b.r[0]}};
}
inline Mat times_hat(const Mat& b, Row a) { return {{cross(b.r[0], a), cross(b.r[1], a), cross(b.r[2], a)}}; }

inline Mat load(const Mat3& m) {
  return {{Row{m(0, 0), m(0, 1), m(0, 2), 0}, Row{m(1, 0), m(1, 1), m(1, 2), 0},
           Row{m(2, 0), m(2, 1), m(2, 2), 0}}};
}
// Stores m into a row-major matrix of `width` columns.
inline void store(const Mat& m, double* out, int width) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[i * width + j] = m.r[i][j];
}

// Stores m as block (i, j) of an element matrix.
template <int n>
inline void put(Eigen::Matrix<double, n, n, Eigen::RowMajor>& to, int i, int j, const Mat& m) {
  store(m, to.data() + 3 * n * i + 3 * j, n);
}

// Rotation matrix of a unit quaternion.
inline Mat rotation(const Quat& q) { return load(q.toRotationMatrix()); }

}  // namespace hawser::wide
