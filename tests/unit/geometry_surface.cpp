// Signed distance of meshes and primitives: against all triangles, the solid angle, closed forms and finite
// differences.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <thread>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/point_in_polyhedron.hpp"
#include "hawser/geometry/spatial_hash.hpp"
#include "hawser/geometry/surface.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_surface_test {
namespace {

using namespace hawser::test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double brute_force(const TriangleMesh& m, const Vec3& y, const std::vector<bool>& active = {}) {
  double best = kInfinity;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    if (!active.empty() && !active[t]) continue;
    const auto v = [&](std::size_t i) { return m.vertices[static_cast<std::size_t>(m.triangles[t][i])]; };
    best = std::min(best, closest_point_on_triangle(y, v(0), v(1), v(2)).squared_distance);
  }
  return std::sqrt(best);
}

// Random points near a mesh: anywhere in its enlarged box, or near a vertex, edge or face.
class Points {
 public:
  explicit Points(const MeshView& m, unsigned seed = 1) : mesh_(m), gen_(seed) {
    for (const Vec3& v : m.vertices) box_.add(v);
  }
  Vec3 operator()() {
    const double size = box_.diagonal();
    if (gen_() % 2) return box_.centre() + 0.6 * box_.extent().cwiseProduct(direction());
    const auto& t = mesh_.triangles[gen_() % mesh_.triangles.size()];
    const auto v = [&](std::size_t i) { return mesh_.vertices[static_cast<std::size_t>(t[i])]; };
    double a = unit_(gen_);
    double b = unit_(gen_) * (1 - a);
    const auto kind = gen_() % 4;
    if (kind == 0) a = b = 0;
    if (kind == 1) b = 0;
    return v(0) + a * (v(1) - v(0)) + b * (v(2) - v(0)) +
           size * std::pow(10.0, -5 * unit_(gen_)) * 0.3 * direction();
  }
  Vec3 direction() { return Vec3(2 * unit_(gen_) - 1, 2 * unit_(gen_) - 1, 2 * unit_(gen_) - 1); }

 private:
  MeshView mesh_;
  std::mt19937 gen_;
  std::uniform_real_distribution<double> unit_{0, 1};
  Box box_;
};

std::vector<TriangleMesh> bodies() {
  return {box_mesh({-1, 0, 1}, {1, 3, 2}),
          tetrahedron_mesh(),
          l_prism_mesh(),
          u_channel_mesh(),
          hollow_cube_mesh(),
          drum_mesh(96, 3.6, 5.5),
          flanged_drum_mesh(24, 1, 2, 1.5, 0.2),
          sphere_mesh(2)};
}

// A few thousand points per body; 13 000 with HAWSER_FULL.
TEST(GeometrySurface, CampaignOfDistanceAndSign) {
  const int points_each = std::getenv("HAWSER_FULL") ? 13000 : 4000;
  int points = 0, inside = 0;
  for (const TriangleMesh& m : bodies()) {
    const MeshSurface surface(m);
    const double size = inspect(m).box.diagonal();
    Points next(m);
    int hint = -1;
    for (int i = 0; i < points_each; ++i, ++points) {
      const Vec3 y = next();
      const double d = brute_force(m, y);
      const auto s = surface.query(y, kInfinity, hint);
      ASSERT_TRUE(s);
      hint = s->triangle;
      ASSERT_NEAR(std::abs(s->distance), d, 1e-13 * size) << y.transpose();
      ASSERT_NEAR((y - s->point).norm(), d, 1e-13 * size);
      ASSERT_NEAR(s->normal.norm(), 1, 1e-14);
      if (d > 1e-12 * size) {
        const bool in = winding_number(m, y) > 0.5;
        ASSERT_EQ(s->distance < 0, in) << y.transpose() << " d " << s->distance;
        inside += in;
      }
      // With a distance limit: the same result, or none if the point is outside and farther.
      const double limit = 0.05 * size;
      const auto near = surface.query(y, limit);
      ASSERT_EQ(near.has_value(), s->distance <= limit) << y.transpose();
      if (near) {
        ASSERT_EQ(near->distance, s->distance);
        ASSERT_EQ(near->triangle, s->triangle);
        ASSERT_EQ(near->normal, s->normal);
        ASSERT_TRUE(surface.bounds().grown(limit).contains(y));
      }
    }
  }
  EXPECT_GE(points, 7 * points_each);
  EXPECT_GT(10 * inside, points);
}

