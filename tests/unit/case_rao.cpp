// Vessel motion by response amplitude operators, from the case to the pose of the body.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/wave_components.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::case_rao_test {
namespace {

// Heave of 1 m/m in phase, pitch of 2 deg/m leading by a quarter of a period; heading 30 deg.
TEST(CaseRao, BodyFollowsTheWaves) {
  const std::string text = R"(
hawser: 1
environment:
  water: {depth: 100}
  waves: {regular: {height: 3, period: 9, direction_deg: 75}, ramp: 5}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}
bodies:
  ship:
    position: [40, -20, 3]
    rotation_deg: [0, 0, 30]
    motion: {rao: {phase: lead, rows: [[5, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 90, 0, 0], [20, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 90, 0, 0]]}}
lines:
  mooring:
    sections: [{type: chain, length: 120, elements: 12}]
    end_a: {anchor: [100, 0, -50]}
    end_b: {body: ship, at: [0, 0, 0]}
dynamics: {duration: 60}
)";
  const model::Case c = io::read_case_text(text, "/nowhere/case.yaml");
  const Bodies bodies(c.bodies);
  const WaveField w = model::wave_field(c.environment);
  const Vec3 side = Vec3(-std::sin(M_PI / 6), std::cos(M_PI / 6), 0);
  EXPECT_LT((bodies.pose(0, 0).position - Vec3(40, -20, 3)).norm(), 1e-12);  // start of the ramp
  for (double t = 5.5; t < 60; t += 1.3) {
    const RigidPose p = bodies.pose(0, t);
    const double h = 1e-3;
    const double now = w.at({40, -20, 0}, t).surface;
    EXPECT_NEAR(p.position.z() - 3, now, 2e-6) << t;
    EXPECT_NEAR(p.velocity.z(),
                (w.at({40, -20, 0}, t + h).surface - w.at({40, -20, 0}, t - h).surface) / (2 * h), 1e-4)
        << t;
    const Vec3 turn = log_so3(p.rotation * exp_so3(Vec3(0, 0, M_PI / 6)).conjugate());
    EXPECT_LT((turn - 2 * M_PI / 180 * w.at({40, -20, 0}, t + 9. / 4).surface * side).norm(), 1e-6) << t;
  }
}

// A ship that drifts meets the waves at its current position: its heave is the elevation there, and its rates
// are the time derivatives of its pose.
TEST(CaseRao, DriftsInTheWaves) {
  const std::string text = R"(
hawser: 1
environment:
  water: {depth: 100}
  waves: {stokes: {height: 3, period: 9, direction_deg: 75}, ramp: 0}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}
bodies:
  ship:
    position: [40, -20, 3]
    rotation_deg: [0, 0, 30]
    motion:
      rao: {phase: lead, rows: [[9, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 90, 0, 0], [9, 90, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 0]]}
      drift: {offset: [12, -7, 0], rotation_deg: [0, 0, 45], harmonic: {amplitude: [10, 4, 0], period: 90}}
lines:
  mooring:
    sections: [{type: chain, length: 120, elements: 12}]
    end_a: {anchor: [100, 0, -50]}
    end_b: {body: ship, at: [0, 0, 0]}
dynamics: {duration: 100}
)";
  const model::Case c = io::read_case_text(text, "/nowhere/case.yaml");
  const Bodies bodies(c.bodies);
  const WaveField w = model::wave_field(c.environment);
  const WaveComponent& k = w.components()[0];  // vessels respond to a Stokes wave as to a linear one
  ASSERT_EQ(w.components().size(), 1u);
  for (double t = 0; t < 100; t += 1.3) {
    const RigidPose p = bodies.pose(0, t);
    const double slow = std::sin(2 * M_PI * t / 90);
    const Vec3 at(52 + 10 * slow, -27 + 4 * slow, 3);
    const double angle = k.number * (k.x * at.x() + k.y * at.y()) - k.omega * t;
    EXPECT_LT((p.position - at - Vec3(0, 0, k.amplitude * std::cos(angle))).norm(), 1e-5) << t;
    // The waves propagate along the heading of 75 deg after the drift: pitch leads the crest by a quarter of
    // a period, without roll.
    const Vec3 turn = log_so3(p.rotation * exp_so3(Vec3(0, 0, 75 * M_PI / 180)).conjugate());
    const Vec3 side(-std::sin(75 * M_PI / 180), std::cos(75 * M_PI / 180), 0);
    const double pitch = 2 * M_PI / 180 * k.amplitude * std::cos(angle - M_PI / 2);
    EXPECT_LT((turn - pitch * side).norm(), 1e-5) << t;
    const double h = 1e-3;
    if (t < 1) continue;
    const Vec3 v = (bodies.pose(0, t + h).position - bodies.pose(0, t - h).position) / (2 * h);
    const Vec3 a = (bodies.pose(0, t + h).velocity - bodies.pose(0, t - h).velocity) / (2 * h);
    EXPECT_LT((v - p.velocity).norm(), 1e-5) << t;
    EXPECT_LT((a - p.acceleration).norm(), 1e-5) << t;
  }
}

