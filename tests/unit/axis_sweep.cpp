// Axes that pass through bodies within a step, against fine sampling.
#include "hawser/kernels/axis_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hawser/geometry/primitives.hpp"

namespace hawser::axis_sweep_test {
namespace {

constexpr double kRadius = 0.1;

auto field_of(const Surface& surface, int* asked = nullptr) {
  return [&surface, asked](const Vec3& x, double within, Vec3& normal) -> std::optional<double> {
    if (asked) ++*asked;
    const auto p = surface.query(x, within);
    if (!p) return std::nullopt;
    normal = p->normal;
    return p->distance;
  };
}

BezierAxis straight(const Vec3& a, const Vec3& b) { return BezierAxis::straight(a, b); }

TEST(AxisSweep, FindsWhatSamplingFinds) {
  BoxShape plate, block;
  plate.size = Vec3(1, 2, 0.02);
  plate.rotation = Vec3(0.3, -0.2, 0.5);
  block.size = Vec3(0.5, 0.6, 0.7);
  SphereShape ball;
  ball.radius = 0.3;
  const std::shared_ptr<const Surface> bodies[] = {make_surface(plate), make_surface(block),
                                                   make_surface(ball)};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vec = [&] { return Vec3(u(random), u(random), u(random)); };
  int through = 0, clear = 0;
  for (int i = 0; i < 1500; ++i) {
    const Surface& body = *bodies[i % 3];
    BezierAxis from = straight(Vec3(0, 0, 1.2) + vec(), Vec3(0, 0, 1.2) + vec());
    BezierAxis to = from;
    const Vec3 way = 2.5 * vec();
    for (size_t k = 0; k < 4; ++k) {
      from.b[k] += 0.2 * vec();
      to.b[k] += way + 0.3 * vec();
    }
    // `must` and `may` leave a margin on either side, because pieces of a radius are tested as a whole.
    bool must = false, may = false;
    for (int s = 0; s <= 120; ++s) {
      const double xi = s / 120.0;
      const Vec3 y0 = from.point(xi);
      const Vec3 y1 = to.point(xi);
      const auto d0 = body.query(y0, 1e9);
      const auto d1 = body.query(y1, 1e9);
      for (int t = 1; t < 120; ++t) {
        const double d = body.query(y0 + t / 120.0 * (y1 - y0), 1e9)->distance;
        must |= d < 0.1 * kRadius && std::min(d0->distance, d1->distance) > 2 * kRadius;
        may |= d < 0.5 * kRadius;
      }
    }
    const bool found = passes_through(field_of(body), from, to, kRadius);
    EXPECT_TRUE(found || !must) << i;
    EXPECT_TRUE(may || !found) << i;
    through += must;
    clear += !may;
  }
  printf("  %d go through, %d are clear of it\n", through, clear);
  EXPECT_GT(through, 100);
  EXPECT_GT(clear, 100);
}

// Bodies far smaller than the axis and its displacement.
TEST(AxisSweep, MissesNothingThatIsSmall) {
  BoxShape bar;
  bar.size = Vec3(0.02, 3, 0.01);
  const auto surface = make_surface(bar);
  for (double x = -0.4; x < 20; x += 0.37) {
    const BezierAxis from = straight(Vec3(-20 + x, 0, 3), Vec3(x, 0.2, 4));
    const BezierAxis to = straight(Vec3(-20 + x, 0, -5), Vec3(x, 0, -2));
    EXPECT_EQ(passes_through(field_of(*surface), from, to, kRadius), x > 0) << x;
  }
}

TEST(AxisSweep, LetsPassWhatSlidesTouchesAndIsPressedIn) {
  BoxShape floor;
  floor.centre = Vec3(0, 0, -1);
  floor.size = Vec3(50, 50, 2);
  const auto surface = make_surface(floor);
  const auto moved = [&](double z0, double z1, double along) {
    int asked = 0;
    const bool found =
        passes_through(field_of(*surface, &asked), straight(Vec3(-1, 0, z0), Vec3(1, 0, z0)),
                       straight(Vec3(-1 + along, along, z1), Vec3(1 + along, along, z1)), kRadius);
    EXPECT_LT(asked, 600);
    return found;
  };
  EXPECT_FALSE(moved(kRadius, kRadius, 0.3));  // slides
  EXPECT_FALSE(moved(0.6 * kRadius, 0.6 * kRadius, 0.3));
  EXPECT_FALSE(moved(0.3 * kRadius, 0.3 * kRadius, 3));
  EXPECT_FALSE(moved(1, 0.1 * kRadius, 0));   // pressed in, nearest to its own side
  EXPECT_FALSE(moved(1, -0.1 * kRadius, 0));  // deep, which another check reports
  EXPECT_FALSE(moved(-0.01, 1, 0));           // moves out
}

// The axis ends a fifth of a radius behind a bar that is far thinner than the line.
TEST(AxisSweep, FindsAThinBarAnywhereAlongTheAxis) {
  BoxShape bar;
  bar.size = Vec3(0.002, 3, 0.002);
  for (double x = -0.9; x < 0.9; x += 0.037) {
    bar.centre = Vec3(x, 0, 0);
    const auto surface = make_surface(bar);
    const double from = kRadius, to = -0.2 * kRadius;
    EXPECT_TRUE(passes_through(field_of(*surface), straight(Vec3(-1, 0, from), Vec3(1, 0, from)),
                               straight(Vec3(-1, 0, to), Vec3(1, 0, to)), kRadius))
        << x;
  }
}

// A corner touches at exactly one place: after a slight penetration the axis might leave on the other side.
TEST(AxisSweep, WhatIsPressedInDoesNotComeOutBehind) {
  BoxShape plate;
  plate.size = Vec3(0.05, 10, 10);
  const auto surface = make_surface(plate);
  const auto found = [&](double x0, double x1, double along, bool pressed) {
    const Vec3 from(x0, 0, 0);
    const Vec3 to(x1, along, 0);
    return passes_through(field_of(*surface), straight(from, from), straight(to, to), 0.002, pressed);
  };
  for (const double x0 : {-0.0249, -0.0254, -0.02}) {
    EXPECT_TRUE(found(x0, 0.04, 0.1, true)) << x0;    // out on the back
    EXPECT_TRUE(found(x0, 0.01, 0, true)) << x0;      // inside, nearer to the back
    EXPECT_FALSE(found(x0, -0.01, 0.1, true)) << x0;  // deeper
    EXPECT_FALSE(found(x0, -0.04, 0.1, true)) << x0;  // out on the front
    EXPECT_FALSE(found(x0, 0.04, 0.1, false)) << x0;  // another check has reported this depth
  }
  EXPECT_TRUE(found(-0.04, 0.04, 0.1, true));
}

TEST(AxisSweep, AWayOfARadiusGoesThroughNothing) {
  BoxShape plate;
  plate.size = Vec3(1, 1, 1e-3);
  const auto surface = make_surface(plate);
  int asked = 0;
  EXPECT_FALSE(passes_through(field_of(*surface, &asked), straight(Vec3(-1, 0, 0.049), Vec3(1, 0, 0.049)),
                              straight(Vec3(-1, 0, -0.05), Vec3(1, 0, -0.05)), kRadius));
  EXPECT_EQ(asked, 0);
  EXPECT_TRUE(passes_through(field_of(*surface), straight(Vec3(-1, 0, 0.06), Vec3(1, 0, 0.06)),
                             straight(Vec3(-1, 0, -0.06), Vec3(1, 0, -0.06)), kRadius));
}

}  // namespace
}  // namespace hawser::axis_sweep_test