// Normal and curvature against central differences of the distance, away from discontinuities.
void expect_derivatives(const Surface& surface, const Vec3& y, double h, int& checked) {
  const auto s = surface.query(y, kInfinity);
  ASSERT_TRUE(s);
  if (std::abs(s->distance) < 100 * h) return;
  Vec3 gradient;
  Mat3 hessian;
  for (int a = 0; a < 3; ++a) {
    const Vec3 e = h * Vec3::Unit(a);
    const auto up = surface.query(y + e, kInfinity);
    const auto down = surface.query(y - e, kInfinity);
    if (up->triangle != s->triangle || down->triangle != s->triangle || up->feature != s->feature ||
        down->feature != s->feature)
      return;
    gradient[a] = (up->distance - down->distance) / (2 * h);
    hessian.col(a) = (up->normal - down->normal) / (2 * h);
  }
  ++checked;
  // Length scale of the distance's curvature.
  const double d = std::min(std::abs(s->distance), 1 / (s->curvature.norm() + 1e-9));
  ASSERT_LE((gradient - s->normal).norm(), 10 * h * h / (d * d) + 1e-9) << y.transpose();
  ASSERT_LE((hessian - s->curvature).norm(), (10 * h * h / (d * d) + 1e-8) * (1 + 1 / d))
      << y.transpose() << "\n"
      << hessian << "\n"
      << s->curvature;
}

TEST(GeometrySurface, NormalAndCurvatureAreDerivatives) {
  for (const TriangleMesh& m : bodies()) {
    const MeshSurface surface(m);
    Points next(m, 2);
    int checked = 0;
    for (int i = 0; i < 2000; ++i)
      ASSERT_NO_FATAL_FAILURE(expect_derivatives(surface, next(), 1e-5, checked));
    EXPECT_GT(checked, 300);
  }
  const CylinderSurface cylinder({1, 2, 3}, {2, 4, 1}, 0.7);
  const TriangleMesh around = box_mesh({0, 1, 0}, {3, 5, 4});
  Points next(around, 3);
  int checked = 0;
  for (int i = 0; i < 5000; ++i) ASSERT_NO_FATAL_FAILURE(expect_derivatives(cylinder, next(), 1e-5, checked));
  EXPECT_GT(checked, 3000);
}

TEST(GeometrySurface, CurvatureOnEachFeature) {
  const MeshSurface cube(box_mesh(Vec3::Zero(), Vec3::Ones()));
  EXPECT_EQ(cube.query({0.4, 0.7, 1.5}, 1)->curvature, Mat3::Zero());
  auto s = cube.query({1.3, 0.5, 1.4}, 1);  // edge along y, d = 0.5
  EXPECT_NEAR(s->distance, 0.5, 1e-15);
  EXPECT_TRUE(is_edge(s->feature));
  EXPECT_NEAR(s->curvature.trace(), 1 / 0.5, 1e-14);
  EXPECT_NEAR((s->curvature * Vec3::UnitY()).norm(), 0, 1e-15);
  s = cube.query({1 + 1.0 / 3, 1 + 2.0 / 3, 1 + 2.0 / 3}, 2);  // vertex, d = 1
  EXPECT_TRUE(is_vertex(s->feature));
  EXPECT_NEAR(s->curvature.trace(), 2, 1e-14);
  // Exactly on edge and vertex: bounded, with a normal between those of the faces.
  s = cube.query({1, 0.5, 1}, 1);
  EXPECT_NEAR(s->distance, 0, 1e-15);
  EXPECT_TRUE(s->curvature.allFinite());
  EXPECT_LE(s->curvature.norm(), 2e6);
  EXPECT_GE(s->normal.x(), 0);
  EXPECT_GE(s->normal.z(), 0);
  s = cube.query({1 + 1e-9, 0.5, 1 + 1e-9}, 1);
  EXPECT_NEAR(s->distance, std::sqrt(2) * 1e-9, 1e-15);
  EXPECT_LE(s->curvature.norm(), 2e6);
  // Inside, at the reentrant edge of the L, the curvature has the sign of d.
  s = MeshSurface(l_prism_mesh()).query({0.9, 0.8, 0.5}, 1);
  EXPECT_TRUE(is_edge(s->feature));
  EXPECT_NEAR(s->distance, -std::hypot(0.1, 0.2), 1e-15);
  EXPECT_NEAR(s->curvature.trace(), -1 / std::hypot(0.1, 0.2), 1e-13);
}

