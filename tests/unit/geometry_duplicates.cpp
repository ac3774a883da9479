// Duplicate triangles: regions of the surface that are listed twice, fins, walls and sheets. After their
// removal the distances equal those of the clean mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "hawser/advice/meshes.hpp"
#include "hawser/geometry/mesh_duplicates.hpp"
#include "hawser/geometry/mesh_repair.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_duplicates_test {
namespace {

using namespace hawser::test;

using Triangle = std::array<int, 3>;

class Chance {
 public:
  explicit Chance(unsigned seed) : gen_(seed) {}
  std::size_t below(std::size_t n) { return gen_() % n; }
  Vec3 point(const Box& b) {
    const auto x = [&](int i) { return std::uniform_real_distribution<double>(b.lo[i], b.hi[i])(gen_); };
    return Vec3(x(0), x(1), x(2));
  }
  template <class T>
  void shuffle(std::vector<T>& v) {
    std::shuffle(v.begin(), v.end(), gen_);
  }

 private:
  std::mt19937 gen_;
};

void flip(Triangle& t) { std::swap(t[0], t[1]); }

TriangleMesh clean_mesh(std::size_t kind) {
  switch (kind % 6) {
    case 0:
      return box_mesh(Vec3(-3, -2, -2), Vec3(3, 2, 0));
    case 1:
      return sphere_mesh(2);
    case 2:
      return l_prism_mesh();
    case 3:
      return flanged_drum_mesh(12, 1, 2, 1.5, 0.2);
    case 4:
      return hollow_cube_mesh();
    default:
      return drum_mesh(16, 1, 2, 3);
  }
}

// A connected region of at most `size` triangles around one of them.
std::vector<std::size_t> region(const TriangleMesh& m, std::size_t size, Chance& chance) {
  const Topology topo = topology(m);
  std::vector<std::size_t> all = {chance.below(m.triangles.size())};
  for (std::size_t k = 0; k < all.size() && all.size() < size; ++k)
    for (const int n : topo.neighbours[all[k]]) {
      const auto u = static_cast<std::size_t>(n);
      if (all.size() < size && std::find(all.begin(), all.end(), u) == all.end()) all.push_back(u);
    }
  return all;
}

// Removes duplicates as the reader does.
TriangleMesh dropped(TriangleMesh m, DuplicateResult* result = nullptr) {
  const DuplicateResult r = drop_duplicates(m);
  if (result) *result = r;
  if (!inspect(m).valid()) repair(m);
  return m;
}

void expect_same_distances(const TriangleMesh& m, const TriangleMesh& clean, Chance& chance, int points,
                           const std::string& what) {
  const MeshSurface a(m, {}, {false, 0, true});
  const MeshSurface b(clean);
  const Box around = b.bounds().grown(0.3);
  for (int i = 0; i < points; ++i) {
    const Vec3 y = chance.point(around);
    const auto p = a.query(y, 1e9);
    const auto q = b.query(y, 1e9);
    ASSERT_TRUE(p && q) << what;
    ASSERT_NEAR(p->distance, q->distance, 1e-12) << what << " at " << y.transpose();
  }
}

TEST(GeometryDuplicates, RegionsWrittenTwiceAreTheSurfaceOnce) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    Chance chance(seed);
    const TriangleMesh clean = clean_mesh(seed);
    TriangleMesh m = clean;
    const std::size_t n = clean.triangles.size();
    // One to three regions, up to the whole mesh; the copies have equal, reversed or random orientation.
    int added = 0;
    for (std::size_t k = 1 + chance.below(3); k > 0; --k) {
      const std::size_t way = chance.below(3);
      for (const std::size_t t : region(clean, 1 + chance.below(chance.below(4) == 0 ? n : 12), chance)) {
        m.triangles.push_back(clean.triangles[t]);
        if (way == 1 || (way == 2 && chance.below(2) == 0)) flip(m.triangles.back());
        std::rotate(m.triangles.back().begin(),
                    m.triangles.back().begin() + static_cast<long>(chance.below(3)),
                    m.triangles.back().end());
        ++added;
      }
    }
    if (chance.below(2) == 0) chance.shuffle(m.triangles);
    DuplicateResult r;
    m = dropped(m, &r);
    const std::string what = "seed " + std::to_string(seed);
    ASSERT_EQ(r.copies, added) << what;
    ASSERT_EQ(r.back_to_back, 0) << what;
    ASSERT_TRUE(inspect(m).valid()) << what;
    expect_same_distances(m, clean, chance, 20, what);
  }
}

