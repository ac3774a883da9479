// Curved facets: accuracy against the true surface; consistency of distance, normal and curvature; nearest
// patch; creases; robustness for arbitrary meshes.
#include <gtest/gtest.h>

#include "hawser/geometry/mesh_bends.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/point_in_polyhedron.hpp"
#include "support/rough_meshes.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_smooth_surface_test {
namespace {

using namespace hawser::test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegree = M_PI / 180;
const MeshSurfaceOptions kSmooth{true};

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

// A square of side 2 with rounded corners, extruded to 3 m: wide plates beside narrow facets.
TriangleMesh rounded_box(double radius, int steps) {
  std::vector<std::pair<double, double>> polygon;
  std::vector<int> all;
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i <= steps; ++i) {
      const double a = M_PI / 2 * (c + static_cast<double>(i) / steps);
      const double x = c == 0 || c == 3 ? 1 - radius : radius - 1;
      const double y = c < 2 ? 1 - radius : radius - 1;
      all.push_back(static_cast<int>(polygon.size()));
      polygon.emplace_back(x + radius * std::cos(a), y + radius * std::sin(a));
    }
  return prism_mesh(polygon, {all}, 3);
}

struct Errors {
  double distance = 0, normal = 0, curvature = 0, jump = 0;
};

// Errors against the cylinder of radius 1, and the largest kink of the normal around it.
Errors around_drum(int facets, MeshSurfaceOptions options) {
  const MeshSurface drum(drum_mesh(facets, 1, 2, 3), {}, options);
  Errors e;
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double a = M_PI * random();
    const double z = 0.8 * random();
    const double d = 0.1 * random();
    const Vec3 n(std::cos(a), std::sin(a), 0);
    const Vec3 t(-n.y(), n.x(), 0);
    const auto s = drum.query((1 + d) * n + Vec3(0, 0, z), 1);
    e.distance = std::max(e.distance, std::abs(s->distance - d));
    e.normal = std::max(e.normal, angle(s->normal, n));
    e.curvature = std::max(e.curvature, std::abs(t.dot(s->curvature * t) * (1 + d) - 1));
  }
  const int steps = 100000;
  Vec3 last = drum.query({1, 0, 0.1}, 1)->normal;
  for (int i = 1; i <= steps; ++i) {
    const double a = 2 * M_PI * i / steps;
    const Vec3 n = drum.query({std::cos(a), std::sin(a), 0.1}, 1)->normal;
    e.jump = std::max(e.jump, angle(n, last) - 2 * M_PI / steps);
    last = n;
  }
  return e;
}

// Contact on a drum of 24 facets: the radius is right to 4e-5, and the normal has no kink.
TEST(GeometrySmoothSurface, DrumOf24FacetsIsRound) {
  const Errors flat = around_drum(24, {});
  const Errors smooth = around_drum(24, kSmooth);
  EXPECT_GT(flat.distance, 0.008);  // 1 - cos(7.5 degrees)
  EXPECT_GT(flat.jump, 14 * kDegree);
  EXPECT_LT(smooth.distance, 4e-5);
  EXPECT_LT(smooth.normal, 0.03 * kDegree);
  EXPECT_LT(smooth.jump, 1e-5);
  EXPECT_LT(smooth.curvature, 0.025);
  // A parabola with the end points and end tangents of an arc has a fourth-order error.
  const Errors finer = around_drum(48, kSmooth);
  EXPECT_NEAR(smooth.distance / finer.distance, 16, 1);
}

// A line that lies exactly along a row of edges around a drum whose coordinates are in single precision: the
// kinks there, of 1e-7, are rounding. The distance has the curvature of the drum, 1/(1 + d) around it and
// none along it, and not 1/d across an edge or about a vertex.
TEST(GeometrySmoothSurface, KinksByRoundingHaveNoCurvature) {
  const int facets = 96;
  TriangleMesh m = drum_mesh(facets, 1, 0.6, 4);
  for (Vec3& v : m.vertices) v = v.cast<float>().cast<double>();
  const MeshSurface drum(m, {}, kSmooth);
  int edges = 0, vertices = 0;
  for (int i = 0; i < 20 * facets; ++i) {
    const double a = 2 * M_PI * i / (20 * facets);
    const double d = 0.01;
    const Vec3 n(std::cos(a), std::sin(a), 0);
    const Vec3 t(-n.y(), n.x(), 0);
    const auto s = drum.query((1 + d) * n, 1);
    ASSERT_TRUE(s);
    edges += is_edge(s->feature);
    vertices += is_vertex(s->feature);
    EXPECT_NEAR(t.dot(s->curvature * t) * (1 + d), 1, 0.01) << i;
    EXPECT_NEAR(s->curvature(2, 2), 0, 0.01) << i;
  }
  EXPECT_GT(edges, facets);
  EXPECT_GT(vertices, 0);
}