// A bar with edges divided in the middle: the distance is that to the edge beside a vertex on a straight
// edge, to the face over a vertex on a face, and to a point beside a corner.
TEST(GeometrySurface, CurvatureBesideVerticesOnEdgesAndFaces) {
  TriangleMesh m;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const auto& [y, z] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 0.0}, {1.0, 1.0}, {-1.0, 1.0}})
      m.vertices.emplace_back(x, y, z);
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < 5; ++i) {
      const int a = 5 * ring + i;
      const int b = 5 * ring + (i + 1) % 5;
      m.triangles.push_back({a, a + 5, b});
      m.triangles.push_back({b, a + 5, b + 5});
    }
  for (const std::array<int, 3> t : {std::array{0, 1, 2}, {0, 2, 4}, {2, 3, 4}}) {
    m.triangles.push_back(t);
    m.triangles.push_back({t[0] + 10, t[2] + 10, t[1] + 10});
  }
  double volume = 0;
  for (const auto& t : m.triangles) {
    const auto corner = [&](std::size_t i) { return m.vertices[static_cast<std::size_t>(t[i])]; };
    volume += corner(0).cross(corner(1)).dot(corner(2)) / 6;
  }
  EXPECT_NEAR(std::abs(volume), 8, 1e-12);
  if (volume < 0)
    for (auto& t : m.triangles) std::swap(t[1], t[2]);
  const MeshSurface surface(m);
  const auto at = [&](const Vec3& y) { return surface.query(y, 1).value(); };
  const SurfacePoint edge = at({0, 1.3, 1.4});
  EXPECT_NEAR(edge.distance, 0.5, 1e-12);
  EXPECT_LT((edge.curvature * Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((edge.curvature * Vec3(0, 0.8, -0.6) - 2 * Vec3(0, 0.8, -0.6)).norm(), 1e-12);
  EXPECT_LT(at({0, 1.5, 0}).curvature.norm(), 1e-12);
  EXPECT_LT(at({0.5, 1.5, 0}).curvature.norm(), 1e-12);  // over an edge between facets of one plane
  const SurfacePoint corner = at({1.3, 1, 1.4});
  EXPECT_LT((corner.curvature * Vec3::UnitY()).norm(),
            1e-12);  // no curvature along the edge, which is parallel to y
  const SurfacePoint tip = at({1.2, 1.2, 1.1});
  EXPECT_NEAR(tip.distance, 0.3, 1e-12);
  EXPECT_LT((tip.curvature - (Mat3::Identity() - tip.normal * tip.normal.transpose()) / 0.3).norm(), 1e-12);
}

TEST(GeometrySurface, DeepInsideIsReportedFarOutsideIsNot) {
  const MeshSurface drum(drum_mesh(96, 3.6, 5.5));
  const auto deep = drum.query({0.1, 0, 0.2}, 0.01);
  ASSERT_TRUE(deep);
  EXPECT_NEAR(deep->distance, -(2.75 - 0.2), 1e-14);
  EXPECT_FALSE(drum.query({3.3, 3.3, 0}, 0.01));  // in the box, outside the body
  EXPECT_FALSE(drum.query({30, 0, 0}, 0.01));
  const MeshSurface hollow(hollow_cube_mesh());
  EXPECT_FALSE(hollow.query({1.5, 1.5, 1.5}, 0.4));
  EXPECT_NEAR(hollow.query({1.5, 1.5, 1.5}, 0.6)->distance, 0.5, 1e-15);
}

TEST(GeometrySurface, PlaneAndCylinder) {
  const PlaneSurface plane({0, 0, 2}, {0, 0, 5});
  EXPECT_DOUBLE_EQ(plane.query({4, 5, 1}, 0.1)->distance, -1);
  EXPECT_FALSE(plane.query({4, 5, 2.2}, 0.1));
  EXPECT_EQ(plane.bounds().hi.z(), 2);
  EXPECT_EQ(plane.bounds().lo.z(), -kInfinity);
  const CylinderSurface c({0, 0, -1}, {0, 0, 1}, 2);
  EXPECT_DOUBLE_EQ(c.query({3, 0, 0.5}, 5)->distance, 1);
  EXPECT_DOUBLE_EQ(c.query({0, 0, 0.8}, 5)->distance, -0.2);
  EXPECT_DOUBLE_EQ(c.query({5, 0, 5}, 9)->distance, 5);
  EXPECT_LE((c.query({5, 0, 5}, 9)->point - Vec3(2, 0, 1)).norm(), 1e-15);
  EXPECT_FALSE(c.query({5, 0, 5}, 4.9));
  EXPECT_LE((c.bounds().hi - Vec3(2, 2, 1)).norm(), 1e-15);
  EXPECT_THROW(CylinderSurface({0, 0, 0}, {0, 0, 0}, 1), std::invalid_argument);
  EXPECT_THROW(PlaneSurface({0, 0, 0}, {0, 0, 0}), std::invalid_argument);
  // The drum's facets are within radius (1 - cos(pi / n)) of the cylinder.
  const MeshSurface drum(drum_mesh(96, 2, 2));
  Points next(drum.mesh(), 8);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 y = next();
    ASSERT_NEAR(c.query(y, kInfinity)->distance, drum.query(y, kInfinity)->distance,
                2 * (1 - std::cos(M_PI / 96)) + 1e-12);
  }
}

