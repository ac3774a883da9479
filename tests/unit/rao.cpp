// Vessel motion from response amplitude operators: interpolation, phases, headings, against closed forms.
#include "hawser/kernels/rao.hpp"

#include <gtest/gtest.h>

namespace hawser::rao_test {
namespace {

Response heave_of(double amplitude, double lag) {
  Response r{};
  r[2] = std::polar(amplitude, -lag);
  return r;
}

TEST(Rao, InterpolatesInTheComplexPlane) {
  const double deg = M_PI / 180;
  const RaoTable t({{0.5, 0, heave_of(1, 0)},
                    {1.0, 0, heave_of(0.5, 90 * deg)},
                    {0.5, 270 * deg, heave_of(2, 0)},
                    {1.0, 270 * deg, heave_of(3, 0)}});
  EXPECT_NEAR(std::abs(t.at(0.5, 0)[2] - std::complex<double>(1, 0)), 0, 1e-14);
  EXPECT_NEAR(std::abs(t.at(0.75, 0)[2] - std::complex<double>(0.5, -0.25)), 0, 1e-14);
  EXPECT_NEAR(std::abs(t.at(0.1, 0)[2] - std::complex<double>(1, 0)), 0,
              1e-14);  // beyond the ends of the table
  EXPECT_NEAR(std::abs(t.at(9, 0)[2] - std::complex<double>(0, -0.5)), 0, 1e-14);
  // A table all around: from 270 to 360 deg, and from 360 to 0 to 270 across the gap.
  EXPECT_NEAR(std::abs(t.at(0.5, -45 * deg)[2] - 1.5), 0, 1e-12);
  EXPECT_NEAR(std::abs(t.at(0.5, 135 * deg)[2] - 1.5), 0, 1e-12);
  EXPECT_NEAR(std::abs(t.at(0.5, 360 * deg)[2] - 1.0), 0, 1e-12);
  EXPECT_THROW(RaoTable({{0.5, 0, heave_of(1, 0)}, {0.6, 1, heave_of(1, 0)}}), std::invalid_argument);
  EXPECT_THROW(RaoTable({{0.5, 0, heave_of(1, 0)}, {0.5, 2 * M_PI, heave_of(1, 0)}}), std::invalid_argument);
  EXPECT_THROW(RaoTable(std::vector<RaoTable::Row>{}), std::invalid_argument);
}

WaveField wave(double amplitude, double omega, double direction, double phase) {
  WaveComponent c;
  c.amplitude = amplitude;
  c.omega = omega;
  c.phase = phase;
  c.x = std::cos(direction);
  c.y = std::sin(direction);
  return WaveField({c}, 0, 9.80665, Stretching::none);
}

// Heave of 1 in phase equals the elevation at the vessel; with a lag of a quarter of a period it equals the
// elevation a quarter of a period before.
TEST(Rao, PhaseIsALagAfterTheCrestAtTheOrigin) {
  const Vec3 origin(30, -12, 5);
  const WaveField w = wave(1.5, 0.7, 0.9, 0.4);
  for (const double lag : {0.0, M_PI / 2}) {
    const RaoMotion m(RaoTable({{0.7, 0, heave_of(1, lag)}}), w, origin, 0.3);
    for (double t = 0; t < 20; t += 1.7) {
      Vec3 x, r;
      m.at(t, x, r);
      EXPECT_NEAR(x.z(), w.at({30, -12, 0}, t - lag / 0.7).surface, 1e-12);
      EXPECT_NEAR(x.head<2>().norm() + r.norm(), 0, 1e-12);
    }
  }
}

// Rows equal at() at their times.
TEST(Rao, RowsAreTheMotionAtTheirTimes) {
  std::vector<RaoTable::Row> rows;
  for (const double omega : {0.3, 0.8, 1.5})
    for (const double direction : {0.0, 2.0, 4.0}) {
      Response r{};
      for (size_t k = 0; k < 6; ++k)
        r[k] = std::polar(omega + 0.1 * static_cast<double>(k), direction + static_cast<double>(k));
      rows.push_back({omega, direction, r});
    }
  for (const double omega : {0.41, 0.77, 1.9}) {
    const RaoMotion m(RaoTable(rows), wave(1.5, omega, 0.9, 0.4), Vec3(300, -120, 5), 0.3, 0.1);
    const Vec3 drifted(20, -7, 0);
    std::vector<Vec3> offset, rotation;
    m.rows(-1.3, 0.21, 2000, drifted, offset, rotation);
    ASSERT_EQ(offset.size(), 2000u);
    ASSERT_EQ(rotation.size(), 2000u);
    for (size_t i = 0; i < 2000; ++i) {
      Vec3 x, r;
      m.at(-1.3 + 0.21 * static_cast<double>(i), x, r, drifted);
      EXPECT_LT((x - offset[i]).norm() + (r - rotation[i]).norm(), 1e-12) << i;
    }
  }
}

// Surge and roll are along the bow, and the wave direction is relative to it.
TEST(Rao, TurnsWithTheHeading) {
  const double heading = 2.1;
  Response ahead{}, abeam{};
  ahead[0] = 1;
  abeam[1] = 2;
  abeam[3] = 0.1;
  const RaoTable t({{0.7, 0, ahead}, {0.7, M_PI / 2, abeam}, {0.7, M_PI, ahead}, {0.7, 1.5 * M_PI, abeam}});
  const Vec3 bow(std::cos(heading), std::sin(heading), 0);
  const Vec3 port(-std::sin(heading), std::cos(heading), 0);
  Vec3 x, r;
  RaoMotion(t, wave(1, 0.7, heading, 0), Vec3::Zero(), heading).at(0, x, r);
  EXPECT_LT((x - bow).norm() + r.norm(), 1e-12);
  RaoMotion(t, wave(1, 0.7, heading + M_PI / 2, 0), Vec3::Zero(), heading).at(0, x, r);
  EXPECT_LT((x - 2 * port).norm() + (r - 0.1 * bow).norm(), 1e-12);
}

// A wave from the other side is a mirror image: port becomes starboard. Directions along the vessel have a
// single row.
TEST(Rao, OtherSideIsAMirror) {
  const double deg = M_PI / 180;
  std::vector<RaoTable::Row> rows;
  for (const double direction : {0.0, 60.0, 120.0, 180.0}) {
    Response r;
    for (size_t k = 0; k < 6; ++k)
      r[k] = std::polar(0.3 + 0.1 * static_cast<double>(k), 0.2 * direction * deg + static_cast<double>(k)) *
             (k % 2 ? std::sin(direction * deg) : 1);  // no sway in waves along the vessel
    rows.push_back({0.7, direction * deg, r});
  }
  const auto both = with_other_side(rows);
  EXPECT_EQ(both.size(), 6U);
  const RaoTable t(both);
  const Vec3 origin(30, 0, 0);
  for (const double direction : {25.0, 60.0, 90.0, 140.0})
    for (const double time : {0.0, 3.0}) {
      Vec3 x[2], turn[2];
      for (const int side : {0, 1})
        RaoMotion(t, wave(1.5, 0.7, (side ? -direction : direction) * deg, 0.4), origin, 0)
            .at(time, x[side], turn[side]);
      EXPECT_LT((x[1] - Vec3(x[0].x(), -x[0].y(), x[0].z())).norm(), 1e-12) << direction;
      EXPECT_LT((turn[1] - Vec3(-turn[0].x(), turn[0].y(), -turn[0].z())).norm(), 1e-12) << direction;
      EXPECT_GT(std::abs(turn[0].x()), 1e-3);
    }
}

TEST(Rao, HasTheDirectionsBesideOne) {
  const double deg = M_PI / 180;
  const RaoTable t(
      {{0.5, 0, heave_of(1, 0)}, {0.5, 90 * deg, heave_of(1, 0)}, {0.5, 180 * deg, heave_of(1, 0)}});
  const auto expect = [&](double direction, double from, double to) {
    const DirectionGap b = t.neighbours(direction * deg);
    EXPECT_NEAR(b.from / deg, from, 1e-9) << direction;
    EXPECT_NEAR(b.to / deg, to, 1e-9) << direction;
  };
  expect(30, 0, 90);
  expect(90, 90, 90);
  expect(-270, 90, 90);
  expect(200, 180, 360);
  expect(-10, 180, 360);
  expect(360, 0, 0);
  const RaoTable one({{0.5, 30 * deg, heave_of(1, 0)}});
  EXPECT_EQ(one.neighbours(2).from, one.neighbours(2).to);
}

}  // namespace
}  // namespace hawser::rao_test
