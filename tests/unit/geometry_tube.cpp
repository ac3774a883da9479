// Tubes: axis of legs and arcs; the distance is C1 along the axis and over the rims; Taylor expansion; legs
// and arcs against closed forms; tubes that touch themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "hawser/geometry/primitives.hpp"

namespace hawser::geometry_tube_test {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// Not in one plane: a J, then a bend to the side, then a bend of 60 degrees upwards. The second bend begins
// where the first one ends.
TubeShape winding() {
  return {{{0, 0, 8}, {0, 0, -4}, {5, 0, -4}, {5, 6, -4}, {5, 9, -4 + 3 * std::sqrt(3.0)}},
          {3, 2, 1.5},
          0.25,
          0.06};
}

class Random {
 public:
  double operator()() { return uniform_(gen_); }
  Vec3 vec() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937 gen_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

double whole(const std::vector<TubePiece>& pieces) {
  double length = 0;
  for (const TubePiece& p : pieces) length += p.length;
  return length;
}

// Place and unit tangent at the length s.
std::pair<Vec3, Vec3> at(const std::vector<TubePiece>& pieces, double s) {
  for (const TubePiece& p : pieces) {
    if (s <= p.length || &p == &pieces.back()) return {p.point(s), p.tangent(s)};
    s -= p.length;
  }
  return {};
}

TEST(GeometryTube, LegsAndArcsAreTangent) {
  const TubeShape shape = winding();
  const auto pieces = tube_pieces(shape);
  ASSERT_EQ(pieces.size(), 6U);  // leg, arc, arc, leg, arc, leg
  EXPECT_FALSE(pieces[0].arc());
  EXPECT_TRUE(pieces[1].arc() && pieces[2].arc() && pieces[4].arc());
  EXPECT_NEAR(pieces[0].length, 9, 1e-14);
  EXPECT_NEAR(pieces[1].length, 1.5 * M_PI, 1e-14);
  EXPECT_NEAR(pieces[4].turn(), M_PI / 3, 1e-14);
  for (size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double end = pieces[i].length;
    EXPECT_LE((pieces[i].point(end) - pieces[i + 1].from).norm(), 1e-14) << i;
    EXPECT_LE((pieces[i].tangent(end) - pieces[i + 1].direction).norm(), 1e-14) << i;
  }
  EXPECT_LE((at(pieces, whole(pieces)).first - shape.path.back()).norm(), 1e-14);
  // A corner that does not turn has no arc.
  EXPECT_EQ(tube_pieces({{{0, 0, 0}, {0, 0, 1}, {0, 0, 3}}, {0.5}, 0.1, 0.1}).size(), 2U);
}

// Distance and principal curvatures at points beside the axis: inside, in the wall and outside.
TEST(GeometryTube, DistanceBesideTheAxis) {
  const TubeShape shape = winding();
  const auto pieces = tube_pieces(shape);
  const auto tube = make_surface(shape);
  const double length = whole(pieces);
  const double middle = 0.28;
  const double half = 0.03;
  Random next;
  for (int i = 0; i < 5000; ++i) {
    const auto [x, t] = at(pieces, 0.5 * (next() + 1) * length);
    const Vec3 across = next.vec();
    const Vec3 e = (across - across.dot(t) * t).normalized();
    const double rho = 0.4 * (next() + 1.01);
    const auto s = tube->query(x + rho * e, kFar);
    ASSERT_TRUE(s);
    ASSERT_NEAR(s->distance, std::abs(rho - middle) - half, 1e-13);
    const double sign = rho < middle ? -1 : 1;
    ASSERT_LE((s->normal - sign * e).norm(), 1e-12 / rho);
    ASSERT_EQ(s->triangle % 2, rho < middle);
    ASSERT_LE((s->curvature * s->normal).norm(), 1e-10 / rho);
    const Vec3 around = t.cross(e);
    ASSERT_NEAR(around.dot(s->curvature * around), sign / rho, 1e-10 / rho);
  }
  // Curvature along the axis, on the outer and the inner side of the first bend (radius 3 m, centre at (3, 0,
  // -1)).
  const Vec3 out = Vec3(-1, 0, -1).normalized();
  const Vec3 along = Vec3(1, 0, -1).normalized();
  for (const double rho : {-0.31, -0.25, 0.25, 0.31}) {
    const auto s = tube->query(Vec3(3, 0, -1) + (3 + rho) * out, kFar);
    EXPECT_NEAR(s->distance, 0, 1e-14) << rho;
    const double sign = (rho > 0 ? 1 : -1) * (std::abs(rho) > 0.28 ? 1 : -1);
    EXPECT_NEAR(along.dot(s->curvature * along), sign / (3 + rho), 1e-13) << rho;
  }
}

// Second-order Taylor expansion at random points near the wall, half of them near a rim; the error decreases
// with the third power of the displacement.
TEST(GeometryTube, TaylorExpansion) {
  const TubeShape shape = winding();
  const auto pieces = tube_pieces(shape);
  const auto tube = make_surface(shape);
  const double length = whole(pieces);
  Random next;
  int checked = 0, rims = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool rim = i % 2 == 0;
    const double at_end = i % 4 == 0 ? 0 : length;
    const auto [x, t] = at(pieces, rim ? at_end : 0.5 * (next() + 1) * length);
    const Vec3 across = next.vec();
    const Vec3 e = (across - across.dot(t) * t).normalized();
    const Vec3 y = x + (0.28 + 0.15 * next()) * e + (rim ? 0.15 * next() : 0) * t;
    const Vec3 way = next.vec();
    const auto s = tube->query(y, kFar);
    const double bend = 1 / s->curvature.norm();
    const double h = 1e-3 * std::min(bend, 0.1);
    double error[2];
    bool same = true;
    for (int k = 0; k < 2; ++k) {
      const Vec3 d = (k ? 0.5 : 1) * h * way;
      const auto there = tube->query(y + d, kFar);
      same = same && there->triangle == s->triangle;
      error[k] = there->distance - s->distance - s->normal.dot(d) - 0.5 * d.dot(s->curvature * d);
    }
    if (!same) continue;
    ++checked;
    rims += s->triangle >= 2 * static_cast<int>(pieces.size());
    ASSERT_LE(std::abs(error[0]), 3 * h * h * h / (bend * bend) + 1e-15) << y.transpose();
    ASSERT_LE(std::abs(error[1]), 0.2 * std::abs(error[0]) + 1e-3 * h * h * h / (bend * bend) + 2e-15);
  }
  EXPECT_GT(checked, 19000);
  EXPECT_GT(rims, 3000);
}

// Distance and normal are continuous across the ends of legs and arcs and over the rims.
TEST(GeometryTube, SmoothAcrossTheEndsOfPieces) {
  const TubeShape shape = winding();
  const auto pieces = tube_pieces(shape);
  const auto tube = make_surface(shape);
  Random next;
  double s = 0;
  for (size_t i = 0; i <= pieces.size(); ++i) {
    const auto [x, t] = at(pieces, s);
    if (i < pieces.size()) s += pieces[i].length;
    for (int k = 0; k < 200; ++k) {
      const Vec3 across = next.vec();
      const Vec3 e = (across - across.dot(t) * t).normalized();
      const double rho = 0.28 + (k % 2 ? 1 : -1) * (0.02 + 0.1 * std::abs(next()));
      for (const double step : {1e-9, 1e-12, 1e-15, 0.0}) {
        const auto a = tube->query(x + rho * e - step * t, kFar);
        const auto b = tube->query(x + rho * e + step * t, kFar);
        ASSERT_NEAR(a->distance, b->distance, 1e-14 + 2 * step * 1e-6) << i;
        ASSERT_LE((a->normal - b->normal).norm(), 1e-12 + 200 * step) << i;
      }
    }
  }
}

// The rounded rim beyond an end, from all sides.
TEST(GeometryTube, RoundRims) {
  const auto tube = make_surface(TubeShape{{{0, 0, 0}, {0, 0, 5}}, {}, 0.25, 0.06});
  EXPECT_NEAR(tube->query({0.28, 0, -0.13}, 9)->distance, 0.1, 1e-15);
  EXPECT_NEAR(tube->query({0.28, 0, -0.03}, 9)->distance, 0, 1e-15);
  EXPECT_NEAR(tube->query({0, 0, -0.28}, 9)->distance, 0.28 * std::sqrt(2) - 0.03, 1e-15);
  EXPECT_NEAR(tube->query({0.31, 0.31, 5.2}, 9)->distance, std::hypot(0.31 * std::sqrt(2) - 0.28, 0.2) - 0.03,
              1e-15);
  EXPECT_NEAR(tube->query({0, 0.28, 5.01}, 9)->distance, -0.02, 1e-15);
  EXPECT_EQ(tube->query({0, 0.28, 5.01}, 9)->triangle, 4);
  EXPECT_EQ(tube->query({0, 0.28, -0.01}, 9)->triangle, 2);
  EXPECT_FALSE(tube->query({0, 0, 2.5}, 0.24));
  EXPECT_TRUE(tube->query({0, 0, 2.5}, 0.26));
}

// The distance to a hairpin is that to its nearest leg, and is Lipschitz continuous with constant 1.
TEST(GeometryTube, NearestOfSeveralLegs) {
  const TubeShape hairpin{{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {-1, 1, 0}}, {0.5}, 0.2, 0.1};
  ASSERT_FALSE(tube_touches_itself(hairpin));
  const auto tube = make_surface(hairpin);
  EXPECT_NEAR(tube->query({2, 0.4, 0}, 9)->distance, 0.1, 1e-15);
  EXPECT_NEAR(tube->query({2, 0.6, 0}, 9)->distance, 0.1, 1e-15);
  EXPECT_NEAR(tube->query({-0.5, 0.6, 0}, 9)->distance, 0.1, 1e-15);    // beyond the end of the first leg
  EXPECT_NEAR(tube->query({-0.05, 0.25, 0}, 9)->distance, 0.0, 1e-15);  // its rim
  Random next;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 y = Vec3(2, 0.5, 0) + Vec3(4, 1.5, 1).cwiseProduct(next.vec());
    const Vec3 z = y + std::pow(10.0, -3 * (next() + 1)) * next.vec();
    ASSERT_LE(std::abs(tube->query(y, kFar)->distance - tube->query(z, kFar)->distance),
              (y - z).norm() * (1 + 1e-14) + 1e-14)
        << y.transpose() << " to " << z.transpose();
  }
}