TEST(GeometrySmoothSurface, SphereConverges) {
  double last = 0;
  for (const int levels : {2, 3, 4}) {
    const MeshSurface sphere(sphere_mesh(levels), {}, kSmooth);
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
      const Vec3 n = random.vec().normalized();
      worst = std::max(worst, std::abs(sphere.query(1.05 * n, 1)->distance - 0.05));
    }
    if (levels > 2) {
      EXPECT_GT(last / worst, 12);
    }
    last = worst;
  }
  EXPECT_LT(last, 5e-6);  // flat: 5e-3
}

TEST(GeometrySmoothSurface, CreasesAndPlanesStay) {
  // All edges of a box are creases.
  const MeshSurface box(box_mesh(Vec3::Zero(), Vec3::Ones()), {}, kSmooth);
  EXPECT_EQ(box.curved(), 0);
  EXPECT_EQ(box.sharp_edges(), 12);
  // A drum between flanges: planes remain plane, rims are round, and the barrel ends at them.
  const MeshSurface drum(flanged_drum_mesh(24, 1, 2, 1.5, 0.2), {}, kSmooth);
  EXPECT_EQ(drum.sharp_edges(), 6 * 24);
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const double a = M_PI * random();
    const double r = random(1.05, 1.45);
    const Vec3 n(std::cos(a), std::sin(a), 0);
    const auto face = drum.query(r * n + Vec3(0, 0, 0.96), 0.1);
    ASSERT_NEAR(face->distance, 0.04, 1e-12);
    ASSERT_LT(angle(face->normal, -Vec3::UnitZ()), 1e-10);
    const auto rim = drum.query(1.53 * n + Vec3(0, 0, 0.96), 0.1);
    ASSERT_NEAR(rim->distance, 0.05, 1e-4);
    ASSERT_TRUE(is_edge(rim->feature) || is_vertex(rim->feature));
    ASSERT_NEAR(drum.query(1.02 * n + Vec3(0, 0, 0.9), 0.1)->distance, 0.02, 1e-4);
  }
  // A drum does not change if the crease angle is below the angle between its facets.
  EXPECT_EQ(MeshSurface(drum_mesh(24, 1, 2), {}, {true, 14 * kDegree}).curved(), 0);
  EXPECT_GT(MeshSurface(drum_mesh(24, 1, 2), {}, {true, 16 * kDegree}).curved(), 0);
}

// The plane sides of a box with rounded edges, 15 times as wide as the facets of its corners, remain plane.
TEST(GeometrySmoothSurface, PlatesBesideRoundedCornersStayFlat) {
  const MeshSurface box(rounded_box(0.2, 6), {}, kSmooth);
  EXPECT_GT(box.curved(), 0);
  EXPECT_EQ(box.query({0, 1.1, 1.5}, 1)->distance, 1.1 - box.query({0, 1.1, 1.5}, 1)->point.y());
  EXPECT_NEAR(box.query({0.3, 1.1, 1.5}, 1)->distance, 0.1, 1e-12);
  EXPECT_NEAR(box.query({0.79, -1.1, 1.5}, 1)->distance, 0.1, 1e-12);
  EXPECT_LT(box.bulge(), 0.005);
  // The corners are round and meet the plates without a kink; the polygon has an error of 0.0017 m.
  double worst = 0;
  for (int i = 0; i <= 900; ++i) {
    const double a = M_PI / 2 * i / 900;
    const auto s = box.query({0.8 + 0.25 * std::cos(a), 0.8 + 0.25 * std::sin(a), 1.5}, 1);
    worst = std::max(worst, std::abs(s->distance - 0.05));
  }
  EXPECT_LT(worst, 6e-4);
}

