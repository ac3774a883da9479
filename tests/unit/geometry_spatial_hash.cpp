// The nearest triangle of the hash is the nearest of all, on even and graded meshes, cold and warm.
#include <gtest/gtest.h>

#include <random>

#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/spatial_hash.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_spatial_hash_test {
namespace {

using namespace hawser::test;

double brute_force(const TriangleMesh& m, const Vec3& y) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& t : m.triangles) {
    const auto v = [&](std::size_t i) { return m.vertices[static_cast<std::size_t>(t[i])]; };
    best = std::min(best, closest_point_on_triangle(y, v(0), v(1), v(2)).squared_distance);
  }
  return best;
}

// A large box with small spheres beside and on it: sizes of triangles 1 : 1000.
TriangleMesh graded() {
  TriangleMesh m = box_mesh({-50, -10, -10}, {50, 10, 10});
  for (const Vec3& at : {Vec3(0, 0, 11), Vec3(49, 10, 10), Vec3(0, 0, -10)}) {
    TriangleMesh s = sphere_mesh(3, 0.5);
    for (Vec3& v : s.vertices) v += at;
    append(m, s);
  }
  append(m, tetrahedron_mesh());
  return m;
}

// Points about the vertices, from the size of the mesh down to `finest` of it.
void campaign(const TriangleMesh& m, int n, double finest = 1e-5) {
  const SpatialHash hash(m.vertices, m.triangles);
  EXPECT_EQ(hash.size(), m.triangles.size());
  std::mt19937 gen(2);
  std::uniform_real_distribution<double> u(-1, 1);
  std::uniform_int_distribution<std::size_t> any(0, m.vertices.size() - 1);
  const double size = hash.box().diagonal();
  std::vector<SpatialHash::Question> questions;
  std::vector<std::optional<SpatialHash::Nearest>> expected;
  for (int i = 0; i < n; ++i) {
    const Vec3 shift(u(gen), u(gen), u(gen));
    const Vec3 y = m.vertices[any(gen)] + size * std::pow(finest, std::abs(u(gen))) * shift;
    const double exact = brute_force(m, y);
    const SpatialHash::Nearest all = hash.nearest(y).value();
    ASSERT_NEAR(std::sqrt(all.squared_distance), std::sqrt(exact), 1e-13 * size) << y.transpose();
    // Whatever the hint and the limit: the same, to the last bit.
    const int hint = static_cast<int>(gen() % m.triangles.size());
    const SpatialHash::Nearest warm = hash.nearest(y, std::numeric_limits<double>::infinity(), hint).value();
    ASSERT_EQ(warm.triangle, all.triangle);
    ASSERT_EQ(warm.squared_distance, all.squared_distance);
    for (const double factor : {1.0 + 1e-9, 1.5, 4.0, 50.0}) {
      const auto near = hash.nearest(y, factor * std::sqrt(exact) + 1e-13 * size,
                                     i % 3 == 0   ? -1
                                     : i % 3 == 1 ? hint
                                                  : all.triangle);
      ASSERT_TRUE(near) << y.transpose() << " x " << factor;
      ASSERT_EQ(near->squared_distance, all.squared_distance) << y.transpose() << " x " << factor;
      ASSERT_EQ(near->triangle, all.triangle) << y.transpose() << " x " << factor;
    }
    for (const int any_hint : {-1, hint, all.triangle}) {
      questions.push_back({y, std::sqrt(exact) * (i % 2 ? 1.5 : 1e3) + 1e-13 * size, any_hint});
      expected.push_back(all);
    }
    const double less = (1 - 1e-9) * std::sqrt(exact) - 1e-13 * size;
    if (less > 0) {
      ASSERT_FALSE(hash.nearest(y, less));
      questions.push_back({y, less, hint});
      expected.push_back(std::nullopt);
    }
  }
  // All together: the same as one by one, to the last bit.
  std::vector<std::optional<SpatialHash::Nearest>> answers(questions.size());
  SpatialHash::Counters c;
  hash.nearest(questions, answers, &c);
  EXPECT_EQ(c.queries, static_cast<long>(questions.size()));
  for (std::size_t i = 0; i < answers.size(); ++i) {
    ASSERT_EQ(answers[i].has_value(), expected[i].has_value()) << i;
    if (!expected[i]) continue;
    ASSERT_EQ(answers[i]->triangle, expected[i]->triangle) << i << ": " << questions[i].point.transpose();
    ASSERT_EQ(answers[i]->squared_distance, expected[i]->squared_distance) << i;
  }
}

