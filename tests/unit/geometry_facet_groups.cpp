// Facet groups of one surface: their number, distance and direction against closed forms; a single group on
// convex, smooth or thin surfaces.
#include <gtest/gtest.h>

#include <random>

#include "hawser/geometry/mesh_surface.hpp"
#include "support/shapes.hpp"

namespace hawser::test::geometry_facet_groups_test {
namespace {

Vec3 random_in(const Box& b, std::mt19937& gen) {
  std::uniform_real_distribution<double> u(0, 1);
  return b.lo + b.extent().cwiseProduct(Vec3(u(gen), u(gen), u(gen)));
}

// Nearest point of each facet group within max_distance [m] of y, the nearest first, without groups whose
// facets face away from y. At most one point if the surface is convex or smooth.
std::vector<SurfacePoint> nearest_on_groups(const Surface& surface, const Vec3& y, double max_distance) {
  FacetGroups groups;
  if (!surface.one_facet_group({&y, 1}, max_distance)) surface.facet_groups({&y, 1}, max_distance, groups);
  std::vector<SurfacePoint> out;
  if (!groups.several()) {
    if (const auto p = surface.query(y, max_distance)) out.push_back(*p);
    return out;
  }
  for (const FacetGroup& w : groups.list)
    if (const auto p = surface.query_group(w, y, max_distance)) out.push_back(*p);
  std::stable_sort(out.begin(), out.end(),
                   [](const SurfacePoint& a, const SurfacePoint& b) { return a.distance < b.distance; });
  return out;
}

// The L of l_prism_mesh: the faces x = 1 and y = 1 meet in a reentrant edge at (1, 1).
TEST(FacetGroups, BothSidesOfACorner) {
  const MeshSurface s(l_prism_mesh());
  const auto near = nearest_on_groups(s, Vec3(1.2, 1.3, 0.5), 0.4);
  ASSERT_EQ(near.size(), 2u);
  EXPECT_DOUBLE_EQ(near[0].distance, 0.2);
  EXPECT_EQ(near[0].normal, Vec3::UnitX());
  EXPECT_NEAR(near[1].distance, 0.3, 1e-15);
  EXPECT_EQ(near[1].normal, Vec3::UnitY());
  EXPECT_EQ(nearest_on_groups(s, Vec3(1.2, 1.3, 0.5), 0.25).size(), 1u);
  // The point has the same distance from both faces.
  EXPECT_EQ(nearest_on_groups(s, Vec3(1.2, 1.2, 0.5), 0.25).size(), 2u);
  // Behind one face and in front of the other.
  const auto behind = nearest_on_groups(s, Vec3(0.99, 1.3, 0.5), 0.4);
  ASSERT_EQ(behind.size(), 2u);
  EXPECT_NEAR(behind[0].distance, -0.01, 1e-15);
  EXPECT_EQ(behind[0].normal, Vec3::UnitX());
  EXPECT_NEAR(behind[1].distance, std::hypot(0.3, 0.01), 1e-15);  // from a face that ends at the edge
  // Inside, behind both faces: only the nearest one.
  const auto inside = nearest_on_groups(s, Vec3(0.8, 0.5, 0.5), 0.4);
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_LT(inside[0].distance, 0);
}

// Faces that are connected around a convex edge are two groups: [0,3] x [0,2] without (1,2) x (1,2).
TEST(FacetGroups, ASlit) {
  const MeshSurface s(u_channel_mesh());
  const auto two = nearest_on_groups(s, Vec3(1.45, 1.9, 2), 0.7);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0].distance, 0.45, 1e-15);
  EXPECT_EQ(two[0].normal, Vec3::UnitX());
  EXPECT_NEAR(two[1].distance, 0.55, 1e-15);
  EXPECT_EQ(two[1].normal, Vec3(-Vec3::UnitX()));
  EXPECT_EQ(nearest_on_groups(s, Vec3(1.45, 1.6, 2), 0.7).size(), 3u);  // the bottom is the third
  EXPECT_EQ(nearest_on_groups(s, Vec3(1.45, 2.6, 2), 0.9).size(), 2u);  // the two ends
}

// At each of many points there is a single group, whose point equals that of query() bit for bit.
void expect_one(const Surface& s, double reach, const char* what) {
  std::mt19937 gen(7);
  const Box box = s.bounds().grown(reach);
  int near = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 y = random_in(box, gen);
    FacetGroups groups;
    s.facet_groups({&y, 1}, reach, groups);
    ASSERT_TRUE(groups.list.empty()) << what << " at " << y.transpose();
    const auto all = nearest_on_groups(s, y, reach);
    const auto one = s.query(y, reach);
    ASSERT_EQ(all.size(), one ? 1u : 0u);
    if (!one) continue;
    ++near;
    ASSERT_TRUE(all[0].distance == one->distance && all[0].normal == one->normal &&
                all[0].curvature == one->curvature && all[0].point == one->point);
  }
  EXPECT_GT(near, 1000) << what;
}