TEST(GeometrySmoothSurface, NormalAndCurvatureAreDerivatives) {
  int edges = 0;
  for (const TriangleMesh& m :
       {drum_mesh(24, 1, 2, 3), sphere_mesh(2), flanged_drum_mesh(24, 1, 2, 1.5, 0.2), rough_mesh(0.02)}) {
    const MeshSurface surface(m, {}, kSmooth);
    ASSERT_GT(surface.curved(), 50);
    Random random(4);
    int checked = 0;
    const double h = 1e-5;
    for (int i = 0; i < 4000; ++i) {
      const auto& t = m.triangles[random.below(m.triangles.size())];
      const double f = random(0, 1);
      const double g = random(0, 1 - f);
      const auto v = [&](std::size_t k) { return m.vertices[static_cast<std::size_t>(t[k])]; };
      const Vec3 y = v(0) + f * (v(1) - v(0)) + g * (v(2) - v(0)) + random(0.01, 0.2) * random.vec();
      const auto s = surface.query(y, kInfinity);
      if (std::abs(s->distance) < 100 * h) continue;
      Vec3 gradient;
      Mat3 hessian;
      bool same = true;
      for (int a = 0; a < 3; ++a) {
        const auto up = surface.query(y + h * Vec3::Unit(a), kInfinity);
        const auto down = surface.query(y - h * Vec3::Unit(a), kInfinity);
        same = same && up->triangle == s->triangle && down->triangle == s->triangle &&
               up->feature == s->feature && down->feature == s->feature;
        gradient[a] = (up->distance - down->distance) / (2 * h);
        hessian.col(a) = (up->normal - down->normal) / (2 * h);
      }
      if (!same) continue;
      ++checked;
      edges += is_edge(s->feature);
      const double size = std::max(1 / std::abs(s->distance), s->curvature.norm());
      if (size > 1000) continue;
      ASSERT_LT((gradient - s->normal).norm(), 10 * h * h * size * size + 1e-9) << y.transpose();
      ASSERT_LT((hessian - s->curvature).norm(), 20 * h * h * size * size * size + 1e-7 * (1 + size))
          << y.transpose() << "\n"
          << hessian << "\n\n"
          << s->curvature;
    }
    EXPECT_GT(checked, 1500);
  }
  EXPECT_GT(edges, 100);
}

// The least value over a patch against a grid with n intervals, between whose points a quadratic polynomial
// falls by at most a third of the largest bend per n².
TEST(GeometrySmoothSurface, LeastDistanceFromAPlane) {
  Random random(8);
  int on_corner = 0, elsewhere = 0;
  for (int i = 0; i < 300; ++i) {
    const double bend = random(0.0, 2.0);
    const SmoothPatch q{{random.vec(), random.vec(), random.vec()},
                        {bend * random.vec(), bend * random.vec(), bend * random.vec()}};
    const Vec3 y = 2 * random.vec();
    const Vec3 r = random.vec();
    const double least = q.least(y, r);
    constexpr int kSteps = 60;
    double least_of_grid = kInfinity;
    for (int a = 0; a <= kSteps; ++a)
      for (int b = 0; a + b <= kSteps; ++b)
        least_of_grid = std::min(least_of_grid, r.dot(y - q.point(a / (1.0 * kSteps), b / (1.0 * kSteps))));
    const double largest = std::max({q.c[0].norm(), q.c[1].norm(), q.c[2].norm()});
    ASSERT_LE(least, least_of_grid + 1e-13);
    ASSERT_GE(least, least_of_grid - largest * r.norm() / (3.0 * kSteps * kSteps) - 1e-13);
    (least_of_grid - least < 1e-13 ? on_corner : elsewhere)++;
  }
  EXPECT_GT(on_corner, 50);
  EXPECT_GT(elsewhere, 50);
}

// Nearest point against a fine grid on the patch and against all patches.
TEST(GeometrySmoothSurface, NearestOfAll) {
  for (const double noise : {0.0, 0.03, 0.08}) {
    const TriangleMesh m = rough_mesh(noise);
    const MeshSurface surface(m, {}, kSmooth);
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
      const double scale = random(0.1, 1.4);
      const Vec3 y = scale * random.vec();
      const int hint = static_cast<int>(random.below(m.triangles.size()));
      const auto s = surface.query(y, kInfinity, hint);
      double best = kInfinity;
      for (int t = 0; t < static_cast<int>(m.triangles.size()); ++t) {
        const SmoothPatch q = surface.patch(t);
        best = std::min(best, q.flat() ? closest_point_on_triangle(y, q.p[0], q.p[1], q.p[2]).squared_distance
                                       : closest_point_on_patch(y, q).squared_distance);
      }
      ASSERT_NEAR(std::abs(s->distance), std::sqrt(best), 1e-12);
      const auto again = surface.query(y, kInfinity);
      ASSERT_EQ(again->triangle, s->triangle);
      ASSERT_EQ(again->distance, s->distance);
      const SmoothPatch q = surface.patch(s->triangle);
      for (int a = 0; a <= 20; ++a)
        for (int b = 0; a + b <= 20; ++b)
          ASSERT_GE((y - q.point(a / 20.0, b / 20.0)).norm(), std::sqrt(best) * (1 - 1e-12));
    }
  }
}

