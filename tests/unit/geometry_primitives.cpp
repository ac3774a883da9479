// Exact primitives: distance against points and triangles of their surface, sign against implicit forms,
// normal and curvature against finite differences.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "hawser/geometry/closest_point.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/primitives.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::geometry_primitives_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Known {
  const char* name;
  Primitive shape;
  double size;     // m, largest extent, approximately
  double sagitta;  // m, of the displayed facets
  // Negative inside, positive outside, zero on the surface; not computed from a distance where possible.
  double (*implicit)(const Vec3&);
};

const Vec3 kTurn(0.4, -0.7, 1.1), kCentre(1, 2, 3), kFrom(1, 2, 3), kTo(2, 4, 1), kAxis(1, -2, 0.5);

double in_box(const Vec3& y) {
  const Vec3 p = exp_so3(kTurn).conjugate() * (y - kCentre);
  return ((p.cwiseAbs() - Vec3(0.6, 0.25, 1.0)).array()).maxCoeff();
}
double in_sphere(const Vec3& y) { return (y - kCentre).squaredNorm() - 0.49; }
double in_cylinder(const Vec3& y) {
  const Vec3 u = kTo - kFrom;
  const double s = (y - kFrom).dot(u) / u.squaredNorm();
  return std::max({(y - kFrom).cross(u).norm() / u.norm() - 0.7, -s, s - 1});
}
double in_capsule(const Vec3& y) { return closest_point_on_segment(y, kFrom, kTo).squared_distance - 0.49; }
double in_torus(const Vec3& y) {  // quartic: (|r|² + R² - a²)² = 4 R² rho²
  const Vec3 r = y - kCentre;
  const Vec3 n = kAxis.normalized();
  const double R = 1.2;
  const double a = 0.3;
  const double q = r.squaredNorm() + R * R - a * a;
  return q * q - 4 * R * R * (r.squaredNorm() - std::pow(r.dot(n), 2));
}
// A leg of 0.6 m along z, a quarter of a circle of 1.2 m towards x, a leg of 0.6 m along x.
const std::vector<Vec3> kPath{kCentre, kCentre + Vec3(0, 0, 1.8), kCentre + Vec3(1.8, 0, 1.8)};
double in_tube(const Vec3& y) {
  const Vec3 r = y - kCentre;
  const double R = 0.3, a = 0.1;
  const auto ring = [&](double across, double along) {  // tube about a circle, as in_torus
    const double q = across * across + along * along + R * R - a * a;
    return q * q - 4 * R * R * across * across;
  };
  const auto wall = [&](double across2) { return (across2 - 0.04) * (across2 - 0.16); };
  const double x = r.x();
  const double z = r.z();
  double out = kInfinity;
  if (z >= 0 && z <= 0.6) out = std::min(out, wall(x * x + r.y() * r.y()));
  if (x >= 1.2 && x <= 1.8) out = std::min(out, wall(std::pow(z - 1.8, 2) + r.y() * r.y()));
  if (z >= 0.6 && x <= 1.2) {
    const double across = std::hypot(x - 1.2, z - 0.6) - 1.2;
    out = std::min(out, wall(across * across + r.y() * r.y()));
  }
  if (z <= 0) out = std::min(out, ring(std::hypot(x, r.y()), z));
  if (x >= 1.8) out = std::min(out, ring(std::hypot(z - 1.8, r.y()), x - 1.8));
  return out;
}
double in_plane(const Vec3& y) { return kAxis.dot(y - kCentre); }

// Sagitta of a chord over 2 pi / n on a circle of radius r.
double sagitta(double r, int n) { return r * (1 - std::cos(M_PI / n)); }