// A table of 0 to 180 deg, and a wave from the other side: with symmetry the ship rolls to the other side;
// without it a note reports the missing directions.
TEST(CaseRao, WavesFromTheOtherSide) {
  const auto read = [](const std::string& sea, const std::string& rao) {
    std::string rows;
    for (int direction = 0; direction <= 180; direction += 90)
      rows += (rows.empty() ? "" : ", ") + std::string("[9, ") + std::to_string(direction) +
              ", 0, 0, 0, 0, 1, 0, " + (direction == 90 ? "3" : "0") + ", 0, 0, 0, 0, 0]";
    return io::read_case_text(R"(
hawser: 1
environment: {water: {depth: 100}, waves: {)" +
                                  sea + R"(, ramp: 0}}
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}}
bodies: {ship: {position: [0, 0, 0], rotation_deg: [0, 0, 30], motion: {rao: {)" +
                                  rao + "rows: [" + rows + R"(]}}}}
lines:
  mooring: {sections: [{type: chain, length: 120, elements: 12}], end_a: {anchor: [100, 0, -50]}, end_b: {body: ship, at: [0, 0, 0]}}
dynamics: {duration: 20}
)",
                              "/nowhere/case.yaml");
  };
  const auto wave = [](int direction) {
    return fmt::format("regular: {{height: 3, period: 9, direction_deg: {}}}", direction);
  };
  const std::string mirror = "symmetry: port_starboard, ";
  const auto roll = [](const model::Case& c, double t) {
    const Bodies bodies(c.bodies);
    return log_so3(bodies.pose(0, t).rotation * exp_so3(Vec3(0, 0, M_PI / 6)).conjugate()).norm();
  };
  // Propagation to 90 and to 270 deg relative to the bow.
  const model::Case port = read(wave(120), "");
  const model::Case starboard = read(wave(300), mirror);
  const model::Case blind = read(wave(300), "");
  EXPECT_TRUE(port.notes.empty());
  EXPECT_TRUE(starboard.notes.empty());
  EXPECT_NEAR(roll(port, 9), 1.5 * 3 * M_PI / 180, 1e-5);
  EXPECT_NEAR(roll(starboard, 9), 1.5 * 3 * M_PI / 180, 1e-5);
  EXPECT_NEAR(roll(blind, 9), 0, 1e-9);
  ASSERT_EQ(blind.notes.size(), 1U);
  EXPECT_NE(blind.notes[0].find(
                "bodies.ship.motion.rao: the wave propagates to 270 deg as seen from the bow, and the "
                "responses there lie on straight lines between 180 and 360 deg"),
            std::string::npos)
      << blind.notes[0];
  // No notes for the last direction of the table, nor for a direction between two close ones.
  EXPECT_TRUE(read(wave(210), "").notes.empty());
  EXPECT_TRUE(read(wave(150), "").notes.empty());
  const auto sea = read("jonswap: {hs: 3, tp: 9, direction_deg: 300, components: 20}", "").notes;
  ASSERT_FALSE(sea.empty());
  EXPECT_NE(sea[0].find("20 components of the sea go to 270 deg"), std::string::npos) << sea[0];
}

// Notes for a table with waves shorter and longer than its periods, and with directions that it does not
// have.
TEST(CaseRao, WavesBeyondTheTable) {
  const auto notes = [](const std::string& sea, const std::vector<double>& periods,
                        const std::vector<int>& directions) {
    std::string rows;
    for (const int direction : directions)
      for (const double period : periods)
        rows += fmt::format("{}[{}, {}, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]", rows.empty() ? "" : ", ",
                            period, direction);
    return io::read_case_text(R"(
hawser: 1
environment: {water: {depth: 100}, waves: {)" +
                                  sea + R"(, ramp: 0}}
line_types: {chain: {outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}}
bodies: {ship: {position: [0, 0, 0], rotation_deg: [0, 0, 30], motion: {rao: {rows: [)" +
                                  rows + R"(]}}}}
lines:
  mooring: {sections: [{type: chain, length: 120, elements: 12}], end_a: {anchor: [100, 0, -50]}, end_b: {body: ship, at: [0, 0, 0]}}
dynamics: {duration: 20}
)",
                              "/nowhere/case.yaml")
        .notes;
  };
  const std::string wave = "regular: {height: 3, period: 9, direction_deg: 90}";  // 60 deg from the bow
  EXPECT_TRUE(notes(wave, {5, 12}, {0, 90, 180, 270}).empty());
  EXPECT_TRUE(notes(wave, {9}, {60}).empty());
  const auto shorter = notes(wave, {10, 12}, {60});
  ASSERT_EQ(shorter.size(), 1U);
  EXPECT_EQ(
      shorter[0],
      "bodies.ship.motion.rao: 100 % of the sea's energy has shorter periods than the table, as far as 9 "
      "s, and there the responses of its shortest one, 10 s, are used: give rows there");
  const auto longer = notes(wave, {4, 6}, {60});
  ASSERT_EQ(longer.size(), 1U);
  EXPECT_NE(longer[0].find("has longer periods than the table, as far as 9 s, and there the responses of its "
                           "longest one, 6 s, are used"),
            std::string::npos)
      << longer[0];
  const auto uncovered = notes(wave, {5, 12}, {0});
  ASSERT_EQ(uncovered.size(), 1U);
  EXPECT_EQ(
      uncovered[0],
      "bodies.ship.motion.rao: the table has one direction, 0 deg, whose responses are used for waves up "
      "to 60 deg away from it: give rows for the directions of the sea");
}

// Linear interpolation between amplitudes of 1 with phases 150 degrees apart comes within cos 75 degrees of
// zero.
TEST(CaseRao, PhasesThatTurnFromRowToRow) {
  const auto notes = [](const std::string& sea, const std::string& heave_8, const std::string& heave_10) {
    std::vector<std::string> out;
    for (const std::string& note : io::read_case_text(fmt::format(R"(
hawser: 1
environment: {{water: {{depth: 100}}, waves: {{{}, ramp: 0}}}}
line_types: {{chain: {{outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}}}}
bodies:
  ship:
    position: [0, 0, 0]
    motion:
      rao:
        rows:
        - [4, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]
        - [8, 0, 0, 0, 0, 0, {}, 0, 0, 0, 0, 0]
        - [10, 0, 0, 0, 0, 0, {}, 0, 0, 0, 0, 0]
        - [60, 0, 0, 0, 0, 0, 1, 150, 0, 0, 0, 0, 0, 0]
lines:
  mooring: {{sections: [{{type: chain, length: 120, elements: 12}}], end_a: {{anchor: [100, 0, -50]}}, end_b: {{body: ship, at: [0, 0, 0]}}}}
dynamics: {{duration: 20}}
)",
                                                                  sea, heave_8, heave_10),
                                                      "/nowhere/case.yaml")
                                       .notes)
      if (note.find("turns by") != std::string::npos) out.push_back(note);
    return out;
  };
  const auto wave = [](double period) { return fmt::format("regular: {{height: 3, period: {}}}", period); };
  const auto found = notes(wave(9), "1, 0, 0", "1, 150, 0");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0],
            "bodies.ship.motion.rao: in waves to 0 deg as seen from the bow the phase of heave turns by 150 "
            "deg from 8 to "
            "10 s, where 100 % of the sea's energy is, and the straight line between these rows makes the "
            "amplitude "
            "fall from 1 to 0.259 m/m there; if the vessel's does not, give rows between them");
  EXPECT_TRUE(notes(wave(9), "1, 60, 0", "1, 149, 0").empty());
  EXPECT_TRUE(notes(wave(9), "0.05, 0, 0", "1, 150, 0").empty());
  EXPECT_TRUE(notes(wave(8), "1, 0, 0", "1, 150, 0").empty());
  EXPECT_TRUE(notes(wave(7), "1, 0, 0", "1, 150, 0").empty());
  EXPECT_TRUE(notes("jonswap: {hs: 3, tp: 5}", "1, 0, 0", "1, 150, 0").empty());
  const auto sea =
      notes("jonswap: {hs: 3, tp: 8}", "1, 120, 0", "1, 0, 0");  // from 4 to 8, 8 to 10, 10 to 60 s
  ASSERT_EQ(sea.size(), 1U);
  EXPECT_NE(sea[0].find("fall from 1 to 0.5 m/m there (and so in 2 other places of the table);"),
            std::string::npos)
      << sea[0];
}

}  // namespace
}  // namespace hawser::case_rao_test