TEST(FacetGroups, OneOfWhatIsConvex) {
  expect_one(MeshSurface(box_mesh(Vec3::Zero(), Vec3(3, 2, 1))), 0.6, "box");
  expect_one(MeshSurface(box_mesh(Vec3::Zero(), Vec3(3, 2, 0.01))), 0.6, "thin box");
  expect_one(MeshSurface(sphere_mesh(3, 1)), 0.7, "sphere");
  MeshSurfaceOptions smooth;
  smooth.smooth = true;
  expect_one(MeshSurface(sphere_mesh(3, 1), {}, smooth), 0.7, "smooth sphere");
  expect_one(MeshSurface(drum_mesh(24, 1, 2, 4), {}, smooth), 0.7, "smooth drum");
}

// The inside of a tank with many sides is one group for spheres that fit into it.
TEST(FacetGroups, OneOfAHollowOfManySides) {
  const TriangleMesh tank = revolution_mesh({{0, -2}, {2, -2}, {2, 2}, {1, 2}, {1, -1}, {0, -1}}, 48);
  for (const bool curved : {false, true}) {
    MeshSurfaceOptions o;
    o.smooth = curved;
    const MeshSurface s(tank, {}, o);
    for (int i = 0; i < 1000; ++i) {
      const double a = 0.0137 * i;
      const double r = 1 - 0.05 - 0.0003 * i;
      const auto near = nearest_on_groups(s, Vec3(r * std::cos(a), r * std::sin(a), 0.5), 0.4);
      ASSERT_EQ(near.size(), 1u) << r << " " << a << curved;
    }
    // The bottom of the tank is another group.
    EXPECT_EQ(nearest_on_groups(s, Vec3(0.8, 0.05, -0.8), 0.3).size(), 2u);
  }
}

// A deck with a thin bulwark: the far side of the bulwark is not a facet group.
TEST(FacetGroups, BacksAreNoFacetGroups) {
  TriangleMesh m = prism_mesh({{0, 0}, {4, 0}, {5, 0}, {5, 1}, {4.02, 1}, {4.02, 2}, {4, 2}, {4, 1}, {0, 1}},
                              {{0, 1, 7, 8}, {1, 2, 3, 4, 7}, {7, 4, 5, 6}}, 3);
  const MeshSurface s(m);
  std::mt19937 gen(3);
  const double reach = 0.3;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 y = random_in({{3, 1, 0.5}, {4, 2.5, 2.5}}, gen);
    const auto near = nearest_on_groups(s, y, reach);
    for (const SurfacePoint& p : near) {
      ASSERT_GT(p.distance, 0);
      ASSERT_GT(p.normal.dot(near[0].normal), -1e-9) << y.transpose();
      ASSERT_LT(p.normal.x(), 1e-9);
    }
    const double floor = y.y() - 1;
    const double wall = 4 - y.x();
    if (y.y() < 2) {
      ASSERT_EQ(near.size(), static_cast<size_t>((floor < reach) + (wall < reach))) << y.transpose();
    }
  }
}

// A rounded corner is one group for spheres that fit into it, and two for larger spheres.
TEST(FacetGroups, ARoundedCorner) {
  constexpr double kFillet = 0.1;
  std::vector<std::pair<double, double>> p{{-1, -1}, {2, -1}, {2, 0}, {kFillet, 0}};
  for (int i = 1; i < 9; ++i) {
    const double a = 0.5 * M_PI * i / 9;
    p.emplace_back(kFillet * (1 - std::sin(a)), kFillet * (1 - std::cos(a)));
  }
  p.emplace_back(0, kFillet);
  p.emplace_back(0, 2);
  p.emplace_back(-1, 2);
  const int n = static_cast<int>(p.size());
  std::vector<std::vector<int>> pieces;
  for (int i = 1; i + 1 < n; ++i) pieces.push_back({0, i, i + 1});
  MeshSurfaceOptions o;
  o.smooth = true;
  const MeshSurface s(prism_mesh(p, pieces, 3), {}, o);
  EXPECT_EQ(nearest_on_groups(s, Vec3(0.21, 0.22, 1.5), 0.23).size(), 2u);
  EXPECT_EQ(nearest_on_groups(s, Vec3(0.06, 0.07, 1.5), 0.08).size(), 1u);
}

// If there is one group for a sphere, there is one for all spheres inside it.
TEST(FacetGroups, OneInALargeBallIsOneInSmallOnes) {
  std::mt19937 gen(11);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const TriangleMesh& m : {u_channel_mesh(), l_prism_mesh(), flanged_drum_mesh(24, 1, 2, 1.5, 0.1)}) {
    const MeshSurface s(m);
    int one = 0, several = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 y = random_in(s.bounds().grown(0.3), gen);
      const bool alone = s.one_facet_group({&y, 1}, 0.5);
      const Vec3 x = y + 0.25 * Vec3(u(gen), u(gen), u(gen)).normalized();
      FacetGroups groups;
      s.facet_groups({&x, 1}, 0.25, groups);
      (groups.several() ? several : one) += 1;
      ASSERT_FALSE(alone && groups.several()) << y.transpose();
    }
    EXPECT_GT(one, 100);
    EXPECT_GT(several, 20);
  }
}

}  // namespace
}  // namespace hawser::test::geometry_facet_groups_test