TEST(GeometrySpatialHash, Even) { campaign(sphere_mesh(4), 3000); }
TEST(GeometrySpatialHash, Graded) { campaign(graded(), 5000); }
TEST(GeometrySpatialHash, LongThinFacets) { campaign(drum_mesh(96, 0.3, 50), 3000); }
TEST(GeometrySpatialHash, TrianglesSmallerThanSinglePrecision) {
  // Boxes are kept in single precision: nothing may be lost where it ends.
  TriangleMesh m = box_mesh(Vec3::Constant(-50), Vec3::Constant(50));
  TriangleMesh s = sphere_mesh(3, 2e-5);
  for (Vec3& v : s.vertices) v += Vec3(33.3, 44.4, 50);
  append(m, s);
  campaign(m, 5000, 1e-8);
}
TEST(GeometrySpatialHash, FewTriangles) {
  campaign(tetrahedron_mesh(), 2000);
  campaign({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}}, 500);
}

TEST(GeometrySpatialHash, ManyTrianglesInOnePlaceAndNoSize) {
  // A hundred equal triangles and some points: more than a cell's list holds, and equal distances.
  TriangleMesh m = tetrahedron_mesh();
  for (int i = 0; i < 100; ++i) m.triangles.push_back(m.triangles[3]);
  for (int i = 0; i < 20; ++i) m.triangles.push_back({1, 1, 1});
  campaign(m, 500);
  campaign({{{1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}, {}, {}}, 1);
}

TEST(GeometrySpatialHash, FarApart) {
  // Small triangles with much room between them: most cells are empty, and the nearest is often only in a
  // cell beside that of the point, along one axis, two or three, below it or above.
  TriangleMesh m;
  std::mt19937 gen(6);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 1200; ++i) {
    const Vec3 at = 100 * Vec3(u(gen), u(gen), u(gen));
    const int v = static_cast<int>(m.vertices.size());
    for (int k = 0; k < 3; ++k) m.vertices.push_back(at + Vec3(u(gen), u(gen), u(gen)));
    m.triangles.push_back({v, v + 1, v + 2});
  }
  campaign(m, 3000, 1e-3);
  // By cells of the whole and halves and quarters of it, at whose faces others begin.
  const SpatialHash hash(m.vertices, m.triangles);
  const double side = hash.box().extent().maxCoeff();
  for (int i = 0; i < 3000; ++i) {
    Vec3 y = hash.box().lo;
    for (int a = 0; a < 3; ++a)
      y[a] += side * (static_cast<int>(gen() % 65) / 64.0 + 1e-3 * u(gen) * (i % 2));
    const double exact = std::sqrt(brute_force(m, y));
    for (const double factor : {1.0 + 1e-9, 1.2, 3.0})
      ASSERT_NEAR(std::sqrt(hash.nearest(y, factor * exact).value().squared_distance), exact, 1e-11)
          << y.transpose();
  }
}

TEST(GeometrySpatialHash, ManyOfEachSizeInOnePlace) {
  // On each level more triangles than a block of runs holds, in the cell that holds all finer ones: as deep
  // as a search gets.
  TriangleMesh m;
  std::mt19937 gen(7);
  std::uniform_real_distribution<double> u(0, 1);
  for (int level = 0; level < 20; ++level)
    for (int i = 0; i < 150; ++i) {
      const double size = std::ldexp(1.0, -level);
      const int v = static_cast<int>(m.vertices.size());
      for (int k = 0; k < 3; ++k) m.vertices.push_back(size * (Vec3(u(gen), u(gen), u(gen)) + Vec3::Unit(k)));
      m.triangles.push_back({v, v + 1, v + 2});
    }
  campaign(m, 2000, 1e-7);
}

TEST(GeometrySpatialHash, OnlyActiveTriangles) {
  const TriangleMesh m = sphere_mesh(3);
  std::vector<bool> active(m.triangles.size(), false);
  TriangleMesh some = m;
  some.triangles.clear();
  for (std::size_t t = 0; t < active.size(); t += 7) {
    active[t] = true;
    some.triangles.push_back(m.triangles[t]);
  }
  const SpatialHash hash(m.vertices, m.triangles, active);
  std::mt19937 gen(3);
  std::uniform_real_distribution<double> u(-2, 2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 y(u(gen), u(gen), u(gen));
    const SpatialHash::Nearest near = hash.nearest(y, 10, i % static_cast<int>(active.size())).value();
    ASSERT_TRUE(active[static_cast<std::size_t>(near.triangle)]);
    ASSERT_NEAR(near.squared_distance, brute_force(some, y), 1e-13);
  }
}

