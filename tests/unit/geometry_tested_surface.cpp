// Meshes whose sign comes from a test of a point in a polyhedron: distances, normals and curvatures equal
// those of the mesh without the test.
#include <gtest/gtest.h>

#include <random>

#include "hawser/geometry/tested_surface.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_tested_surface_test {
namespace {

using namespace hawser::test;

// Compares points near the surface, deep inside and far away, with and without a distance limit.
void compare(const TriangleMesh& mesh, SignTest test) {
  const auto plain = std::make_shared<MeshSurface>(mesh);
  const TestedSurface tested(plain, test);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-0.3, 1.3);
  const Box box = plain->bounds();
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 y = box.lo + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.extent());
    for (const double limit : {0.05, 100.0}) {
      const auto a = plain->query(y, limit);
      const auto b = tested.query(y, limit);
      ASSERT_EQ(a.has_value(), b.has_value()) << y.transpose();
      if (!a) continue;
      inside += a->distance < 0;
      EXPECT_EQ(a->distance, b->distance) << y.transpose();
      EXPECT_EQ(a->normal, b->normal);
      EXPECT_EQ(a->curvature, b->curvature);
    }
  }
  EXPECT_GT(inside, 300);
}

TEST(TestedSurface, ConvexBodiesByAnyTest) {
  for (const SignTest test :
       {SignTest::tetrahedra, SignTest::ray, SignTest::solid_angle, SignTest::winding}) {
    compare(box_mesh(Vec3(-1, 0, 2), Vec3(3, 1, 4)), test);
    compare(drum_mesh(24, 1, 3), test);
  }
}

TEST(TestedSurface, BodiesThatAreNotConvex) {
  for (const SignTest test : {SignTest::ray, SignTest::solid_angle, SignTest::winding})
    for (const TriangleMesh& mesh : {l_prism_mesh(), u_channel_mesh(), hollow_cube_mesh()})
      compare(mesh, test);
}

// An arm of an L is behind the plane of one of its faces, so the tetrahedra test, which is not valid for such
// bodies, reports outside; the surface uses the chosen test.
TEST(TestedSurface, TheTestDecides) {
  const auto plain = std::make_shared<MeshSurface>(l_prism_mesh());
  const TestedSurface tested(plain, SignTest::tetrahedra);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  const Box box = plain->bounds();
  int other = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 y = box.lo + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.extent());
    const auto a = plain->query(y, 100);
    const auto b = tested.query(y, 100);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(std::abs(a->distance), std::abs(b->distance));
    if ((a->distance < 0) == (b->distance < 0)) continue;
    ++other;
    EXPECT_EQ(a->normal, Vec3(-b->normal));
  }
  EXPECT_GT(other, 100);
}

TEST(TestedSurface, CurvedFacetsAreRefused) {
  MeshSurfaceOptions smooth;
  smooth.smooth = true;
  EXPECT_THROW(TestedSurface(std::make_shared<MeshSurface>(sphere_mesh(2), std::vector<bool>{}, smooth),
                             SignTest::ray),
               std::invalid_argument);
}

}  // namespace

}  // namespace hawser::geometry_tested_surface_test
