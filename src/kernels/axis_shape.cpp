// Shape functions of an element axis, cubic for beams and linear for cables, and the chain rule that takes
// forces along the axis and their tangents to nodal positions and rotations.
#include "hawser/kernels/axis_shape.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {

AxisShape::Generalised::Generalised() {
  F.fill(Vec3::Zero());
  for (auto& row : K) row.fill(Mat3::Zero());
  for (auto& row : C) row.fill(Mat3::Zero());
}

AxisShape::AxisShape(const AxisEnds& e) : count_(e.beam ? 4 : 2), length_(e.length), c_(e.tangent) {
  X_.fill(Vec3::Zero()), V_.fill(Vec3::Zero());
  if (!e.beam) {
    X_[0] = e.x1, X_[1] = e.x2, V_[0] = e.v1, V_[1] = e.v2;
    reach_ = (e.x2 - e.x1).norm();
    return;
  }
  q_ = {e.q1, e.q2};
  R_ = {e.q1.toRotationMatrix(), e.q2.toRotationMatrix()};
  w_ = {e.w1, e.w2};
  X_ = {e.x1, length_ * (R_[0] * c_), e.x2, length_ * (R_[1] * c_)};
  V_ = {e.v1, length_ * (R_[0] * e.w1.cross(c_)), e.v2, length_ * (R_[1] * e.w2.cross(c_))};
  // |H1'| <= 3/2 on the chord, |H2'|, |H4'| <= 1 at the ends and small where the other is large.
  reach_ = 1.5 * (e.x2 - e.x1).norm() + length_;
  const double straight = (X_[2] - X_[0]).norm();
  const double bend = std::max((X_[1] - (X_[2] - X_[0])).norm(), (X_[3] - (X_[2] - X_[0])).norm());
  // slope = chord + H2'(X1 - chord) + H4'(X3 - chord), and |H2'| + |H4'| <= 1
  reach_ = std::min(reach_, straight + bend);
}

AxisShape::Weights AxisShape::functions(double z) const {
  if (count_ == 2) return {1 - z, z, 0, 0};
  const double z2 = z * z, z3 = z2 * z;
  return {1 - 3 * z2 + 2 * z3, z - 2 * z2 + z3, 3 * z2 - 2 * z3, z3 - z2};
}

AxisShape::Weights AxisShape::derivatives(double z) const {
  if (count_ == 2) return {-1, 1, 0, 0};
  const double z2 = z * z;
  return {-6 * z + 6 * z2, 1 - 4 * z + 3 * z2, 6 * z - 6 * z2, 3 * z2 - 2 * z};
}

AxisShape::Weights AxisShape::second_derivatives(double z) const {
  if (count_ == 2) return {0, 0, 0, 0};
  return {-6 + 12 * z, -4 + 6 * z, 6 - 12 * z, 6 * z - 2};
}

// x - chord = H2 (X1 - chord) + H4 (X3 - chord), and |H2|, |H4| <= 4/27.
double AxisEnds::sagitta() const {
  if (!beam) return 0;
  const Vec3 chord = x2 - x1;
  return 4.0 / 27 * ((length * (q1 * tangent) - chord).norm() + (length * (q2 * tangent) - chord).norm());
}

Vec3 AxisShape::combine(const Weights& w, const std::array<Vec3, kMost>& v) const {
  Vec3 s = w[0] * v[0] + w[1] * v[1];
  if (count_ == 4) s += w[2] * v[2] + w[3] * v[3];
  return s;
}

std::array<Vec3, 4> AxisShape::bezier() const {
  if (count_ == 2) return {X_[0], (2 * X_[0] + X_[1]) / 3, (X_[0] + 2 * X_[1]) / 3, X_[1]};
  return {X_[0], X_[0] + X_[1] / 3, X_[2] - X_[3] / 3, X_[2]};
}