TEST(GeometryTube, TouchesItself) {
  const auto hairpin = [](double apart) {
    return TubeShape{{{0, 0, 0}, {4, 0, 0}, {4, apart, 0}, {-1, apart, 0}}, {0.5 * apart}, 0.2, 0.1};
  };
  EXPECT_FALSE(tube_touches_itself(hairpin(0.62)));
  // A path around a square back to its start, at a height `up` above it.
  const auto loop = [](double up) {
    return TubeShape{{{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {2, 5, up}, {2, -3, up}}, {1}, 0.2, 0.1};
  };
  EXPECT_FALSE(tube_touches_itself(loop(0.605)));
  const auto touch = tube_touches_itself(loop(0.595));
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->distance, 0.595, 1e-3);
  EXPECT_NEAR(touch->first, 2, 1e-12);
  // Tight bends and short consecutive legs do not count as contact.
  EXPECT_FALSE(tube_touches_itself(winding()));
  EXPECT_FALSE(tube_touches_itself({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}, {0.31}, 0.2, 0.1}));
}

// The facets for pictures are a closed mesh; those for hulls have the volume of the tube.
TEST(GeometryTube, FacetsAndVolume) {
  const TubeShape shape = winding();
  const TriangleMesh m = facets(shape, {});
  EXPECT_TRUE(inspect(m).valid());
  EXPECT_NEAR(inspect(m).volume / volume(shape), 1, 5e-3);
  EXPECT_NEAR(inspect(facets_of_volume(shape)).volume / volume(shape), 1, 1e-11);
  const TubeShape straight{{{0, 0, 0}, {0, 0, 5}}, {}, 0.25, 0.06};
  const double rims = M_PI * M_PI * 0.28 * 0.03 * 0.03 * 2;  // half a ring of 0.03 m at each end
  EXPECT_NEAR(volume(straight), M_PI * (0.31 * 0.31 - 0.25 * 0.25) * 5 + rims, 1e-14);
}

}  // namespace
}  // namespace hawser::geometry_tube_test