// No point of any patch is within the distance reported as free, also beyond centres of curvature, where the
// point found need not be the nearest. Near a round surface the whole distance is free.
TEST(GeometrySmoothSurface, WhatIsFreeHoldsNoSurface) {
  const MeshSurface rough(rough_mesh(0.03), {}, kSmooth);
  std::vector<Vec3> places;
  constexpr int kSteps = 12;
  for (int t = 0; t < static_cast<int>(rough.mesh().triangles.size()); ++t)
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j)
        places.push_back(
            rough.patch(t).point(static_cast<double>(i) / kSteps, static_cast<double>(j) / kSteps));
  Random random(6);
  int shortened = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 y = random(0.3, 1.6) * random.vec().normalized();
    const auto s = rough.query(y, kInfinity);
    const double distance = std::abs(s->distance);
    const double free = rough.free_radius(y, distance);
    double least = kInfinity;
    for (const Vec3& p : places) least = std::min(least, (p - y).squaredNorm());
    EXPECT_LE(free, std::sqrt(least) + 1e-12);
    EXPECT_GE(free, distance - 2 * rough.bulge());
    ++(free < distance ? shortened : all);
  }
  printf("  all of the distance at %d places, less at %d\n", all, shortened);
  EXPECT_GT(all, 50);
  EXPECT_GT(shortened, 50);
  const MeshSurface sphere(sphere_mesh(3), {}, kSmooth);
  for (int i = 0; i < 100; ++i) {
    const Vec3 y = random(1.01, 1.1) * random.vec().normalized();
    const double distance = sphere.query(y, 1)->distance;
    EXPECT_EQ(sphere.free_radius(y, distance), distance);
  }
}

// Along straight lines of a patch that is reported convex, the squared distance has no negative second
// difference; along other patches it may have one.
TEST(GeometrySmoothSurface, OneNearestPointMeansConvex) {
  Random random(8);
  int convex = 0, bent = 0;
  for (int i = 0; i < 2000; ++i) {
    SmoothPatch q;
    for (Vec3& p : q.p) p = random.vec();
    for (Vec3& c : q.c) c = 0.1 * random.vec();
    const Vec3 y = (q.p[0] + q.p[1] + q.p[2]) / 3 + random(0, 1) * random.vec();
    double least = kInfinity;
    for (int k = 0; k < 200; ++k) {
      const double u = random(0, 1);
      const double v = random(0, 1 - u);
      const double a = random(0, 1);
      const double b = random(0, 1 - a);
      const double h = 0.01;
      const auto at = [&](double s) { return (q.point(u + s * (a - u), v + s * (b - v)) - y).squaredNorm(); };
      least = std::min(least, at(0.5 + h) - 2 * at(0.5) + at(0.5 - h));
    }
    if (one_nearest_point(y, q)) {
      ++convex;
      EXPECT_GT(least, -1e-14);
    } else {
      bent += least < 0;
    }
  }
  printf("  convex %d, not convex %d of 2000\n", convex, bent);
  EXPECT_GT(convex, 50);
  EXPECT_GT(bent, 50);
}