void AxisShape::to_nodes(const Generalised& g, double* f, double* K, double* C) const {
  const int m = 3 * count_;
  auto block = [m](double* to, int i, int j, const Mat3& b) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) to[(3 * i + r) * m + 3 * j + c] += b(r, c);
  };
  auto vector = [f](int i, const Vec3& v) {
    for (int r = 0; r < 3; ++r) f[3 * i + r] += v[r];
  };
  if (count_ == 2) {
    for (int i = 0; i < 2; ++i) {
      vector(i, g.F[static_cast<size_t>(i)]);
      if (!K) continue;
      for (int j = 0; j < 2; ++j) {
        block(K, i, j, g.K[static_cast<size_t>(i)][static_cast<size_t>(j)]);
        block(C, i, j, g.C[static_cast<size_t>(i)][static_cast<size_t>(j)]);
      }
    }
    return;
  }
  const Mat3 ch = hat(c_);
  std::array<Mat3, 2> E, D;  // d(L t)/dtheta (and dV/dw), dV/dtheta
  for (size_t k = 0; k < 2; ++k) {
    E[k] = -length_ * R_[k] * ch;
    D[k] = -length_ * R_[k] * hat(w_[k].cross(c_));
  }
  for (int i = 0; i < 4; ++i) {
    const size_t a = static_cast<size_t>(i), node = a / 2;
    const bool turn = i % 2;
    vector(i, turn ? Vec3(E[node].transpose() * g.F[a]) : g.F[a]);
    if (!K) continue;
    for (int j = 0; j < 4; ++j) {
      const size_t b = static_cast<size_t>(j), other = b / 2;
      Mat3 k = g.K[a][b], c = g.C[a][b];
      if (j % 2) {
        k = k * E[other] + c * D[other];
        c = c * E[other];
      }
      if (turn) k = E[node].transpose() * k, c = E[node].transpose() * c;
      // The moment arm turns with the node.
      if (turn && i == j) k += length_ * ch * hat(R_[node].transpose() * g.F[a]);
      block(K, i, j, k), block(C, i, j, c);
    }
  }
}

AxisShape::Rolling::Rolling() {
  for (auto* rows : {&by_X, &by_V})
    for (auto& row : *rows) row.fill(Vec3::Zero());
  for (auto& row : force_by_roll) row.fill(Vec3::Zero());
}

void AxisShape::to_nodes(const Rolling& g, const std::array<AxisRoll, 2>& ends, bool stiffening, double* f,
                         double* K, double* C) const {
  auto add = [](double* to, size_t i, size_t j, const Mat3& b) {
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 3; ++c)
        to[(3 * i + r) * 12 + 3 * j + c] += b(static_cast<int>(r), static_cast<int>(c));
  };
  for (size_t i = 0; i < 2; ++i) {
    const Vec3& axis = ends[i].by_turn;
    for (size_t r = 0; r < 3; ++r) f[3 * (2 * i + 1) + r] += g.T[i] * axis[static_cast<int>(r)];
  }
  if (!K) return;
  std::array<Mat3, 2> E, D;  // as above
  for (size_t k = 0; k < 2; ++k) {
    E[k] = -length_ * R_[k] * hat(c_);
    D[k] = -length_ * R_[k] * hat(w_[k].cross(c_));
  }
  for (size_t i = 0; i < 2; ++i) {
    const Vec3& axis = ends[i].by_turn;
    const size_t row = 2 * i + 1;
    for (size_t j = 0; j < 4; ++j) {
      Vec3 k = g.by_X[i][j], c = g.by_V[i][j];
      if (j % 2) {
        k = E[j / 2].transpose() * k + D[j / 2].transpose() * c;
        c = E[j / 2].transpose() * c;
      }
      add(K, row, j, axis * k.transpose());
      add(C, row, j, axis * c.transpose());
      const Vec3 force = j % 2 ? Vec3(E[j / 2].transpose() * g.force_by_roll[j][i]) : g.force_by_roll[j][i];
      add(K, j, row, force * axis.transpose());
    }
    for (size_t j = 0; j < 2; ++j)
      add(K, row, 2 * j + 1, g.by_roll[i][j] * axis * ends[j].by_turn.transpose());
    if (stiffening) add(K, row, row, g.T[i] * ends[i].by_turn_turn);
  }
}

}  // namespace hawser
