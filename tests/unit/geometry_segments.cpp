// Closest points of two segments against an independent solution in quadruple precision.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "hawser/geometry/extended_precision.hpp"
#include "hawser/geometry/segment_distance.hpp"
#include "hawser/math/triple.hpp"

namespace hawser::geometry_segments_test {
namespace {

using detail::Extended;

// Minimum over the square of parameters, from its stationary point (normal equations) and its four edges, in
// 113 bits.
double reference(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const auto A0 = triple<Extended>(a0);
  const auto B0 = triple<Extended>(b0);
  const auto u = triple<Extended>(a1) - A0;
  const auto v = triple<Extended>(b1) - B0;
  const auto r = A0 - B0;
  const Extended a = u.dot(u);
  const Extended b = u.dot(v);
  const Extended c = v.dot(v);
  const Extended d = u.dot(r);
  const Extended e = v.dot(r);
  const auto clamp = [](Extended x) { return x < 0 ? Extended(0) : x > 1 ? Extended(1) : x; };
  Extended best = -1;
  const auto take = [&](Extended s, Extended t) {
    const auto w = r + s * u - t * v;
    const Extended q = w.dot(w);
    if (best < 0 || q < best) best = q;
  };
  for (int i = 0; i < 2; ++i) {
    take(Extended(i), c > 0 ? clamp((e + Extended(i) * b) / c) : Extended(0));
    take(a > 0 ? clamp((Extended(i) * b - d) / a) : Extended(0), Extended(i));
  }
  const Extended det = a * c - b * b;
  if (det > 0) {
    // t by projection, because the error of s would be amplified if the segments are nearly parallel.
    const Extended s = (b * e - c * d) / det;
    const Extended t = (e + s * b) / c;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) take(s, t);
  }
  // Square root in the range of double, for any magnitude.
  Extended scale = 1;
  while (best > 0 && best * scale < Extended(1e-30)) scale *= Extended(1e20);
  while (best * scale > Extended(1e30)) scale /= Extended(1e20);
  return std::sqrt(static_cast<double>(best * scale)) / std::sqrt(static_cast<double>(scale));
}

double size_of(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  return std::max({(a1 - a0).stableNorm(), (b1 - b0).stableNorm(), (a0 - b0).stableNorm()});
}

// Checks all guarantees for a pair of segments; returns the error of the distance relative to their size.
double check(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const SegmentPair p = closest_points_of_segments(a0, a1, b0, b1);
  const double size = size_of(a0, a1, b0, b1);
  const double far = std::max({a0.cwiseAbs().maxCoeff(), a1.cwiseAbs().maxCoeff(), b0.cwiseAbs().maxCoeff(),
                               b1.cwiseAbs().maxCoeff()});
  EXPECT_TRUE(p.s >= 0 && p.s <= 1 && p.t >= 0 && p.t <= 1) << p.s << " " << p.t;
  EXPECT_LE((p.on_a - (a0 + p.s * (a1 - a0))).norm(), 1e-15 * far);
  EXPECT_LE((p.on_b - (b0 + p.t * (b1 - b0))).norm(), 1e-15 * far);
  EXPECT_LE((p.on_a - p.on_b - p.difference).norm(), 4e-15 * far);
  EXPECT_NEAR(p.difference.stableNorm(), p.distance, 1e-15 * size);
  const SegmentPair q = closest_points_of_segments(b0, b1, a0, a1);
  EXPECT_TRUE(p.s == q.t && p.t == q.s && p.distance == q.distance && p.difference == -q.difference &&
              p.on_a == q.on_b && p.on_b == q.on_a)
      << "not symmetric";
  return size > 0 ? std::abs(p.distance - reference(a0, a1, b0, b1)) / size : p.distance;
}

class Random {
 public:
  explicit Random(unsigned seed) : gen_(seed) {}
  double operator()() { return uniform_(gen_); }  // in [-1, 1]
  Vec3 vec() { return {(*this)(), (*this)(), (*this)()}; }
  Vec3 unit() { return vec().normalized(); }
  double power(double lo, double hi) { return std::pow(10.0, lo + (hi - lo) * 0.5 * ((*this)() + 1)); }
  int pick(int n) { return static_cast<int>(gen_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 gen_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

constexpr double kTolerance = 1e-14;

TEST(GeometrySegments, AnyTwo) {
  Random next(1);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 shift = i % 2 ? Vec3(100 * next.vec()) : Vec3::Zero();
    const double scale = next.power(-2, 2);
    const Vec3 a0 = shift + next.vec();
    const Vec3 a1 = shift + next.vec();
    const Vec3 b0 = shift + next.vec();
    const Vec3 b1 = b0 + scale * next.vec();
    const double error = check(a0, a1, b0, b1);
    worst = std::max(worst, error);
    ASSERT_LE(error, kTolerance) << "case " << i;
  }
  RecordProperty("worst", std::to_string(worst));
}

// Nearly parallel segments, at angles and offsets of all magnitudes; Eberly's failures are at angles of 1e-7
// to 1e-6.
TEST(GeometrySegments, NearlyParallel) {
  Random next(2);
  for (int i = 0; i < 150000; ++i) {
    const double angle = i % 3 ? next.power(-7, -6) : next.power(-17, -3);
    const Vec3 u = next.unit();
    const Vec3 across = u.cross(next.unit()).normalized();
    const Vec3 v =
        next.power(-1, 1) * (u + angle * across + angle * next() * next.unit()) * (next.pick(2) ? 1 : -1);
    // The segments cross, both in their interior, at a distance `gap` normal to both.
    const double gap = next.pick(3) ? next.power(-12, 1) : 0;
    const Vec3 meet = 10 * next.vec();
    const Vec3 off = gap * u.cross(v).normalized();
    const double s = 1.2 * next();
    const double t = 1.2 * next();
    const Vec3 a0 = meet + s * u;
    const Vec3 b0 = meet + t * v + off;
    const double error = check(a0, a0 + u, b0, b0 + v);
    ASSERT_LE(error, kTolerance) << "case " << i << " angle " << angle << " gap " << gap;
  }
}

// Integer coordinates produce parallel, collinear, touching and degenerate segments exactly.
TEST(GeometrySegments, OnAGrid) {
  Random next(3);
  int parallel = 0, points = 0;
  const auto corner = [&] { return Vec3(next.pick(4), next.pick(4), next.pick(3)); };
  for (int i = 0; i < 100000; ++i) {
    const Vec3 a0 = corner();
    const Vec3 a1 = next.pick(8) ? corner() : a0;
    const Vec3 b0 = corner();
    const Vec3 b1 = next.pick(8) ? corner() : b0;
    parallel += (a1 - a0).cross(b1 - b0).isZero(0);
    points += a0 == a1 || b0 == b1;
    ASSERT_LE(check(a0, a1, b0, b1), kTolerance) << "case " << i;
  }
  EXPECT_GT(parallel, 10000);
  EXPECT_GT(points, 10000);
}

TEST(GeometrySegments, KnownAnswers) {
  // Crossing at right angles, 2 apart.
  SegmentPair p = closest_points_of_segments({-1, 0, 0}, {3, 0, 0}, {0, -1, 2}, {0, 1, 2});
  EXPECT_EQ(p.s, 0.25);
  EXPECT_EQ(p.t, 0.5);
  EXPECT_EQ(p.distance, 2);
  EXPECT_EQ(p.difference, Vec3(0, 0, -2));
  // Interior point and end; end and end.
  p = closest_points_of_segments({0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {1, 7, 0});
  EXPECT_EQ(p.s, 0.25);
  EXPECT_EQ(p.t, 0);
  EXPECT_EQ(p.distance, 3);
  p = closest_points_of_segments({0, 0, 0}, {1, 0, 0}, {4, 4, 0}, {5, 9, 0});
  EXPECT_EQ(p.s, 1);
  EXPECT_EQ(p.t, 0);
  EXPECT_EQ(p.distance, 5);
  // Parallel: the middle of the overlap, for either orientation.
  for (const bool turned : {false, true}) {
    const Vec3 b0(2, 1, 0), b1(8, 1, 0);
    p = closest_points_of_segments({0, 0, 0}, {4, 0, 0}, turned ? b1 : b0, turned ? b0 : b1);
    EXPECT_LE((p.on_a - Vec3(3, 0, 0)).norm(), 1e-15);
    EXPECT_LE((p.on_b - Vec3(3, 1, 0)).norm(), 1e-15);
    EXPECT_EQ(p.distance, 1);
  }
  // Collinear and apart; collinear and overlapping.
  p = closest_points_of_segments({0, 0, 0}, {1, 1, 0}, {4, 4, 0}, {3, 3, 0});
  EXPECT_NEAR(p.distance, 2 * std::sqrt(2), 1e-15);
  EXPECT_EQ(p.on_b, Vec3(3, 3, 0));
  EXPECT_LE(closest_points_of_segments({0, 0, 0}, {2, 2, 0}, {4, 4, 0}, {1, 1, 0}).distance, 1e-15);
  // Segments of zero length.
  EXPECT_EQ(closest_points_of_segments({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}).distance, 0);
  p = closest_points_of_segments({1, 2, 2}, {1, 2, 2}, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(p.distance, 3);
  p = closest_points_of_segments({1, 5, 0}, {1, 5, 0}, {0, 0, 0}, {4, 0, 0});
  EXPECT_EQ(p.t, 0.25);
  EXPECT_EQ(p.distance, 5);
}

// Distances by exact rational arithmetic on the stored coordinates. The first two are examples of Eberly,
// "Robust computation of distance between line segments" (Geometric Tools), where the usual formula is wrong
// in the seventh digit; his values agree. The others are degenerate.
TEST(GeometrySegments, ExactRationals) {
  struct Case {
    Vec3 a0, a1, b0, b1;
    double distance;
  };
  const std::vector<Case> cases = {
      {{-1.0896217473782599, 9.7236145595088601e-007, 0},
       {0.91220578597858548, -9.4369829432107506e-007, 0},
       {-0.90010447502136237, 9.0671446351334441e-007, 0},
       {1.0730877178721130, -9.8185787633992740e-007, 0},
       1.157504613857410516892517e-7},
      {{0.77998990099877119, 0.61192502360790968, -0.22703111823648214},
       {0.53215344529598951, 0.85724585503339767, -0.10102437809109688},
       {-0.21277333982288837, 0.35091548087075233, -0.49557160679250956},
       {0.11881479667499661, 0.022494725417345293, -0.66426620958372623},
       0.9829239711648878897479886},
      {{0, 0, 0}, {1, 2, 2}, {3, 1, -1}, {3, 1, -1}, 3.162277660168379331998894},  // a point
      {{0, 0, 0}, {1, 0, 0}, {2, 3, 6}, {2, 3, 6}, 6.782329983125268139064556},    // a point
      {{0, 0, 0}, {4, 2, 0}, {2, 1, 3}, {10, 5, 3}, 3},                            // parallel, overlapping
      {{1, 1, 1}, {3, 3, 3}, {5, 5, 5}, {9, 9, 9}, 3.464101615137754587054893},    // on one line, apart
      {{0, 0, 0}, {3, 0, 0}, {1, -2, 1}, {2, 5, 1}, 1},                            // crossing
      {{0, 0, 0}, {1, 2, 3}, {7, 5, 1}, {2, 2, 2}, 1.309307341415954287596585},    // end to inside
      {{0, 0, 0}, {10, 0, 0}, {2, 3, 0}, {5, 1, 4}, 2.683281572999747635691008},   // inside to inside
      {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.7}, {0.2, 0.4, 0.6}, {0.5, 0.7, 1.0}, 0.1014599312391784832318718},
  };
  for (const Case& c : cases) {
    EXPECT_LE(check(c.a0, c.a1, c.b0, c.b1), kTolerance);
    EXPECT_NEAR(closest_points_of_segments(c.a0, c.a1, c.b0, c.b1).distance, c.distance, 1e-14);
  }
}

// If the segments cross at an angle, the parameters are right as well.
TEST(GeometrySegments, Parameters) {
  Random next(4);
  for (int i = 0; i < 100000; ++i) {
    const Vec3 u = next.unit();
    const Vec3 across = u.cross(next.unit()).normalized();
    const double angle = next.power(-6, 0);
    const Vec3 v = std::cos(angle) * u + std::sin(angle) * across;
    const Vec3 n = u.cross(across);
    const double s = 0.5 + 0.4 * next();
    const double t = 0.5 + 0.4 * next();
    const double gap = next.power(-6, 0);
    const SegmentPair p =
        closest_points_of_segments(-s * u, (1 - s) * u, gap * n - t * v, gap * n + (1 - t) * v);
    ASSERT_NEAR(p.s, s, 1e-14 / angle + 1e-15 * gap / (angle * angle));
    ASSERT_NEAR(p.t, t, 1e-14 / angle + 1e-15 * gap / (angle * angle));
    ASSERT_NEAR(p.distance, gap, 1e-14);
  }
}

// Very large, very small and very different lengths.
TEST(GeometrySegments, Scales) {
  Random next(5);
  for (int i = 0; i < 50000; ++i) {
    const double scale = next.pick(2) ? next.power(-150, 150) : next.pick(2) ? next.power(-80, -50) : 1;
    const double la = next.pick(3) ? next.power(-30, 0) : 1;
    const double lb = next.pick(3) ? next.power(-200, 0) : 1;
    const Vec3 a0 = next.vec();
    const Vec3 b0 = next.vec();
    const Vec3 a1 = a0 + la * next.vec();
    const Vec3 b1 = b0 + lb * next.vec();
    const SegmentPair p = closest_points_of_segments(scale * a0, scale * a1, scale * b0, scale * b1);
    const double size = scale * size_of(a0, a1, b0, b1);
    ASSERT_TRUE(std::isfinite(p.distance) && p.on_a.allFinite() && p.on_b.allFinite());
    ASSERT_LE(std::abs(p.distance - reference(scale * a0, scale * a1, scale * b0, scale * b1)), 1e-14 * size)
        << "case " << i << " scale " << scale;
  }
}

}  // namespace

}  // namespace hawser::geometry_segments_test