TEST(GeometrySurface, ActivePart) {
  const TriangleMesh m = flanged_drum_mesh(24, 1, 2, 1.5, 0.2);
  const std::vector<bool> active = active_by_part(m, {"barrel"});
  const MeshSurface barrel(m, active);
  const MeshSurface whole(m);
  // Beside the barrel both surfaces agree; beside the flange only the whole mesh has contact.
  const double across = std::cos(M_PI / 24);
  const Vec3 mid(std::cos(M_PI / 24), std::sin(M_PI / 24), 0);
  for (const double depth : {-0.3, -0.01, 0.01, 0.3}) {
    const auto s = barrel.query((across + depth) * mid, 0.5);
    ASSERT_TRUE(s) << depth;
    EXPECT_NEAR(s->distance, depth, 1e-14);
  }
  EXPECT_TRUE(whole.query({0, 0, 1.21}, 0.1));
  EXPECT_FALSE(barrel.query({0, 0, 1.21}, 0.1));
  EXPECT_TRUE(whole.query({0, 1.4, 1.1}, 0.1));
  EXPECT_FALSE(barrel.query({0, 1.05, 1.15}, 0.1));
  EXPECT_FALSE(barrel.query({0, 1.4, 1.1}, 0.1));  // in the flange, not in front of or behind the barrel
  EXPECT_TRUE(barrel.query({0, 0, 0.9}, 0.01));    // inside the barrel, 0.9 or more from all active facets
  // A plate with only its top active: no contact from below; points in the whole thickness are inside.
  const TriangleMesh plate = box_mesh({0, 0, 0}, {4, 4, 0.1});
  std::vector<bool> top = active_by_box(plate, {{-1, -1, 0.05}, {5, 5, 1}});
  EXPECT_EQ(std::count(top.begin(), top.end(), true), 2);
  const MeshSurface deck(plate, top);
  EXPECT_NEAR(deck.query({1, 2, 0.3}, 0.5)->distance, 0.2, 1e-15);
  EXPECT_NEAR(deck.query({1, 2, 0.02}, 0.5)->distance, -0.08, 1e-15);
  EXPECT_FALSE(deck.query({1, 2, -0.02}, 0.5));
  // In the gap of a U with only the far side of a leg active, points are behind that side, but outside the
  // body.
  const TriangleMesh channel = u_channel_mesh();
  const MeshSurface far_side(channel, active_by_box(channel, {{-1, -1, -1}, {0.5, 9, 9}}));
  EXPECT_FALSE(far_side.query({1.0001, 1.5, 2}, 5));
  EXPECT_NEAR(far_side.query({0.9999, 1.5, 2}, 0.1)->distance, -0.9999, 1e-15);
  // Distances of the active part agree with its triangles.
  Points next(m, 9);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 y = next();
    const auto s = barrel.query(y, 0.4);
    const double d = brute_force(m, y, active);
    if (s) {
      ++met;
      ASSERT_NEAR(std::abs(s->distance), d, 1e-13);
      if (s->distance < 0) {
        ASSERT_GT(winding_number(m, y), 0.5);
      }
    } else if (d < 0.4) {
      // A near point may be without contact only behind the faces of the barrel.
      ASSERT_LT(std::hypot(y.x(), y.y()), 1.5);
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_THROW(MeshSurface(m, std::vector<bool>(3, true)), std::invalid_argument);
  EXPECT_THROW(MeshSurface(m, std::vector<bool>(m.triangles.size(), false)), std::invalid_argument);
}

TEST(GeometrySurface, RefusesMeshesWithoutInside) {
  TriangleMesh m = box_mesh(Vec3::Zero(), Vec3::Ones());
  std::swap(m.triangles[0][0], m.triangles[0][1]);
  EXPECT_THROW(MeshSurface{m}, std::invalid_argument);
  m.triangles.erase(m.triangles.begin());
  EXPECT_THROW(MeshSurface{m}, std::invalid_argument);
  EXPECT_THROW(MeshSurface{TriangleMesh{}}, std::invalid_argument);
}

TEST(GeometrySurface, SignWhereTheSurfaceTouchesItselfOrHasNoArea) {
  // Two cubes that share an edge, and two that share a vertex.
  for (const Vec3& shift : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
    TriangleMesh m = box_mesh(Vec3::Zero(), Vec3::Ones());
    append(m, box_mesh(shift, shift + Vec3::Ones()));
    weld(m);
    ASSERT_TRUE(inspect(m).closed);
    const MeshSurface s(m);
    Points next(m, 4);
    for (int i = 0; i < 3000; ++i) {
      const Vec3 y = i % 3 ? Vec3(Vec3(1, 1, 1) + 0.1 * next.direction()) : next();
      if (brute_force(m, y) < 1e-12) continue;
      ASSERT_EQ(s.query(y, kInfinity)->distance<0, winding_number(m, y)> 0.5) << y.transpose();
    }
  }
  // A triangle of zero area along a sharp edge, with a corner in the middle of the edge.
  TriangleMesh m = tetrahedron_mesh();
  m.vertices.push_back({0.5, 0.5, 0});
  m.triangles = {{0, 2, 4}, {0, 4, 1}, {1, 4, 2}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  ASSERT_TRUE(inspect(m).valid());
  const MeshSurface s(m);
  Points next(m, 5);
  for (int i = 0; i < 5000; ++i) {
    // Every second point is straight outward from that corner, between the normals of the adjacent faces.
    const double out = i % 199 / 199.0;
    const Vec3 y = i % 2 ? next() : Vec3(Vec3(0.5, 0.5, 0) + out * Vec3(1, 1, 1) - (1 - out) * Vec3::UnitZ());
    const double d = brute_force(m, y);
    const auto q = s.query(y, kInfinity);
    ASSERT_NEAR(std::abs(q->distance), d, 1e-14);
    ASSERT_NEAR(q->normal.norm(), 1, 1e-14);
    if (d > 1e-12) {
      ASSERT_EQ(q->distance<0, winding_number(m, y)> 0.5) << y.transpose();
    }
  }
}

// Overflow of squared lengths is refused, with all facets active or some, flat or smooth.
TEST(GeometrySurface, TooLarge) {
  for (const bool smooth : {false, true})
    for (const bool partial : {false, true}) {
      TriangleMesh m = sphere_mesh(2);
      for (Vec3& v : m.vertices) v *= 1e160;
      std::vector<bool> active(m.triangles.size(), true);
      active[0] = !partial;
      EXPECT_THROW(MeshSurface(m, active, {.smooth = smooth}), std::invalid_argument) << smooth << partial;
    }
}

TEST(GeometrySurface, ThreadsAgree) {
  const MeshSurface s(sphere_mesh(3));
  std::vector<Vec3> points;
  Points next(s.mesh(), 6);
  for (int i = 0; i < 2000; ++i) points.push_back(next());
  std::vector<std::vector<double>> d(3);
  std::vector<std::thread> threads;
  for (auto& mine : d)
    threads.emplace_back([&] {
      for (const Vec3& y : points) mine.push_back(s.query(y, kInfinity)->distance);
    });
  for (auto& t : threads) t.join();
  EXPECT_EQ(d[0], d[1]);
  EXPECT_EQ(d[0], d[2]);
}

}  // namespace

}  // namespace hawser::geometry_surface_test
