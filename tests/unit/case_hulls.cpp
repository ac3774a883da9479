// Hulls and members of bodies in a case: refusals, and the warning about a hull without drag.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::case_hulls_test {
namespace {

const char* const kHull = "hull: {volumes: [side]}";
const char* const kMember = ", members: [{from: [0, 0, -4], to: [0, 0, 2], diameter: 8}]";
const char* const kBox = "shape: {box: {centre: [0, 0, -1], size: [20, 8, 6]}}, body: barge";

model::Case read(const std::string& floating, const std::string& volume = kBox,
                 const std::string& environment = "water: {density: 1000}") {
  return io::read_case_text("hawser: 1\nenvironment: {" + environment +
                                "}\nbodies:\n  barge:\n    floating: {mass: 4e5, inertia: [4e6, 2e7, 2e7], " +
                                floating + "}\nvolumes:\n  side: {" + volume + "}\ndynamics: {duration: 4}\n",
                            testing::TempDir() + "hull.yaml");
}

void expect_refused(const std::string& part, const std::string& floating, const std::string& volume = kBox,
                    const std::string& environment = "water: {density: 1000}") {
  try {
    read(floating, volume, environment);
    ADD_FAILURE() << "accepted: " << floating << ", " << volume;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

TEST(CaseHulls, WhatIsRefused) {
  const std::string key = ":5: bodies.barge.floating.hull";
  EXPECT_NO_THROW(read(std::string(kHull) + kMember));
  expect_refused(key + ": there is no water", kHull, kBox, "gravity: 9.81");
  expect_refused(key + ": needs gravity for its buoyancy, and 'environment.gravity' is 0", kHull, kBox,
                 "gravity: 0, water: {density: 1000}");
  expect_refused(key + ": 'in_water' includes buoyancy as well",
                 std::string(kHull) + ", in_water: {volume: 400, height: 6}");
  expect_refused(key + ": includes the weight and buoyancy of the body, so that the weight always acts",
                 std::string("weight: false, ") + kHull);
  expect_refused(key + ".volumes: names volume 'side' twice", "hull: {volumes: [side, side]}");
  expect_refused(key + ".volumes: volume 'side' moves with nothing, not with this body: set 'body: barge'",
                 kHull, "shape: {sphere: {centre: [0, 0, 0], radius: 5}}");
  expect_refused(key + ".volumes: volume 'side' is a plane", kHull,
                 "shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, body: barge");
  expect_refused("bodies.barge.floating.hull.volumes[0]", "hull: {volumes: [sides]}");
  expect_refused("bodies.barge.floating.members[0].to: is the same point as 'from'",
                 std::string(kHull) + ", members: [{from: [0, 0, 1], to: [0, 0, 1], diameter: 8}]");
}

// With coefficient files, wave forces come from the files only, and members have drag only, unless the case
// requests more.
TEST(CaseHulls, BesideCoefficients) {
  const std::string files = "hydrodynamics: {wamit: " HAWSER_SOURCE_DIR "/docs/tutorial/spar}, ";
  const auto of = [&](const std::string& more) {
    return read(files + kHull + ", members: [{from: [0, 0, -4], to: [0, 0, 2], diameter: 8" + more + "}]");
  };
  const auto counted_twice = [](const model::Case& c) {
    int found = 0;
    for (const std::string& note : advice::input_notes(c))
      found += note.find("has added mass beside that of 'hydrodynamics'") != std::string::npos;
    return found;
  };
  const model::Case plain = of("");
  const model::Case added = of(", Ca: 1");
  EXPECT_FALSE(plain.bodies[0].mass->hull->wave_pressure);
  EXPECT_EQ(plain.bodies[0].mass->members[0].added, 0);
  EXPECT_EQ(added.bodies[0].mass->members[0].added, 1);
  EXPECT_EQ(counted_twice(plain), 0);
  EXPECT_EQ(counted_twice(added), 1);
  EXPECT_EQ(counted_twice(of(", axial_Ca: 1")), 1);
  const std::vector<std::string> large = advice::input_notes(
      read(std::string(kHull) + ", members: [{from: [0, 0, -4], to: [0, 0, 2], diameter: 80}]"));
  ASSERT_EQ(large.size(), 1U);
  EXPECT_NE(large[0].find("has a volume of 3.02e+04 m³, and the body's mass is that of 400 m³ of water"),
            std::string::npos);
  const std::vector<std::string> far = advice::input_notes(
      read(std::string(kHull) + ", members: [{from: [0, 0, -4], to: [400, 0, -4], diameter: 1}]"));
  ASSERT_EQ(far.size(), 1U);
  EXPECT_NE(far[0].find(
                "reaches 400 m from the centre of mass, and a cube of the body's volume has sides of 7.37 m"),
            std::string::npos)
      << far[0];
}

TEST(CaseHulls, WarningWithoutDragAndAddedMass) {
  const std::vector<std::string> alone = advice::input_notes(read(kHull));
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_NE(alone.front().find("bodies.barge.floating.hull: only the water pressure acts on this body"),
            std::string::npos)
      << alone.front();
  EXPECT_TRUE(advice::input_notes(read(std::string(kHull) + kMember)).empty());
}

// A box of 20 x 8 x 6 m with a draught of 2.5 m at 400 t, and a taut line of 40 m that holds its middle down
// at the start position.
struct Afloat {
  explicit Afloat(double z, const std::string& centre = "[0, 0, -2]", double line = 0) {
    std::string text = fmt::format(
        "hawser: 1\nenvironment: {{water: {{density: 1000, depth: 100}}}}\nbodies:\n  barge: {{position: [0, "
        "0, "
        "{}], floating: {{mass: 4e5, inertia: [4e6, 2e7, 2e7], centre_of_mass: {}, hull: {{volumes: "
        "[side]}}}}}}\nvolumes:\n  side: {{{}}}\ndynamics: {{duration: 4}}\n",
        z, centre, kBox);
    if (line > 0)
      text += fmt::format(
          "line_types: {{wire: {{outer_diameter: 0.05, mass_per_length: 5, EA: 1e8, bending: false}}}}\n"
          "lines:\n  tether: {{sections: [{{type: wire, length: {}, elements: 4}}], end_a: {{anchor: [0, 0, "
          "{}]}}, end_b: {{body: barge, at: [0, 0, -4]}}}}\ncontact: {{volumes: []}}\n",
          line, z - 4 - 40);
    c = io::read_case_text(text, testing::TempDir() + "afloat.yaml");
    volumes = run::load_volumes(c, MPI_COMM_SELF);
    run::set_hydrostatics(c, volumes);
  }
  std::string at_start() const { return run::hulls_text(c, volumes); }
  std::vector<std::string> at_rest() const {
    run::Simulation s(MPI_COMM_SELF, c, run::surfaces(volumes), run::skeletons(c, volumes),
                      run::volume_facets(volumes));
    s.solve_statics();
    return run::platforms_off_start(MPI_COMM_SELF, c, s.bodies(), s.state().at_rest());
  }
  model::Case c;
  std::vector<run::LoadedVolume> volumes;
};

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

// Lines that hold a body at its start position cause no warning. 0.5 m deeper the body displaces 80 m³ more.
TEST(CaseHulls, LinesMayHoldABodyOffItsDraught) {
  EXPECT_EQ(Afloat(1.5).at_start().find("warning"), std::string::npos) << Afloat(1.5).at_start();
  EXPECT_EQ(Afloat(1.5).at_start().find("note"), std::string::npos);
  expect_part(Afloat(1).at_start(),
              "warning: body barge floats 0.5 m higher than its initial position: there its weight and "
              "buoyancy differ by 784.53 kN, and no line or spring carries the difference");
  // A force of 784.5 kN stretches the line by 7.85e-3 of its 40 m.
  const Afloat held(1, "[0, 0, -2]", 40 / 1.00785);
  expect_part(held.at_start(),
              "note: without its lines body barge would float 0.5 m higher: they must carry 784.53 kN down");
  EXPECT_EQ(held.at_start().find("warning"), std::string::npos);
  EXPECT_TRUE(held.at_rest().empty());
  // With 0.3 m of slack: 784.5 kN - 1569 kN/m r = 2481 kN/m (r - 0.3 m) at r = 0.377 m.
  const std::vector<std::string> slack = Afloat(1, "[0, 0, -2]", 40.3).at_rest();
  ASSERT_EQ(slack.size(), 1U);
  expect_part(slack.front(), "body barge comes to rest 0.377 m higher than its initial position");
}

// KB = 1.25 m, BM = 8²/(12 2.5) = 2.13 m in roll and 13.3 m in pitch: KG = 4 m is above the metacentre of
// roll only, KG = 15 m above both.
TEST(CaseHulls, NegativeMetacentricHeights) {
  expect_part(Afloat(1.5, "[0, 0, 0]").at_start(),
              "warning: body barge capsizes: its metacentric height in roll is negative");
  expect_part(Afloat(1.5, "[0, 0, 11]", 40).at_start(),
              "warning: body barge would capsize without its lines: its metacentric height in roll and pitch "
              "is negative");
}

}  // namespace
}  // namespace hawser::case_hulls_test