std::vector<Known> shapes() {
  return {{"plane", PlaneShape{kCentre, kAxis}, 4, 0, in_plane},
          {"box", BoxShape{kCentre, {1.2, 0.5, 2.0}, kTurn}, 2, 0, in_box},
          {"sphere", SphereShape{kCentre, 0.7}, 1.4, 2 * sagitta(0.7, 48), in_sphere},
          {"cylinder", CylinderShape{kFrom, kTo, 0.7}, 3, sagitta(0.7, 64), in_cylinder},
          {"capsule", CapsuleShape{kFrom, kTo, 0.7}, 3, 2 * sagitta(0.7, 48), in_capsule},
          {"torus", TorusShape{kCentre, kAxis, 1.2, 0.3}, 3, sagitta(1.5, 64) + sagitta(0.3, 24), in_torus},
          {"tube", TubeShape{kPath, {1.2}, 0.2, 0.2}, 2.5,
           sagitta(1.6, 64) + sagitta(0.4, 64) + sagitta(0.1, 16), in_tube}};
}

class Random {
 public:
  explicit Random(unsigned seed) : gen_(seed) {}
  double operator()() { return uniform_(gen_); }
  Vec3 vec() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937 gen_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

Box view() {
  Box box;
  box.add(kCentre - Vec3::Constant(2));
  box.add(kCentre + Vec3::Constant(2));
  return box;
}

// Random point around the shape or near its surface.
Vec3 sample(const Known& k, const TriangleMesh& m, Random& next) {
  const Vec3 wide = kCentre + Vec3(0.5, 1, -1) + 2.5 * next.vec();
  if (next() > 0) return wide;
  const auto i = static_cast<std::size_t>(0.5 * (next() + 1) * static_cast<double>(m.vertices.size() - 1));
  return m.vertices[i] + k.size * std::pow(10.0, -2.5 * (next() + 1)) * next.vec();
}

TEST(GeometryPrimitives, DistanceAgainstTheSurface) {
  for (const Known& k : shapes()) {
    SCOPED_TRACE(k.name);
    const auto surface = make_surface(k.shape);
    const TriangleMesh m = facets(k.shape, view());
    for (const Vec3& v : m.vertices) {
      const auto s = surface->query(v, kInfinity);
      ASSERT_TRUE(s);
      ASSERT_NEAR(s->distance, 0, 2e-15 * k.size * 4);
    }
    const bool plane = std::holds_alternative<PlaneShape>(k.shape);
    if (plane) {
      // The patch is square, faces outward and covers the given box.
      ASSERT_EQ(m.triangles.size(), 2U);
      const Vec3 n = (m.vertices[1] - m.vertices[0]).cross(m.vertices[2] - m.vertices[0]).normalized();
      EXPECT_LE((n - kAxis.normalized()).norm(), 1e-15);
      EXPECT_NEAR((m.vertices[1] - m.vertices[0]).norm(), 4 * std::sqrt(3), 1e-14);
      EXPECT_LE((m.vertices[0] + m.vertices[2] - 2 * kCentre).norm(), 1e-14);
    } else {
      const MeshReport report = inspect(m);
      EXPECT_TRUE(report.valid());
      EXPECT_EQ(report.components, 1);
    }
    const std::unique_ptr<MeshSurface> mesh = plane ? nullptr : std::make_unique<MeshSurface>(m);
    Random next(1);
    int inside = 0;
    for (int i = 0; i < 10000; ++i) {
      const Vec3 y = sample(k, m, next);
      const auto s = surface->query(y, kInfinity, i % 30);
      ASSERT_TRUE(s);
      const double rounding = 1e-14 * (k.size + (y - kCentre).norm());
      // The returned point is on the surface and at the returned distance ...
      ASSERT_NEAR(surface->query(s->point, kInfinity)->distance, 0, rounding);
      ASSERT_NEAR(k.implicit(s->point), 0, 50 * rounding);
      ASSERT_NEAR((y - s->point).norm(), std::abs(s->distance), rounding);
      ASSERT_LE((y - s->point - s->distance * s->normal).norm(), rounding);
      ASSERT_NEAR(s->normal.norm(), 1, 1e-14);
      // ... the sign is that of the implicit form, and no other point of the surface is nearer.
      if (std::abs(s->distance) > rounding) {
        ASSERT_EQ(s->distance < 0, k.implicit(y) < 0) << y.transpose();
      }
      inside += s->distance < 0;
      for (int n = 0; n < 20; ++n) {
        const auto v = static_cast<std::size_t>((i * 20 + n) % static_cast<int>(m.vertices.size()));
        ASSERT_LE(std::abs(s->distance), (y - m.vertices[v]).norm() + rounding);
      }
      if (mesh) {
        ASSERT_NEAR(mesh->query(y, kInfinity)->distance, s->distance, k.sagitta + rounding);
      }
      // A distance limit removes results without changing others.
      const double limit = 0.1 * next();
      const auto near = surface->query(y, limit);
      ASSERT_EQ(near.has_value(), s->distance <= limit);
      if (near) {
        ASSERT_EQ(near->distance, s->distance);
        ASSERT_EQ(near->normal, s->normal);
        ASSERT_EQ(near->triangle, s->triangle);
        ASSERT_TRUE(surface->bounds().grown(std::max(limit, 0.0) + rounding).contains(y));
      }
    }
    EXPECT_GT(inside, 500);
  }
}

TEST(GeometryPrimitives, NormalAndCurvatureAreDerivatives) {
  const double h = 1e-5;
  for (const Known& k : shapes()) {
    SCOPED_TRACE(k.name);
    const auto surface = make_surface(k.shape);
    const TriangleMesh m = facets(k.shape, view());
    Random next(2);
    int checked = 0, curved = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec3 y = sample(k, m, next);
      const auto s = surface->query(y, kInfinity);
      ASSERT_TRUE(s->curvature.isApprox(s->curvature.transpose(), 1e-12) || s->curvature.norm() < 1e-12);
      const double bend = 1 / (s->curvature.norm() + 1e-9);  // length scale of the distance's curvature
      Vec3 gradient;
      Mat3 hessian, mean;
      bool same = bend > 200 * h;
      for (int a = 0; a < 3 && same; ++a) {
        const Vec3 e = h * Vec3::Unit(a);
        const auto up = surface->query(y + e, kInfinity);
        const auto down = surface->query(y - e, kInfinity);
        // Excludes pairs of points on two sides of an edge of the surface or of the medial axis.
        same = up->triangle == s->triangle && down->triangle == s->triangle && up->feature == s->feature &&
               down->feature == s->feature && (up->point - down->point).norm() < 0.1 * bend + 20 * h;
        gradient[a] = (up->distance - down->distance) / (2 * h);
        hessian.col(a) = (up->normal - down->normal) / (2 * h);
        // The difference of the normals is the integral of the curvature between the points (Simpson's rule).
        mean.col(a) = (up->curvature.col(a) + 4 * s->curvature.col(a) + down->curvature.col(a)) / 6;
      }
      if (!same) continue;
      ++checked;
      curved += s->curvature.norm() > 0;
      const double error = 10 * h * h / (bend * bend);
      ASSERT_LE((gradient - s->normal).norm(), error + 1e-9) << y.transpose();
      ASSERT_LE((hessian - mean).norm(), (error + 1e-8) * (1 + 1 / bend)) << y.transpose() << "\n"
                                                                          << hessian << "\n\n"
                                                                          << s->curvature;
    }
    EXPECT_GT(checked, 4000);
    if (!std::holds_alternative<PlaneShape>(k.shape)) {
      EXPECT_GT(curved, 1000);
    }
  }
}

