// Axis of an element: force and tangents at the nodes against differences, and the bound of the slope.
#include "hawser/kernels/axis_shape.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hawser/math/so3.hpp"

namespace hawser::axis_shape_test {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

AxisEnds random_ends(unsigned seed) {
  std::mt19937 g(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  auto vec = [&] { return Vec3(u(g), u(g), u(g)); };
  AxisEnds e;
  e.length = 1.4;
  e.tangent = vec().normalized();
  e.q1 = exp_so3(2 * vec());
  e.q2 = e.q1 * exp_so3(0.5 * vec());
  e.x1 = vec();
  e.x2 = e.x1 + 1.3 * (e.q1 * e.tangent) + 0.3 * vec();
  e.v1 = vec();
  e.v2 = vec();
  e.w1 = vec();
  e.w2 = vec();
  return e;
}

// An artificial smooth force field on three points of the axis: force = A sin(x) + B v.
Vec12 force(const AxisEnds& e, BlockMatrix* K = nullptr, BlockMatrix* C = nullptr) {
  const Mat3 A = (Mat3() << 3, 1, -2, 0, 2, 1, 4, -1, 5).finished();
  const Mat3 B = (Mat3() << 1, 2, 0, -1, 3, 1, 0, 1, 2).finished();
  const AxisShape shape(e);
  AttachedForces g(shape.count());
  for (double z : {0.1, 0.55, 0.9}) {
    const auto H = shape.functions(z);
    const Vec3 x = shape.point(z);
    const Vec3 p = A * x.array().sin().matrix() + B * shape.velocity(z);
    const Mat3 k = A * x.array().cos().matrix().asDiagonal();
    for (size_t i = 0; i < 4; ++i) {
      g.F[i] += H[i] * p;
      for (size_t j = 0; j < 4; ++j) {
        block_of(g.K, i, j) += H[i] * H[j] * k;
        block_of(g.C, i, j) += H[i] * H[j] * B;
      }
    }
  }
  BlockVector f = BlockVector::Zero(12);
  if (K) {
    K->setZero(12, 12);
    C->setZero(12, 12);
  }
  Stencil stencil;
  shape.attach(stencil);
  stencil.to_blocks(g, true, f, K, C);
  return f;
}

}  // namespace

TEST(AxisShape, TangentsAtTheNodesAreDerivatives) {
  const AxisEnds e = random_ends(3);
  BlockMatrix K, C;
  Mat12 Kd, Cd;
  force(e, &K, &C);
  const double h = 1e-5;
  for (int j = 0; j < 12; ++j) {
    auto at = [&](double step, bool speed) {
      AxisEnds m = e;
      const Vec3 d = step * Vec3::Unit(j % 3);
      const bool second = j >= 6;
      const bool turn = j % 6 >= 3;
      if (speed)
        (turn ? (second ? m.w2 : m.w1) : (second ? m.v2 : m.v1)) += d;
      else if (turn)
        (second ? m.q2 : m.q1) = (second ? m.q2 : m.q1) * exp_so3(d);
      else
        (second ? m.x2 : m.x1) += d;
      return force(m);
    };
    Kd.col(j) = (at(h, false) - at(-h, false)) / (2 * h);
    Cd.col(j) = (at(h, true) - at(-h, true)) / (2 * h);
  }
  EXPECT_LT((K - Kd).norm(), 1e-8 * Kd.norm());
  EXPECT_LT((C - Cd).norm(), 1e-8 * Cd.norm());
}

TEST(AxisShape, ReachBoundsTheSlope) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    AxisEnds e = random_ends(seed);
    e.beam = seed % 3;
    const AxisShape shape(e);
    for (int i = 0; i <= 40; ++i) EXPECT_LE(shape.slope(i / 40.0).norm(), shape.slope_bound() * (1 + 1e-12));
  }
}

TEST(AxisShape, EndsAndSlopesAreTheNodes) {
  const AxisEnds e = random_ends(7);
  const AxisShape s(e);
  EXPECT_LT((s.point(0) - e.x1).norm() + (s.point(1) - e.x2).norm(), 1e-14);
  EXPECT_LT((s.slope(1) - e.length * (e.q2 * e.tangent)).norm(), 1e-14);
  EXPECT_LT((s.velocity(1) - e.v2).norm(), 1e-14);
}

}  // namespace hawser::axis_shape_test
