// Forces on points of a body: tangents against differences, and moments of the arms.
#include "hawser/kernels/stencil.hpp"

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"

namespace hawser::stencil_test {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

const std::array<Vec3, 2> kArms{Vec3(0.4, -0.2, 0.3), Vec3(-0.1, 0.5, 0.2)};
const Mat3 kField = (Mat3() << 3, 1, -2, 0, 2, 1, 4, -1, 5).finished();
const Mat3 kDrag = (Mat3() << 1, 2, 0, -1, 3, 1, 0, 1, 2).finished();

// Two points of a body, each in an artificial force field: force = A sin(X) + B X', and a couple A cos(X_0)
// on the body.
Vec6 force(const Vec6& u, const Vec6& rate, BlockMatrix* K = nullptr, BlockMatrix* C = nullptr,
           bool turning = true) {
  const Vec3 x = Vec3(0.3, -0.2, 0.5) + u.head<3>();
  const Vec3 v = Vec3(0.4, 0.1, -0.3) + rate.head<3>();
  const Vec3 w = Vec3(0.5, -0.6, 0.8) + rate.tail<3>();
  const Mat3 R = (exp_so3(Vec3(0.7, -1.1, 0.9)) * exp_so3(u.tail<3>())).toRotationMatrix();
  AttachedForces g(2, true);
  Stencil s;
  s.blocks = 2;
  for (size_t i = 0; i < 2; ++i) {
    s.add({0, 1, {kArms[i], R, w}});
    const Vec3 X = x + R * kArms[i];
    g.F[i] = kField * X.array().sin().matrix() + kDrag * (v + R * w.cross(kArms[i]));
    block_of(g.K, i, i) = kField * X.array().cos().matrix().asDiagonal();
    block_of(g.C, i, i) = kDrag;
    if (i > 0) continue;
    g.F[AttachedForces::kPositions] = kField * X.array().cos().matrix();
    block_of(g.K, AttachedForces::kPositions, i) = -kField * X.array().sin().matrix().asDiagonal();
  }
  s.turns[0] = {-1, 1, {.R = R}};
  BlockVector f = BlockVector::Zero(6);
  if (K) {
    K->setZero(6, 6);
    C->setZero(6, 6);
  }
  s.to_blocks(g, turning, f, K, C);
  return f;
}

TEST(Stencil, TangentsAreDerivatives) {
  BlockMatrix K, C;
  const Vec6 zero = Vec6::Zero();
  force(zero, zero, &K, &C);
  const double h = 1e-5;
  for (int j = 0; j < 6; ++j) {
    const Vec6 d = h * Vec6::Unit(j);
    EXPECT_LT((K.col(j) - (force(d, zero) - force(-d, zero)) / (2 * h)).norm(), 1e-8 * K.norm()) << j;
    EXPECT_LT((C.col(j) - (force(zero, d) - force(zero, -d)) / (2 * h)).norm(), 1e-8 * C.norm()) << j;
  }
}

// The forces have moments about the origin of the body. Without rotation only the columns of rotations
// differ.
TEST(Stencil, MomentsAreThoseOfTheArms) {
  BlockMatrix K, without, C;
  const Vec6 zero = Vec6::Zero();
  const Vec6 f = force(zero, zero, &K, &C);
  EXPECT_EQ(f, force(zero, zero, &without, &C, false));
  EXPECT_EQ((K - without).leftCols<3>().norm(), 0);
  EXPECT_GT((K - without).norm(), 0.1 * K.norm());
  const Mat3 R = exp_so3(Vec3(0.7, -1.1, 0.9)).toRotationMatrix();
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  for (const Vec3& a : kArms) {
    const Vec3 X = Vec3(0.3, -0.2, 0.5) + R * a;
    const Vec3 v = Vec3(0.4, 0.1, -0.3) + R * Vec3(0.5, -0.6, 0.8).cross(a);
    const Vec3 p = kField * X.array().sin().matrix() + kDrag * v;
    sum += p;
    moment += (R * a).cross(p);
    if (&a == &kArms[0]) moment += kField * X.array().cos().matrix();
  }
  EXPECT_LT((f.head<3>() - sum).norm(), 1e-14 * f.norm());
  EXPECT_LT((f.tail<3>() - R.transpose() * moment).norm(), 1e-14 * f.norm());
}

}  // namespace
}  // namespace hawser::stencil_test
