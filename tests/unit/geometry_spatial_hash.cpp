// Nearest triangle by spatial hash and by box tree, on even and graded meshes, with and without a hint: both
// equal the exhaustive search.
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <random>

#include "hawser/geometry/box_tree.hpp"
#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/spatial_hash.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_spatial_hash_test {
namespace {

using namespace hawser::test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double squared_distance_to(const TriangleMesh& m, int triangle, const Vec3& y) {
  const auto& t = m.triangles[static_cast<std::size_t>(triangle)];
  const auto v = [&](std::size_t i) { return m.vertices[static_cast<std::size_t>(t[i])]; };
  return closest_point_on_triangle(y, v(0), v(1), v(2)).squared_distance;
}

double brute_force(const TriangleMesh& m, const Vec3& y) {
  double best = kInfinity;
  for (int t = 0; t < static_cast<int>(m.triangles.size()); ++t)
    best = std::min(best, squared_distance_to(m, t, y));
  return best;
}

std::vector<Box> boxes_of(const TriangleMesh& m) {
  std::vector<Box> boxes(m.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (const int v : m.triangles[t]) boxes[t].add(m.vertices[static_cast<std::size_t>(v)]);
  return boxes;
}

struct Nearest {
  int triangle = -1;
  double squared_distance = 0;  // m²
};

// Nearest triangle by a SpatialHash or a BoxTree; the first of several that are equally near.
template <class Structure>
class Search {
 public:
  explicit Search(const TriangleMesh& mesh, const std::vector<bool>& active = {})
      : structure(boxes_of(mesh), active), mesh_(mesh) {}
  std::optional<Nearest> nearest(const Vec3& y, double max_distance = kInfinity, int hint = -1) const {
    Nearest best{-1, max_distance * max_distance};
    const auto visit = [&](int t) {
      ++visits;
      const double squared = squared_distance_to(mesh_, t, y);
      if (squared < best.squared_distance ||
          (squared == best.squared_distance && (best.triangle < 0 || t < best.triangle)))
        best = {t, squared};
    };
    if (hint >= 0) visit(hint);
    structure.nearest(y, best.squared_distance, visit);
    return best.triangle < 0 ? std::nullopt : std::optional(best);
  }
  Structure structure;
  mutable long visits = 0;

 private:
  const TriangleMesh& mesh_;
};

Box box_of(const TriangleMesh& m) {
  Box b;
  for (const Box& own : boxes_of(m)) b.add(own);
  return b;
}

// A large box with small spheres beside and on it: triangle sizes 1 : 1000.
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

// Compares the searches at points around the vertices, at distances from the size of the mesh down to
// `finest` of it: a tenth of the n points, all with HAWSER_FULL.
void campaign(const TriangleMesh& m, int n, double finest = 1e-5) {
  if (!std::getenv("HAWSER_FULL")) n = (n + 9) / 10;
  const Search<SpatialHash> hash(m);
  const Search<BoxTree> tree(m);
  std::mt19937 gen(2);
  std::uniform_real_distribution<double> u(-1, 1);
  std::uniform_int_distribution<std::size_t> any(0, m.vertices.size() - 1);
  const double size = box_of(m).diagonal();
  for (int i = 0; i < n; ++i) {
    const Vec3 shift(u(gen), u(gen), u(gen));
    const Vec3 y = m.vertices[any(gen)] + size * std::pow(finest, std::abs(u(gen))) * shift;
    const double exact = brute_force(m, y);
    const Nearest all = hash.nearest(y).value();
    ASSERT_EQ(all.squared_distance, exact) << y.transpose();
    // Bitwise equal for any hint and limit, by both structures.
    const int hint = static_cast<int>(gen() % m.triangles.size());
    const auto expect = [&](const std::optional<Nearest>& near, double factor) {
      ASSERT_TRUE(near) << y.transpose() << " x " << factor;
      ASSERT_EQ(near->squared_distance, all.squared_distance) << y.transpose() << " x " << factor;
      ASSERT_EQ(near->triangle, all.triangle) << y.transpose() << " x " << factor;
    };
    for (const double factor : {1.0 + 1e-9, 1.5, 4.0, 50.0, kInfinity})
      for (const int known : {-1, hint, all.triangle}) {
        const double within = std::isinf(factor) ? kInfinity : factor * std::sqrt(exact) + 1e-13 * size;
        expect(hash.nearest(y, within, known), factor);
        expect(tree.nearest(y, within, known), factor);
      }
    const double less = (1 - 1e-9) * std::sqrt(exact) - 1e-13 * size;
    if (less > 0) {
      ASSERT_FALSE(hash.nearest(y, less));
      ASSERT_FALSE(tree.nearest(y, less));
    }
  }
}

TEST(GeometrySpatialHash, Even) { campaign(sphere_mesh(4), 3000); }
TEST(GeometrySpatialHash, Graded) { campaign(graded(), 5000); }
TEST(GeometrySpatialHash, LongThinFacets) { campaign(drum_mesh(96, 0.3, 50), 3000); }
TEST(GeometrySpatialHash, TrianglesSmallerThanSinglePrecision) {
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
  // A hundred equal triangles and some degenerate to points: equal distances.
  TriangleMesh m = tetrahedron_mesh();
  for (int i = 0; i < 100; ++i) m.triangles.push_back(m.triangles[3]);
  for (int i = 0; i < 20; ++i) m.triangles.push_back({1, 1, 1});
  campaign(m, 500);
  campaign({{{1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}, {}, {}}, 1);
}

TEST(GeometrySpatialHash, FarApart) {
  // Small triangles with wide gaps: most cells are empty, and the nearest triangle is often in a neighbouring
  // cell along one, two or three axes.
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
  // Cells of full, half and quarter size, with query points at their faces.
  const Search<SpatialHash> hash(m);
  const Box box = box_of(m);
  const double side = box.extent().maxCoeff();
  for (int i = 0; i < 3000; ++i) {
    Vec3 y = box.lo;
    for (int a = 0; a < 3; ++a)
      y[a] += side * (static_cast<int>(gen() % 65) / 64.0 + 1e-3 * u(gen) * (i % 2));
    const double exact = std::sqrt(brute_force(m, y));
    for (const double factor : {1.0 + 1e-9, 1.2, 3.0})
      ASSERT_NEAR(std::sqrt(hash.nearest(y, factor * exact).value().squared_distance), exact, 1e-11)
          << y.transpose();
  }
}

TEST(GeometrySpatialHash, ManyOfEachSizeInOnePlace) {
  // All small triangles are in one cube, and the largest triangles in many.
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
  const Search<SpatialHash> hash(m, active);
  const Search<BoxTree> tree(m, active);
  std::mt19937 gen(3);
  std::uniform_real_distribution<double> u(-2, 2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 y(u(gen), u(gen), u(gen));
    const Nearest near = hash.nearest(y, 10).value();
    ASSERT_TRUE(active[static_cast<std::size_t>(near.triangle)]);
    ASSERT_EQ(near.squared_distance, brute_force(some, y));
    ASSERT_EQ(tree.nearest(y, 10).value().triangle, near.triangle);
  }
}

template <class Structure>
void unusual_points() {
  const TriangleMesh nothing;
  const TriangleMesh m = sphere_mesh(2);
  EXPECT_FALSE(Search<Structure>(nothing).nearest({0, 0, 0}));
  EXPECT_TRUE(Structure().empty());
  const Search<Structure> search(m);
  EXPECT_TRUE(search.nearest(Vec3::Constant(1e12)));
  EXPECT_FALSE(search.nearest(Vec3::Constant(1e12), 5));
  EXPECT_TRUE(search.nearest(Vec3(0, 0, 0), 1 + 1e-9));
  EXPECT_FALSE(search.nearest(Vec3(0, 0, 0), 0.5));
}

TEST(GeometrySpatialHash, EmptyAndStrangePoints) {
  unusual_points<SpatialHash>();
  unusual_points<BoxTree>();
}

TEST(GeometrySpatialHash, VerySmallAndVeryLarge) {
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
    TriangleMesh m = graded();
    for (Vec3& v : m.vertices) v *= scale;
    campaign(m, 300);
  }
}

// Long diagonal facets have boxes as large as the mesh, other facets are far smaller than the cubes.
TEST(GeometrySpatialHash, MemoryIsBounded) {
  TriangleMesh m = sphere_mesh(4);
  for (int i = 0; i < 300; ++i) {
    const int v = static_cast<int>(m.vertices.size());
    for (const double at : {-100.0, 100.0, 100.1}) m.vertices.push_back(Vec3(at, at, at + 0.01 * i));
    m.triangles.push_back({v, v + 1, v + 2});
  }
  const SpatialHash hash(boxes_of(m));
  EXPECT_LE(hash.entries(), 6 * m.triangles.size());
  campaign(m, 300);
}

TEST(GeometrySpatialHash, WorkDoesNotGrowWithTheMesh) {
  // Triangles tested per query, for points a fixed fraction of a triangle above the surface.
  const auto work = [](int levels, auto search) {
    const TriangleMesh m = sphere_mesh(levels, 10);
    const decltype(search(m)) at(m);
    std::mt19937 gen(4);
    std::normal_distribution<double> g;
    const double d = 3.0 * std::ldexp(1.0, -levels);
    for (int i = 0; i < 2000; ++i)
      EXPECT_TRUE(at.nearest((10 + d) * Vec3(g(gen), g(gen), g(gen)).normalized(), 2 * d));
    return static_cast<double>(at.visits) / 2000;
  };
  // 2048 and 131072 triangles
  const auto hash = [](const TriangleMesh& m) { return Search<SpatialHash>(m); };
  EXPECT_LT(work(7, hash), 1.3 * work(4, hash));
  EXPECT_LT(work(7, hash), 60);
  const auto tree = [](const TriangleMesh& m) { return Search<BoxTree>(m); };
  EXPECT_LT(work(7, tree), 1.3 * work(4, tree));
  EXPECT_LT(work(7, tree), 20);
}

}  // namespace

}  // namespace hawser::geometry_spatial_hash_test
