// Facets stored near a point and along an axis: the same results as by a search, with few searches.
#include <gtest/gtest.h>

#include <limits>

#include "hawser/geometry/mesh_surface.hpp"
#include "support/rough_meshes.hpp"

namespace hawser::geometry_near_facets_test {
namespace {

using namespace hawser::test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Cached facets do not change results, bit for bit, for any distance to the next query, also beyond centres
// of curvature; for a small distance they avoid a search.
TEST(GeometryNearFacets, AskedAgainNearAPlace) {
  const auto part = [](std::size_t count) {
    std::vector<bool> active(count);
    for (std::size_t t = 0; t < count; t += 1 + t % 3) active[t] = true;
    return active;
  };
  for (const double noise : {0.0, 0.03, 0.08})
    for (const bool smooth : {false, true})
      for (const bool partial : {false, true}) {
        const TriangleMesh m = rough_mesh(noise);
        const MeshSurface surface(m, partial ? part(m.triangles.size()) : std::vector<bool>(), {smooth});
        Random random(6);
        int same = 0, kept = 0;
        for (int i = 0; i < 1000; ++i) {
          const Vec3 y = random(0.1, 1.4) * random.vec();
          const double within = i % 2 ? kInfinity : 0.3;
          NearFacets near;
          surface.query_again(y, within, -1, near);
          for (const double far : {0.0, 1e-6, 1e-3, 0.01, 0.1, 1.0}) {
            const Vec3 x = y + far * random.vec();
            const Vec3 before = near.place;
            const auto one = surface.query_again(x, within, -1, near);
            const auto other = surface.query(x, within);
            ASSERT_EQ(one.has_value(), other.has_value()) << x.transpose();
            if (!one) continue;
            ASSERT_EQ(one->triangle, other->triangle) << x.transpose();
            ASSERT_EQ(one->feature, other->feature);
            ASSERT_EQ(one->distance, other->distance);
            ASSERT_EQ(one->point, other->point);
            ASSERT_EQ(one->normal, other->normal);
            ASSERT_EQ(one->curvature, other->curvature);
            if (far == 1e-3) {
              ++same;
              kept += near.place == before;
            }
          }
        }
        printf("  %s facets, noise %.2f%s: a search in %d of %d\n", smooth ? "curved" : "flat", noise,
               partial ? ", part" : "", same - kept, same);
        EXPECT_GT(kept, 0.8 * same);
      }
}

// Lists of facets about several places of an axis suffice for all points near it, in any order.
TEST(GeometryNearFacets, ListsAlongAnAxis) {
  const TriangleMesh m = rough_mesh(0.03);
  const MeshSurface surface(m, {}, {true});
  Random random(9);
  NearFacetLists lists;
  int searches = 0;
  constexpr int kAll = 2000;
  for (int i = 0; i < kAll; ++i) {
    const Vec3 y = Vec3(0.2, random(-0.3, 0.3), 1.02) + 1e-3 * random.vec();
    NearFacets& near = lists.about(y);
    const Vec3 before = near.place;
    const auto one = surface.query_again(y, kInfinity, -1, near);
    const auto other = surface.query(y, kInfinity);
    ASSERT_TRUE(one && other);
    ASSERT_EQ(one->triangle, other->triangle);
    ASSERT_EQ(one->distance, other->distance);
    ASSERT_EQ(one->normal, other->normal);
    searches += near.place != before;
  }
  printf("  %d searches in %d queries\n", searches, kAll);
  EXPECT_LE(searches, kAll / 20);
}

}  // namespace
}  // namespace hawser::geometry_near_facets_test
