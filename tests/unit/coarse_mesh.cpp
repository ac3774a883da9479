// Coarse meshes for display: number of vertices, volume and sharp edges of the original.
#include "hawser/geometry/coarse_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser {
namespace {

// A sphere of radius 3 m with 2 n² triangles.
struct Sphere {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  explicit Sphere(int n) {
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j < n; ++j) {
        const double up = M_PI * i / n;
        const double round = 2 * M_PI * j / n;
        vertices.emplace_back(3 * std::sin(up) * std::cos(round), 3 * std::sin(up) * std::sin(round),
                              3 * std::cos(up));
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int a = i * n + j;
        const int b = i * n + (j + 1) % n;
        triangles.push_back({a, a + n, b});
        triangles.push_back({b, a + n, b + n});
      }
  }
};

TEST(CoarseMesh, HasAsManyVerticesAsAskedForAndTheShape) {
  const Sphere s(200);
  const CoarseMesh m = coarse_mesh(s.vertices, s.triangles, 1000);
  EXPECT_LE(m.vertices.size(), 1000u);
  EXPECT_GT(m.vertices.size(), 600u);
  ASSERT_EQ(m.from.size(), m.triangles.size());
  double area = 0, volume = 0;
  for (const auto& [a, b, c] : m.triangles) {
    const Vec3& x = m.vertices.at(a);
    const Vec3& y = m.vertices.at(b);
    const Vec3& z = m.vertices.at(c);
    area += 0.5 * (y - x).cross(z - x).norm();
    volume += x.dot(y.cross(z)) / 6;
  }
  EXPECT_NEAR(area, 36 * M_PI, 0.05 * 36 * M_PI);
  EXPECT_NEAR(volume, 36 * M_PI, 0.03 * 36 * M_PI);  // orientation is preserved
  for (const Vec3& x : m.vertices) EXPECT_NEAR(x.norm(), 3, 0.05);
  for (size_t t = 0; t < m.from.size(); ++t) {
    const auto& [a, b, c] = s.triangles.at(m.from[t]);
    EXPECT_LT((m.vertices[m.triangles[t][0]] - s.vertices[a]).norm(), 0.6);
    EXPECT_LT((m.vertices[m.triangles[t][2]] - s.vertices[c]).norm(), 0.6);
  }
}

// At an edge of the body, the vertex of the coarse mesh is on all planes that meet there.
TEST(CoarseMesh, KeepsSharpEdges) {
  constexpr int n = 40;
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int face = 0; face < 6; ++face) {
    const int first = static_cast<int>(vertices.size());
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const double side = face < 3 ? 1 : -1;
        Vec3 x;
        x[face % 3] = side;
        x[(face + 1) % 3] = side * (2.0 * i / n - 1);
        x[(face + 2) % 3] = 2.0 * j / n - 1;
        vertices.push_back(x + Vec3(5, 0, 0));
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int a = first + i * (n + 1) + j;
        const int b = a + n + 1;
        triangles.push_back({a, b, a + 1});
        triangles.push_back({a + 1, b, b + 1});
      }
  }
  const CoarseMesh m = coarse_mesh(vertices, triangles, 500);
  EXPECT_GT(m.vertices.size(), 250u);
  double volume = 0;
  for (const auto& [a, b, c] : m.triangles)
    volume += m.vertices.at(a).dot(m.vertices.at(b).cross(m.vertices.at(c))) / 6;
  EXPECT_NEAR(volume, 8, 1e-9);
}

TEST(CoarseMesh, OfOnePlaceIsOneVertex) {
  const std::vector<Vec3> same(30, Vec3(1, 2, 3));
  const CoarseMesh m = coarse_mesh(same, {}, 20);
  ASSERT_EQ(m.vertices.size(), 1u);
  EXPECT_LT((m.vertices[0] - same[0]).norm(), 1e-12);
}

}  // namespace
}  // namespace hawser