// Fins on the body: both sides of a fin are removed, and copies of regions are removed as well.
TEST(GeometryDuplicates, FinsGo) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Chance chance(seed);
    const TriangleMesh clean = clean_mesh(seed);
    TriangleMesh m = clean;
    const bool opposite = chance.below(4) > 0;
    const auto both = [&](Triangle t) {
      m.triangles.push_back(t);
      if (opposite) flip(t);
      m.triangles.push_back(t);
    };
    // A strip from an edge of the body, outward or inward, of two triangles per row.
    const Triangle& t = clean.triangles[chance.below(clean.triangles.size())];
    int a = t[0];
    int b = t[1];
    const Vec3 out(0.1 * chance.point({-Vec3::Ones(), Vec3::Ones()}));
    const std::size_t rows = 1 + chance.below(3);
    for (std::size_t row = 0; row < rows; ++row) {
      const int c = static_cast<int>(m.vertices.size());
      for (const int v : {a, b}) m.vertices.push_back(Vec3(m.vertices[static_cast<std::size_t>(v)] + out));
      both({a, b, c + 1});
      both({a, c + 1, c});
      a = c;
      b = c + 1;
    }
    int copies = 0;
    if (chance.below(2) == 0)
      for (const std::size_t u : region(clean, 1 + chance.below(12), chance)) {
        m.triangles.push_back(clean.triangles[u]);
        flip(m.triangles.back());
        ++copies;
      }
    DuplicateResult r;
    m = dropped(m, &r);
    const std::string what = "seed " + std::to_string(seed);
    ASSERT_EQ(r.back_to_back, 4 * static_cast<int>(rows)) << what;
    ASSERT_EQ(r.copies, copies) << what;
    expect_same_distances(m, clean, chance, 20, what);
  }
}

// Two rooms, each of which lists the common wall; the wall is removed, also if everything is listed twice.
TEST(GeometryDuplicates, AWallBetweenTwoRoomsGoes) {
  TriangleMesh rooms = box_mesh(Vec3::Zero(), Vec3(1, 1, 1));
  append(rooms, box_mesh(Vec3(1, 0, 0), Vec3(2.5, 1, 1)));
  weld(rooms);
  DuplicateResult r;
  const TriangleMesh one = dropped(rooms, &r);
  EXPECT_EQ(r.back_to_back, 4);
  EXPECT_EQ(r.copies, 0);
  EXPECT_TRUE(inspect(one).valid());
  EXPECT_NEAR(inspect(one).volume, 2.5, 1e-14);
  const auto twice = rooms.triangles;
  for (Triangle t : twice) {
    flip(t);
    rooms.triangles.push_back(t);
  }
  const TriangleMesh two = dropped(rooms, &r);
  EXPECT_EQ(r.back_to_back, 8);
  EXPECT_EQ(r.copies, 20);
  EXPECT_NEAR(inspect(two).volume, 2.5, 1e-14);
}