TEST(GeometrySmoothSurface, PatchesAreWatertightAndDoNotFold) {
  for (const double noise : {0.0, 0.05, 0.2}) {
    const TriangleMesh m = rough_mesh(noise);
    const Topology topo = topology(m);
    const MeshBends bends = mesh_bends(m, topo, 40 * kDegree);
    ASSERT_EQ(bends.edge_bends.size(), m.triangles.size());
    if (noise > 0.1) {
      EXPECT_GT(bends.sharp, 100);
    }
    const MeshSurface surface(m, {}, kSmooth);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      const SmoothPatch q = surface.patch(static_cast<int>(t));
      const Vec3 flat = (q.p[1] - q.p[0]).cross(q.p[2] - q.p[0]);
      for (int i = 0; i < 3; ++i) {
        const auto u = static_cast<std::size_t>(topo.neighbours[t][static_cast<std::size_t>(i)]);
        bool shared = false;
        for (const auto& c : bends.edge_bends[u])
          shared = shared || c == bends.edge_bends[t][static_cast<std::size_t>(i)];
        ASSERT_TRUE(shared);
        const auto j = static_cast<std::size_t>(i);
        ASSERT_LE(q.c[j].norm(), 0.5 * (q.p[(j + 1) % 3] - q.p[j]).norm() * (1 + 1e-6));
      }
      for (int a = 0; a <= 8; ++a)
        for (int b = 0; a + b <= 8; ++b) {
          const Vec3 n = q.normal(a / 8.0, b / 8.0);
          ASSERT_GT(n.dot(flat), 0.49 * n.norm() * flat.norm());
        }
    }
  }
}

// The distance is that of one closed surface: its Lipschitz constant is 1, its sign is that of the flat
// facets except within the bulge, and it is the integral of its normal along any path.
TEST(GeometrySmoothSurface, DistanceIsContinuousAndAPotential) {
  for (const TriangleMesh& m :
       {flanged_drum_mesh(24, 1, 2, 1.5, 0.2), rough_mesh(0.05), l_prism_mesh(), drum_mesh(7, 1, 2)}) {
    const MeshSurface surface(m, {}, {true, 60 * kDegree});
    Random random(7);
    for (int i = 0; i < 200; ++i) {
      const Vec3 from = 2 * random.vec();
      const Vec3 step = 0.01 * random.vec();
      double last = surface.query(from, kInfinity)->distance;
      double integral = last;
      for (int k = 1; k <= 100; ++k) {
        const Vec3 y = from + k * step;
        const auto s = surface.query(y, kInfinity);
        ASSERT_LE(std::abs(s->distance - last), step.norm() * (1 + 1e-9)) << y.transpose();
        ASSERT_NEAR(s->normal.norm(), 1, 1e-12);
        ASSERT_TRUE(s->curvature.allFinite());
        if (std::abs(s->distance) > surface.bulge() + 1e-9) {
          ASSERT_EQ(s->distance<0, winding_number(m, y)> 0.5) << y.transpose();
        }
        integral += surface.query(y - 0.5 * step, kInfinity)->normal.dot(step);
        last = s->distance;
      }
      ASSERT_NEAR(integral, last, 0.05);  // a step across the medial surface has an error of half the step
    }
  }
}

TEST(GeometrySmoothSurface, DegenerateTrianglesAndActiveParts) {
  // A triangle of zero area along an edge of a drum.
  TriangleMesh m = drum_mesh(24, 1, 2);
  const int corner = static_cast<int>(m.vertices.size());
  const auto whole = m.triangles[10];
  m.vertices.push_back(0.5 * (m.vertices[static_cast<std::size_t>(whole[0])] +
                              m.vertices[static_cast<std::size_t>(whole[1])]));
  m.triangles[10] = {whole[0], corner, whole[2]};
  m.triangles.push_back({corner, whole[1], whole[2]});
  m.triangles.push_back({whole[0], whole[1], corner});
  ASSERT_TRUE(inspect(m).closed);
  const MeshSurface drum(m, {}, kSmooth);
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 y = 1.3 * random.vec();
    const auto s = drum.query(y, kInfinity);
    ASSERT_NEAR(s->normal.norm(), 1, 1e-12);
    if (std::abs(s->distance) > drum.bulge() + 1e-9) {
      ASSERT_EQ(s->distance<0, winding_number(m, y)> 0.5);
    }
  }
  const TriangleMesh flanged = flanged_drum_mesh(24, 1, 2, 1.5, 0.2);
  const MeshSurface barrel(flanged, active_by_part(flanged, {"barrel"}), kSmooth);
  EXPECT_NEAR(barrel.query({1.1, 0, 0.3}, 0.5)->distance, 0.1, 1e-6);
  EXPECT_NEAR(barrel.query({std::cos(0.1) * 0.9, std::sin(0.1) * 0.9, 0.3}, 0.5)->distance, -0.1, 1e-4);
  EXPECT_FALSE(barrel.query({0, 1.05, 1.15}, 0.1));
  EXPECT_FALSE(barrel.query({0, 0, 1.21}, 0.1));
}

}  // namespace

}  // namespace hawser::geometry_smooth_surface_test
