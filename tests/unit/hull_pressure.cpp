// Water pressure on a hull: buoyancy and stiffness against closed forms, tangent with and without waves,
// potential, displaced volume by three fluxes, and volumes of shapes and split meshes.
#include "hawser/kernels/hull_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hawser/geometry/mesh_split.hpp"
#include "hawser/geometry/primitives.hpp"
#include "hawser/math/so3.hpp"
#include "support/difference.hpp"
#include "support/shapes.hpp"

namespace hawser::hull_pressure_test {
namespace {

using test::slope;

constexpr double kWeight = 10;  // N/m³

HullSurface surface(const TriangleMesh& mesh, const Vec3& centre) {
  HullSurface out;
  for (const Vec3& v : mesh.vertices) out.corners.push_back(v - centre);
  for (const auto& t : mesh.triangles) out.add(t);
  return out;
}

// A box of 8 x 5 x 3 m with an off-centre centre of mass.
HullSurface barge() { return surface(test::box_mesh({-4, -2.5, 0}, {4, 2.5, 3}), Vec3(0.3, -0.2, 0.8)); }

RigidBodyState state(const Vec3& turn, double z, const Vec6& by = Vec6::Zero()) {
  RigidBodyState s;
  s.x = Vec3(0.7, -0.4, z) + by.head<3>();
  s.q = exp_so3(turn) * exp_so3(by.tail<3>());
  return s;
}

// By Archimedes and the waterplane, about the centre of mass:
//   K33 = rho g A, K44 = rho g (I_x + V (z_B - z_G)), K35 = -rho g A x_A
TEST(HullPressure, UprightBoxInClosedForm) {
  const double draught = 1.3;
  const HullPressure p = hull_pressure(barge(), kWeight, 0, {}, state(Vec3::Zero(), 0.8 - draught), true);
  const double A = 8 * 5;
  const double V = A * draught;
  EXPECT_NEAR(p.f[2], -kWeight * V, 1e-11 * kWeight * V);
  EXPECT_NEAR(p.f[3], -kWeight * V * 0.2, 1e-10);
  EXPECT_NEAR(p.f[4], -kWeight * V * 0.3, 1e-10);
  EXPECT_LT(p.f.head<2>().norm() + std::abs(p.f[5]), 1e-10);
  const double arm = draught / 2 - 0.8;  // centre of buoyancy above that of mass
  EXPECT_NEAR(p.K(2, 2), kWeight * A, 1e-10 * kWeight * A);
  EXPECT_NEAR(p.K(3, 3), kWeight * (A * (25 / 12.0 + 0.04) + V * arm), 1e-9 * kWeight * A);
  EXPECT_NEAR(p.K(4, 4), kWeight * (A * (64 / 12.0 + 0.09) + V * arm), 1e-9 * kWeight * A);
  EXPECT_NEAR(p.K(2, 4), kWeight * A * 0.3, 1e-10 * kWeight * A);
  EXPECT_NEAR(p.potential, kWeight * A * draught * draught / 2, 1e-10 * kWeight * V);
}

// Floating at any tilt, with one corner submerged, fully submerged, dry.
TEST(HullPressure, IsTheGradientOfItsPotentialWithItsTangent) {
  const HullSurface hull = barge();
  struct At {
    Vec3 turn;
    double z;
  };
  using One = Eigen::Matrix<double, 1, 1>;
  for (const At& at : {At{{0.1, -0.2, 0.4}, -0.3}, At{{0.9, 0.5, -2}, 0.2}, At{{0.6, 0.7, 0.3}, 3.4},
                       At{{0.3, 0.1, 1}, -9}, At{{2.5, -0.3, 0}, 0.4}}) {
    const HullPressure p = hull_pressure(hull, kWeight, 0, {}, state(at.turn, at.z), true);
    for (int k = 0; k < 6; ++k) {
      const Vec6 d = Vec6::Unit(k);
      const auto potential = [&](const Vec6& u) {
        return One(hull_pressure(hull, kWeight, 0, {}, state(at.turn, at.z, u), false).potential);
      };
      const auto force = [&](const Vec6& u) {
        return hull_pressure(hull, kWeight, 0, {}, state(at.turn, at.z, u), false).f;
      };
      EXPECT_NEAR(p.f.dot(d), slope(potential, d)[0], 1e-6) << at.z << ", " << k;
      EXPECT_LT((p.K * d - slope(force, d)).norm(), 1e-5) << at.z << ", " << k;
    }
  }
  EXPECT_EQ(hull_pressure(hull, kWeight, 0, {}, state(Vec3::Zero(), 40), true).f.norm(), 0);
}

TEST(HullPressure, TangentInWaves) {
  const HullSurface hull = barge();
  std::vector<double> heads;
  for (size_t i = 0; i < hull.corners.size(); ++i)
    heads.push_back(0.6 * std::sin(3.0 * static_cast<double>(i)));
  const Vec3 turn(0.2, -0.3, 0.5);
  const HullPressure p = hull_pressure(hull, kWeight, 0.1, heads, state(turn, -0.4), true);
  for (int k = 0; k < 6; ++k) {
    const Vec6 d = Vec6::Unit(k);
    const auto force = [&](const Vec6& u) {
      return hull_pressure(hull, kWeight, 0.1, heads, state(turn, -0.4, u), false).f;
    };
    EXPECT_LT((p.K * d - slope(force, d)).norm(), 1e-5) << k;
  }
  // A uniform head equals a higher water level.
  heads.assign(heads.size(), 0.35);
  const Vec6 higher = hull_pressure(hull, kWeight, 0.45, {}, state(turn, -0.4), false).f;
  EXPECT_LT((hull_pressure(hull, kWeight, 0.1, heads, state(turn, -0.4), false).f - higher).norm(), 1e-10);
}

// A missing side changes the volume by the flux of one coordinate only.
TEST(HullPressure, VolumesAgreeWhereTheSurfaceIsClosed) {
  HullSurface hull = barge();
  const RigidBodyState s = state({0.2, -0.1, 0.7}, -0.4);
  const Vec3 closed = displaced_volumes(hull, 0, s);
  EXPECT_NEAR(closed.x(), closed.z(), 1e-11);
  EXPECT_NEAR(closed.y(), closed.z(), 1e-11);
  EXPECT_NEAR(closed.z(), -hull_pressure(hull, kWeight, 0, {}, s, false).f[2] / kWeight, 1e-11);
  hull.triangles.erase(hull.triangles.begin(), hull.triangles.begin() + 2);  // its bottom
  hull.areas.erase(hull.areas.begin(), hull.areas.begin() + 2);
  const Vec3 open = displaced_volumes(hull, 0, s);
  EXPECT_GT(open.maxCoeff() - open.minCoeff(), 10);
}

TEST(HullPressure, TrianglesOfShapesHaveTheirVolume) {
  constexpr double kWhole = std::numeric_limits<double>::max() / 1e300;
  const auto of = [](const Primitive& shape) {
    return displaced_volumes(surface(facets_of_volume(shape), Vec3::Zero()), kWhole, {});
  };
  const CylinderShape cylinder{{0, 0, -20}, {3, 0, 5}, 4};
  const CapsuleShape capsule{{0, 0, -20}, {3, 0, 5}, 4};
  const TorusShape torus{{1, 2, 3}, {0, 0, 1}, 6, 0.8};
  const double length = std::sqrt(9.0 + 625);
  EXPECT_NEAR(of(cylinder).x(), M_PI * 16 * length, 1e-8);
  EXPECT_NEAR(of(capsule).y(), M_PI * 16 * (length + 16 / 3.0), 1e-8);
  EXPECT_NEAR(of(torus).x(), 2 * M_PI * M_PI * 6 * 0.64, 1e-8);
  EXPECT_NEAR(of(SphereShape{{0, 0, 0}, 5}).y(), 4 * M_PI / 3 * 125, 1e-8);
  EXPECT_THROW(facets_of_volume(PlaneShape{}), std::invalid_argument);
}

// Splitting shortens the edges and keeps the surface closed.
TEST(HullPressure, SplitEdgesLeaveNoGaps) {
  TriangleMesh mesh = test::box_mesh({-40, -6, -9}, {40, 6, 3});
  split_edges(mesh, 4, 100000);
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) EXPECT_LE((mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm(), 4);
  const MeshReport report = inspect(mesh);
  EXPECT_TRUE(report.valid());
  EXPECT_NEAR(report.volume, 80 * 12 * 12, 1e-8);
  EXPECT_LT(mesh.triangles.size(), 4000u);
}

}  // namespace
}  // namespace hawser::hull_pressure_test
