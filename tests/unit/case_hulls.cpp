// Hulls and members of bodies in a case: what is refused, and the warning of a hull without drag.
#include <gtest/gtest.h>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"

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
  expect_refused(key + ": 'in_water' brings buoyancy as well",
                 std::string(kHull) + ", in_water: {volume: 400, height: 6}");
  expect_refused(key + ": brings the buoyancy of the body, so that its weight acts as well",
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

TEST(CaseHulls, WarningWithoutDragAndAddedMass) {
  const std::vector<std::string> alone = advice::input_notes(read(kHull));
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_NE(
      alone.front().find("bodies.barge.floating.hull: the pressure of the water alone acts on this body"),
      std::string::npos)
      << alone.front();
  EXPECT_TRUE(advice::input_notes(read(std::string(kHull) + kMember)).empty());
}

}  // namespace
}  // namespace hawser::case_hulls_test