TEST(GeometrySpatialHash, EmptyAndStrangePoints) {
  EXPECT_FALSE(SpatialHash().nearest({0, 0, 0}));
  const TriangleMesh m = sphere_mesh(2);
  const SpatialHash hash(m.vertices, m.triangles);
  EXPECT_FALSE(hash.nearest({0, 0, 0}, -1));
  EXPECT_FALSE(hash.nearest(Vec3::Constant(std::nan(""))));
  EXPECT_TRUE(hash.nearest(Vec3::Constant(1e12)));
  EXPECT_FALSE(hash.nearest(Vec3::Constant(1e12), 5));

  const std::vector<SpatialHash::Question> strange = {{{0, 0, 0}, -1, 3},
                                                      {Vec3::Constant(std::nan("")), 1, 3},
                                                      {Vec3::Constant(1e12), 5, 3},
                                                      {Vec3(0, 0, 1.01), 1, 1 << 30},
                                                      {Vec3(0, 0, 1.01), std::nan(""), 0}};
  std::vector<std::optional<SpatialHash::Nearest>> answers(strange.size());
  hash.nearest(strange, answers);
  for (const std::size_t i : {0, 1, 2, 4}) EXPECT_FALSE(answers[i]) << i;
  EXPECT_EQ(answers[3].value().triangle, hash.nearest(Vec3(0, 0, 1.01)).value().triangle);
  SpatialHash().nearest(strange, answers);
  for (const auto& a : answers) EXPECT_FALSE(a);
  hash.nearest(std::span<const SpatialHash::Question>(), std::span<std::optional<SpatialHash::Nearest>>());
  answers.pop_back();
  EXPECT_THROW(hash.nearest(strange, answers), std::invalid_argument);
}

// Sizes of meshes and numbers for which single precision must not leave its range.
TEST(GeometrySpatialHash, VerySmallAndVeryLarge) {
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
    TriangleMesh m = graded();
    for (Vec3& v : m.vertices) v *= scale;
    campaign(m, 300);
  }
}

// So many to so large a mesh that they are answered in another order than asked.
TEST(GeometrySpatialHash, ManyAtOnce) {
  const TriangleMesh m = sphere_mesh(6, 10);
  const SpatialHash hash(m.vertices, m.triangles);
  std::mt19937 gen(5);
  std::normal_distribution<double> g;
  std::vector<SpatialHash::Question> questions;
  for (int i = 0; i < 9000; ++i) {
    const double d = i % 50 == 0 ? 30 : 0.3 * g(gen);
    const Vec3 y = (10 + d) * Vec3(g(gen), g(gen), g(gen)).normalized();
    const int hint = i % 7 == 0   ? -1
                     : i % 7 == 1 ? static_cast<int>(gen() % (m.triangles.size() + 100))
                                  : hash.nearest(y + 0.05 * Vec3(g(gen), g(gen), g(gen))).value().triangle;
    questions.push_back({y, i % 3 == 0 ? 0.1 : 0.5, hint});
  }
  std::vector<std::optional<SpatialHash::Nearest>> answers(questions.size());
  SpatialHash::Counters c;
  hash.nearest(questions, answers, &c);
  EXPECT_EQ(c.queries, static_cast<long>(questions.size()));
  int found = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const auto one = hash.nearest(questions[i].point, questions[i].max_distance);
    ASSERT_EQ(answers[i].has_value(), one.has_value()) << i;
    if (!one) continue;
    ++found;
    ASSERT_EQ(answers[i]->triangle, one->triangle) << i;
    ASSERT_EQ(answers[i]->squared_distance, one->squared_distance) << i;
  }
  EXPECT_GT(found, 3000);
  EXPECT_LT(found, 8900);
}

TEST(GeometrySpatialHash, WorkDoesNotGrowWithTheMesh) {
  // Tests per query a fixed fraction of a triangle above the surface; all together, with hints from nearby.
  const auto work = [](int levels, bool together) {
    const TriangleMesh m = sphere_mesh(levels, 10);
    const SpatialHash hash(m.vertices, m.triangles);
    std::mt19937 gen(4);
    std::normal_distribution<double> g;
    SpatialHash::Counters c;
    const double d = 3.0 * std::ldexp(1.0, -levels);
    std::vector<SpatialHash::Question> questions;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 y = (10 + d) * Vec3(g(gen), g(gen), g(gen)).normalized();
      const Vec3 before = y + 0.1 * d * Vec3(g(gen), g(gen), g(gen)).normalized();
      questions.push_back({y, 2 * d, hash.nearest(before).value().triangle});
      if (!together) hash.nearest(y, 2 * d, -1, &c);
    }
    std::vector<std::optional<SpatialHash::Nearest>> answers(questions.size());
    if (together) hash.nearest(questions, answers, &c);
    return static_cast<double>(c.triangles + c.cells + c.lookups) / static_cast<double>(c.queries);
  };
  for (const bool together : {false, true}) {
    const double small = work(4, together), large = work(7, together);  // 2048 and 131072 triangles
    EXPECT_LT(large, 1.3 * small) << together;
    EXPECT_LT(large, 60) << together;
  }
}

}  // namespace

}  // namespace hawser::geometry_spatial_hash_test