// |d(y) - d(z)| <= |y - z|, also across edges, axes and centres.
TEST(GeometryPrimitives, DistanceGrowsNoFasterThanTheWay) {
  for (const Known& k : shapes()) {
    SCOPED_TRACE(k.name);
    const auto surface = make_surface(k.shape);
    const TriangleMesh m = facets(k.shape, view());
    Random next(3);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 y = sample(k, m, next);
      const Vec3 z = i % 2 ? sample(k, m, next) : Vec3(y + std::pow(10.0, -4 * (next() + 1)) * next.vec());
      const double dy = surface->query(y, kInfinity)->distance;
      const double dz = surface->query(z, kInfinity)->distance;
      ASSERT_LE(std::abs(dy - dz), (y - z).norm() * (1 + 1e-14) + 1e-14) << y.transpose();
    }
  }
}

// On centres, axes, diagonals and sharp edges the result is finite, reproducible, a unit normal and a true
// nearest point.
TEST(GeometryPrimitives, WhereThereIsNoOneNearestPoint) {
  const Vec3 axis = (kTo - kFrom).normalized();
  const Vec3 spin = kAxis.normalized();
  const Mat3 turn = exp_so3(kTurn).toRotationMatrix();
  std::vector<Vec3> points = {kCentre, kFrom, kTo, 0.5 * (kFrom + kTo), kCentre + spin, kCentre - 0.1 * spin};
  for (const double s : {-0.3, 0.1, 0.9, 1.4}) points.push_back(kFrom + s * (kTo - kFrom));
  for (int i = 0; i < 8; ++i) {
    const Vec3 side(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    points.push_back(kCentre + turn * Vec3(0.6, 0.25, 1.0).cwiseProduct(side));  // corners
    points.push_back(kCentre + turn * Vec3(0.5, 0.15, 0.9).cwiseProduct(side));  // on diagonals
    points.push_back(kCentre + 1.2 * spin.unitOrthogonal() * side.x());          // middle of the tube
    points.push_back(kFrom + 0.7 * axis.unitOrthogonal() * side.x());            // rim of the cylinder
  }
  for (const Known& k : shapes()) {
    SCOPED_TRACE(k.name);
    const auto surface = make_surface(k.shape);
    for (const Vec3& y : points)
      for (const double shift : {0.0, 1e-16, 1e-13, 1e-9}) {
        const Vec3 z = y + shift * Vec3(1, -2, 3);
        const auto s = surface->query(z, kInfinity);
        const auto again = surface->query(z, kInfinity, 3);
        ASSERT_TRUE(s && s->curvature.allFinite() && s->point.allFinite());
        ASSERT_NEAR(s->normal.norm(), 1, 1e-14);
        ASSERT_LE(s->curvature.norm(), 1e8);
        ASSERT_NEAR((z - s->point).norm(), std::abs(s->distance), 1e-12);
        ASSERT_NEAR(k.implicit(s->point), 0, 1e-12) << z.transpose();
        ASSERT_EQ(s->normal, again->normal);
        ASSERT_EQ(s->curvature, again->curvature);
      }
  }
}

TEST(GeometryPrimitives, KnownAnswers) {
  const auto box = make_surface(BoxShape{{1, 1, 1}, {2, 4, 6}, Vec3::Zero()});
  auto s = box->query({3, 1, 1}, 5);
  EXPECT_EQ(s->distance, 1);
  EXPECT_EQ(s->triangle, 2 + 3 + 9);
  EXPECT_EQ(s->curvature, Mat3::Zero());
  s = box->query({5, 6, 1}, 9);  // edge along z
  EXPECT_DOUBLE_EQ(s->distance, std::hypot(3, 3));
  EXPECT_EQ(s->feature, Feature::edge0);
  EXPECT_NEAR(s->curvature.trace(), 1 / std::hypot(3, 3), 1e-15);
  EXPECT_NEAR((s->curvature * Vec3::UnitZ()).norm(), 0, 1e-15);
  s = box->query({-1, -3, -4}, 9);  // corner, (1, 2, 2) away
  EXPECT_EQ(s->distance, 3);
  EXPECT_EQ(s->feature, Feature::vertex0);
  EXPECT_EQ(s->triangle, 0);
  EXPECT_NEAR(s->curvature.trace(), 2.0 / 3, 1e-15);
  EXPECT_EQ(box->query({1, 1, 1}, 0)->distance, -1);
  EXPECT_EQ(box->query({1, 1, 1}, 0)->normal, Vec3::UnitX());
  EXPECT_EQ(box->bounds().lo, Vec3(0, -1, -2));

  const auto torus = make_surface(TorusShape{{0, 0, 1}, {0, 0, 3}, 4, 1});
  EXPECT_NEAR(torus->query({4, 0, 1}, 1)->distance, -1, 1e-15);
  EXPECT_NEAR(torus->query({0, 0, 1}, 9)->distance, 3, 1e-15);
  EXPECT_NEAR(torus->query({0, 7, 5}, 9)->distance, 4, 1e-15);
  EXPECT_FALSE(torus->query({0, 0, 1}, 2.9));
  EXPECT_EQ(torus->bounds().hi, Vec3(5, 5, 2));
  // Principal curvatures on the outer and inner equator: 1/a and 1/(R + a), -1/(R - a).
  EXPECT_NEAR(torus->query({5, 0, 1}, 1)->curvature.trace(), 1 + 1.0 / 5, 1e-14);
  EXPECT_NEAR(torus->query({3, 0, 1}, 1)->curvature.trace(), 1 - 1.0 / 3, 1e-14);

  const auto capsule = make_surface(CapsuleShape{{0, 0, 0}, {4, 0, 0}, 0.5});
  EXPECT_NEAR(capsule->query({2, 0, 2}, 9)->distance, 1.5, 1e-15);
  EXPECT_EQ(capsule->query({2, 0, 2}, 9)->triangle, 0);
  EXPECT_NEAR(capsule->query({7, 0, 4}, 9)->distance, 4.5, 1e-15);
  EXPECT_EQ(capsule->query({7, 0, 4}, 9)->triangle, 2);
  EXPECT_EQ(capsule->query({-1, 0, 0}, 9)->triangle, 1);
  EXPECT_EQ(capsule->bounds().lo, Vec3(-0.5, -0.5, -0.5));
  // A capsule of zero length is a sphere.
  const auto ball = make_surface(CapsuleShape{{1, 1, 1}, {1, 1, 1}, 0.5});
  EXPECT_NEAR(ball->query({1, 1, 3}, 9)->distance, 1.5, 1e-15);
}

TEST(GeometryPrimitives, RefusesShapesWithoutInside) {
  const Vec3 o = Vec3::Zero();
  EXPECT_THROW(make_surface(PlaneShape{o, o}), std::invalid_argument);
  EXPECT_THROW(make_surface(BoxShape{o, {1, 0, 1}, o}), std::invalid_argument);
  EXPECT_THROW(make_surface(SphereShape{o, 0}), std::invalid_argument);
  EXPECT_THROW(make_surface(CylinderShape{o, o, 1}), std::invalid_argument);
  EXPECT_THROW(make_surface(CapsuleShape{o, {1, 0, 0}, -1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TorusShape{o, o, 2, 1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TorusShape{o, {0, 0, 1}, 1, 1}), std::invalid_argument);
  const std::vector<Vec3> corner{o, {0, 0, 3}, {3, 0, 3}};
  EXPECT_NO_THROW(make_surface(TubeShape{corner, {1}, 0.2, 0.1}));
  EXPECT_THROW(make_surface(TubeShape{{o}, {}, 0.2, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{corner, {}, 0.2, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{corner, {1, 1}, 0.2, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{corner, {0.3}, 0.2, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{corner, {3.1}, 0.2, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{{o, {0, 0, 1}, {0, 0, 1}}, {1}, 0.2, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{corner, {1}, 0, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_surface(TubeShape{corner, {1}, 0.2, 0}), std::invalid_argument);
}

}  // namespace

}  // namespace hawser::geometry_primitives_test