// A hull without a deck, completely or partly two-sided, keeps one side; a two-sided bulkhead in it is
// removed.
TEST(GeometryDuplicates, AnOpenHullOfTwoSidesStaysOnce) {
  TriangleMesh hull = sphere_mesh(3);
  std::erase_if(hull.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(),
                       [&](int v) { return hull.vertices[static_cast<std::size_t>(v)].z() > 1e-9; });
  });
  weld(hull);
  const std::size_t n = hull.triangles.size();
  for (const std::size_t listed : {n, n / 2}) {
    TriangleMesh m = hull;
    for (std::size_t t = 0; t < listed; ++t) {
      m.triangles.push_back(hull.triangles[t]);
      flip(m.triangles.back());
    }
    DuplicateResult r;
    m = dropped(m, &r);
    EXPECT_EQ(r.copies, static_cast<int>(listed));
    EXPECT_EQ(m.triangles.size(), n);
  }
  // The bulkhead: a fan in the plane x = 0, from the middle of the deck to the shell.
  TriangleMesh m = hull;
  std::vector<std::pair<double, int>> along;
  for (std::size_t v = 0; v < hull.vertices.size(); ++v)
    if (const Vec3& x = hull.vertices[v]; std::abs(x.x()) < 1e-9)
      along.emplace_back(std::atan2(x.z(), x.y()), static_cast<int>(v));
  std::sort(along.begin(), along.end());
  const int middle = static_cast<int>(m.vertices.size());
  m.vertices.push_back(Vec3::Zero());
  for (std::size_t k = 1; k < along.size(); ++k) {
    m.triangles.push_back({middle, along[k - 1].second, along[k].second});
    m.triangles.push_back({middle, along[k].second, along[k - 1].second});
  }
  ASSERT_GT(m.triangles.size(), n + 10);
  DuplicateResult r;
  const TriangleMesh one = dropped(m, &r);
  EXPECT_EQ(r.copies, 0);
  EXPECT_EQ(one.triangles.size(), n);
  // The hull itself is two-sided.
  for (std::size_t t = 0; t < n; ++t) {
    m.triangles.push_back(hull.triangles[t]);
    flip(m.triangles.back());
  }
  const TriangleMesh two = dropped(m, &r);
  EXPECT_EQ(r.copies, static_cast<int>(n));
  EXPECT_EQ(two.triangles.size(), n);
}

// A deck on walls that are listed once, with one cell listed twice: the walls do not make the cell redundant.
TEST(GeometryDuplicates, ACellOfADeckOnWallsStays) {
  TriangleMesh m;
  const int n = 4;  // cells each way
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) m.vertices.push_back(Vec3(i, j, 0.8 * k));
  const auto at = [&](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  const auto quad = [&](int a, int b, int c, int d) {
    m.triangles.push_back({a, b, c});
    m.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      quad(at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1));
      quad(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
    }
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i < n; ++i) {
      // Outer walls face outward; the orientation of inner walls is irrelevant.
      if (j < n) quad(at(i, j, 0), at(i + 1, j, 0), at(i + 1, j, 1), at(i, j, 1));
      if (j == n) quad(at(i, j, 0), at(i, j, 1), at(i + 1, j, 1), at(i + 1, j, 0));
      if (j < n) quad(at(j, i, 0), at(j, i, 1), at(j, i + 1, 1), at(j, i + 1, 0));
      if (j == n) quad(at(j, i, 0), at(j, i + 1, 0), at(j, i + 1, 1), at(j, i, 1));
    }
  const std::size_t listed = m.triangles.size();
  for (const std::size_t t : {20U, 21U}) {  // the deck at i = 1, j = 1
    m.triangles.push_back(m.triangles[t]);
    flip(m.triangles.back());
  }
  const DuplicateResult r = drop_duplicates(m);
  EXPECT_EQ(r.copies, 2);
  EXPECT_EQ(m.triangles.size(), listed);
}

TEST(GeometryDuplicates, SheetsGo) {
  TriangleMesh box = box_mesh(Vec3::Zero(), Vec3::Ones());
  const TriangleMesh clean = box;
  // A separate two-sided sheet, and one whose two sides have different diagonals.
  box.vertices.insert(box.vertices.end(), {{3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 0}});
  for (const Triangle& t : {Triangle{8, 9, 10}, {8, 10, 11}, {8, 10, 9}, {8, 11, 10}})
    box.triangles.push_back(t);
  DuplicateResult r;
  TriangleMesh m = dropped(box, &r);
  EXPECT_EQ(r.back_to_back, 4);
  EXPECT_EQ(m.triangles.size(), 12U);
  std::vector<Triangle>& t = box.triangles;
  t[14] = {8, 11, 9};
  t[15] = {9, 11, 10};
  EXPECT_EQ(advice::duplicates_excluded(drop_duplicates(box)), "");
  EXPECT_EQ(drop_flat_pieces(box, 1e-6), 1);
  EXPECT_EQ(box.triangles, clean.triangles);
  EXPECT_EQ(drop_flat_pieces(box, 1e-6), 0);
  // A sheet without a body.
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(drop_flat_pieces(sheet, 1e-6), 0) << "open, so it may be a deck of what is beside it";
  sheet.triangles.insert(sheet.triangles.end(), {{0, 2, 1}, {0, 3, 2}});
  drop_duplicates(sheet);
  EXPECT_TRUE(sheet.triangles.empty());
}

}  // namespace
}  // namespace hawser::geometry_duplicates_test
