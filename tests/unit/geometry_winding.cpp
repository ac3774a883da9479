// Winding numbers of meshes with holes, their fast evaluation, repair of broken meshes, and the resulting
// sign of the distance.
#include <gtest/gtest.h>

#include <random>

#include "hawser/geometry/mesh_repair.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/point_in_polyhedron.hpp"
#include "hawser/geometry/winding_tree.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_winding_test {
namespace {

using namespace hawser::test;

class Points {
 public:
  Vec3 operator()(double size) {
    const double x = unit_(gen_);
    const double y = unit_(gen_);
    return size * Vec3(x, y, unit_(gen_));
  }
  std::size_t below(std::size_t n) { return gen_() % n; }

 private:
  std::mt19937 gen_{3};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TriangleMesh without(TriangleMesh m, const std::vector<std::size_t>& which) {
  std::vector<std::array<int, 3>> kept;
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    if (std::find(which.begin(), which.end(), t) == which.end()) kept.push_back(m.triangles[t]);
  m.triangles = kept;
  return m;
}

MeshSurfaceOptions open(bool smooth = false) { return {smooth, 40 * M_PI / 180, true}; }

TEST(GeometryWinding, FastIsNearExact) {
  const TriangleMesh m = without(sphere_mesh(4), {3, 77, 78, 500, 501, 502, 1900});
  const WindingTree tree(m);
  Points next;
  double worst[3] = {0, 0, 0};
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = next(1.2);
    const double exact = winding_number(m, p);
    const double accuracy[3] = {1.5, 3, 10};
    for (int k = 0; k < 3; ++k)
      worst[k] = std::max(worst[k], std::abs(tree.winding_number(m, p, accuracy[k]) - exact));
    ASSERT_NEAR(tree.winding_number(m, p, 1e9), exact, 1e-12);
    ASSERT_EQ(tree.inside(m, p), exact > 0.5);
  }
  EXPECT_LT(worst[0], 0.15);
  EXPECT_LT(worst[1], 0.05);
  EXPECT_LT(worst[2], 1.5e-3);
  EXPECT_GT(worst[1], worst[2]);
}

// The signs equal those of the winding number summed over all triangles.
void expect_signs(const TriangleMesh& m, int points, double size) {
  const MeshSurface s(m, {}, open());
  Points next;
  for (int i = 0; i < points; ++i) {
    Vec3 y = next(size);
    if (i % 2) {
      const auto& t = m.triangles[next.below(m.triangles.size())];
      y = (m.vertices[static_cast<std::size_t>(t[0])] + m.vertices[static_cast<std::size_t>(t[1])] +
           m.vertices[static_cast<std::size_t>(t[2])]) /
              3 +
          next(0.05);
    }
    const double w = winding_number(m, y);
    if (std::abs(w - 0.5) < 1e-9) continue;
    const auto q = s.query(y, 1e9);
    ASSERT_EQ(q->distance<0, w> 0.5) << y.transpose() << " w " << w;
    ASSERT_NEAR(q->normal.norm(), 1, 1e-12);
    // A small distance limit does not change results.
    const auto near = s.query(y, 0.02);
    ASSERT_EQ(near.has_value(), q->distance <= 0.02) << y.transpose();
  }
}

TEST(GeometryWinding, SignsOfMeshesWithHoles) {
  expect_signs(without(box_mesh(Vec3::Zero(), Vec3::Ones()), {2}), 4000, 1.5);     // half a side
  expect_signs(without(box_mesh(Vec3::Zero(), Vec3::Ones()), {2, 3}), 4000, 1.5);  // a whole one
  expect_signs(without(sphere_mesh(3), {0, 1, 2, 3, 100, 200, 300}), 4000, 1.2);
  expect_signs(without(flanged_drum_mesh(24, 1, 2, 1.5, 0.2), {10, 40, 41, 100}), 4000, 1.7);
}

TEST(GeometryWinding, PiecesThatOverlapAreOneBody) {
  TriangleMesh m = box_mesh(Vec3::Zero(), Vec3::Ones());
  append(m, box_mesh(Vec3(0.5, 0.3, 0.3), Vec3(1.5, 0.7, 0.7)));
  expect_signs(m, 4000, 2);
  TriangleMesh within = sphere_mesh(2);
  append(within, sphere_mesh(2, 0.5));
  const MeshSurface s(within, {}, open());
  EXPECT_EQ(s.internal_facets(), 128);
  EXPECT_LT(s.query({0.55, 0, 0}, 1)->distance, -0.35);  // distance to the outer sphere
}

TEST(GeometryWinding, RepairTurnsPatches) {
  TriangleMesh m = without(sphere_mesh(3), {5, 6, 300});
  const auto valid = m.triangles;
  Points next;
  int turned = 0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    if (next.below(5) == 0) {
      std::swap(m.triangles[t][0], m.triangles[t][1]);
      ++turned;
    }
  TriangleMesh inside_out = m;
  const RepairResult r = repair(m);
  EXPECT_EQ(r.turned, turned);
  EXPECT_GT(r.enclosing, 0.99);
  EXPECT_NEAR(winding_number(m, Vec3::Zero()), 1, 0.02);
  // Most of the triangles are reversed.
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  repair(inside_out);
  EXPECT_NEAR(winding_number(inside_out, Vec3::Zero()), 1, 0.02);
  EXPECT_EQ(m.triangles.size(), valid.size());
  // A sheet encloses no volume.
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(repair(sheet).enclosing, 0);
  // A cavity is oriented towards its void, a cube without a lid is oriented outward.
  TriangleMesh hollow = hollow_cube_mesh();
  hollow = without(hollow, {0});
  for (std::size_t t = 12; t < hollow.triangles.size(); ++t)
    std::swap(hollow.triangles[t][0], hollow.triangles[t][1]);
  repair(hollow);
  EXPECT_NEAR(winding_number(hollow, Vec3::Constant(1.5)), 0, 0.1);
  EXPECT_GT(winding_number(hollow, Vec3::Constant(0.5)), 0.7);
}

TEST(GeometryWinding, SmoothMeshesWithHoles) {
  const TriangleMesh m = without(sphere_mesh(3), {5, 6, 300});
  const MeshSurface s(m, {}, open(true));
  EXPECT_GT(s.curved(), 300);
  Points next;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 y = next(1.3);
    const double w = winding_number(m, y);
    const auto q = s.query(y, 1e9);
    if (std::abs(q->distance) < s.bulge() || std::abs(w - 0.5) < 1e-9) continue;
    ASSERT_EQ(q->distance<0, w> 0.5) << y.transpose() << " w " << w;
  }
}

}  // namespace

}  // namespace hawser::geometry_winding_test
