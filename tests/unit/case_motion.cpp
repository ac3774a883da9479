// Motion tables in a case: interpolation between rows, and notes about overshoot.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::case_motion_test {
namespace {

model::Case read(const std::string& table, const std::string& more = "") {
  return io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{chain: {{outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}}}}
bodies: {{ship: {{motion: {{table: {{{}}}{}}}}}}}
lines:
  mooring: {{sections: [{{type: chain, length: 120, elements: 12}}], end_a: {{anchor: [100, 0, -50]}}, end_b: {{body: ship, at: [0, 0, 0]}}}}
dynamics: {{duration: 6}}
)",
                                        table, more),
                            "/nowhere/case.yaml");
}

// A winch that pulls 2 m in two seconds and stops.
const std::string kRows =
    "rows: [[0, 0, 0, 0, 0, 0, 0], [2, 0, 0, 0, 0, 0, 0], [4, 0, 0, 2, 0, 0, 10], [6, 0, 0, 2, 0, 0, 10], "
    "[8, 0, 0, 2, 0, 0, 10]]";

TEST(CaseMotion, OvershootOfASplineIsReported) {
  const model::Case c = read(kRows);
  // The second note is about the velocity at the start of the spline.
  ASSERT_EQ(c.notes.size(), 2U);
  EXPECT_NE(c.notes[1].find("starts at t = 0 with 0.339 m/s"), std::string::npos) << c.notes[1];
  const std::string& note = c.notes[0];
  EXPECT_NE(note.find("bodies.ship.motion.table: between its rows at "), std::string::npos) << note;
  EXPECT_NE(note.find(" s the spline takes z to "), std::string::npos) << note;
  EXPECT_NE(note.find(" % of what the rows span) beyond both, and so in "), std::string::npos) << note;
  EXPECT_NE(note.find("; if the body does not do that, give more rows there or 'interpolation: monotone'"),
            std::string::npos)
      << note;
  const auto& t = std::get<model::TableMotion>(c.bodies[0].motion);
  double value = 0, time = 0, by = 0;
  ASSERT_EQ(std::sscanf(note.c_str() + note.find("takes z to "), "takes z to %lf m at %lf s, %lf m", &value,
                        &time, &by),
            3)
      << note;
  const double there = RowCurve(t.time, t.offset).at(time).value.z();
  EXPECT_NEAR(there, value, 1e-3);
  EXPECT_NEAR(by, value > 2 ? value - 2 : -value, 1e-3);
  EXPECT_GT(by, 0.1);
}

TEST(CaseMotion, MonotoneAndLinearStayBetweenTheRows) {
  for (const char* word : {"monotone", "linear"}) {
    const model::Case c = read(kRows + ", interpolation: " + word);
    EXPECT_TRUE(c.notes.empty()) << c.notes[0];
    const RigidMotion m = model::rigid_motion(c.bodies[0]);
    for (double t = 0; t < 6; t += 0.1) {
      EXPECT_GE(m.at(t).position.z(), -1e-14);
      EXPECT_LE(m.at(t).position.z(), 2 + 1e-14);
    }
  }
  const model::Case linear = read(kRows + ", interpolation: linear");
  EXPECT_NEAR(model::rigid_motion(linear.bodies[0]).at(2.5).position.z(), 0.5, 1e-14);
  EXPECT_NE(model::summary(linear).find("straight lines between them"), std::string::npos);
  // Waves with a dozen rows per period give no overshoot note.
  std::string rows;
  for (int i = 0; i <= 24; ++i)
    rows += fmt::format("{}[{}, 0, 0, {}]", i ? ", " : "", 0.5 * i, std::sin(2 * M_PI * i / 12.));
  for (const std::string& note : read("rows: [" + rows + "]").notes)
    EXPECT_EQ(note.find("between its rows"), std::string::npos) << note;
  try {
    read(kRows + ", interpolation: cubic");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(
        std::string(e.what()).find("bodies.ship.motion.table.interpolation: expected 'spline', 'monotone' "
                                   "or 'linear', found 'cubic'"),
        std::string::npos)
        << e.what();
  }
}

// Rows far from the start do not affect it.
TEST(CaseMotion, PoseAtStartIsThatOfTheWholeTable) {
  for (const BetweenRows between : {BetweenRows::spline, BetweenRows::monotone, BetweenRows::linear})
    for (const double from : {-300.0, -7.5, 0.0}) {
      model::TableMotion t;
      t.between = between;
      double time = from;
      for (int i = 0; i < 1000; ++i) {
        t.time.push_back(time);
        time += i % 3 == 0 ? 0.2 : 0.9;
        t.offset.emplace_back(std::sin(1.7 * i), std::cos(2.3 * i), std::sin(0.4 * i * i));
        t.rotation.emplace_back(0.1 * t.offset.back());
      }
      model::Body b;
      b.position = Vec3(3, 4, 5);
      b.rotation = Vec3(0.1, 0.2, 0.3);
      b.motion = t;
      b.drift.emplace();
      b.drift->offset = Vec3(1, 0, 2);
      b.drift->table = t;
      b.drift->harmonic.amplitude = Vec3(1, 2, 0);
      b.drift->harmonic.phase = Vec3(1, 1, 0);
      const RigidPose whole = model::rigid_motion(b).at(0);
      const RigidPose near = model::pose_at_start(b);
      EXPECT_LT((whole.position - near.position).norm(), 1e-14) << from;
      EXPECT_LT((whole.velocity - near.velocity).norm(), 1e-13) << from;
      EXPECT_LT((whole.rotation.coeffs() - near.rotation.coeffs()).norm(), 1e-15) << from;
      EXPECT_GT((whole.position - b.position).norm(), 0.1);
    }
}

TEST(CaseMotion, VelocityJumpsAtTheRowsOfStraightLines) {
  EXPECT_TRUE(model::velocity_jumps(read(kRows).bodies).empty());
  const std::string drift =
      ", drift: {table: {rows: [[-1, 0, 0, 0], [3, 0, 0, 1], [6, 0, 0, 1]], interpolation: linear}}";
  const std::vector<double> both{-1, 0, 2, 3, 4, 6, 8};
  EXPECT_EQ(model::velocity_jumps(read(kRows + ", interpolation: linear", drift).bodies), both);
}

}  // namespace
}  // namespace hawser::case_motion_test
