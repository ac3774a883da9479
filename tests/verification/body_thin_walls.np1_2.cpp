// Bodies whose contact is too soft for a wall or a deck: the run ends where contact would push them out on
// the far side, and the stiffness that its message proposes holds them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "verification/bodies_rig.hpp"

namespace hawser::test::body_thin_walls {
namespace {

struct Impact {
  const char* wall;      // thickness in m
  std::string body;      // the body of 6 t, 5 cm or more above the wall
  std::string volume;    // its shape
  const char* key;       // of its stiffness
  double stiffness = 0;  // too soft
};

// A deck from z = -thickness to 0, and a body above it.
std::string case_text(const Impact& i, double stiffness, const char* statics) {
  return fmt::format(R"(hawser: 1
bodies:
  load: {{{}, floating: {{mass: 6000, inertia: [1000, 1000, 1000], weight: true}}}}
volumes:
  deck: {{shape: {{box: {{centre: [0, 0, -{}], size: [4, 4, {}]}}}}, friction: 0.3}}
  hull: {{shape: {{{}}}, body: load, normal_stiffness: {{{}: {}}}, friction: 0.3}}
statics: {}
dynamics: {{duration: 0.6}}
)",
                     i.body, 0.5 * std::stod(i.wall), i.wall, i.volume, i.key, stiffness, statics);
}

std::string moved(const Impact& i, double stiffness, double& height) {
  BodiesRun r(case_text(i, stiffness, "false"));
  try {
    r.run_without_statics();
  } catch (const SolveError& e) {
    return e.what();
  }
  height = r.poses()[0].position.z();
  return {};
}

// The stiffness that the message proposes.
double proposed(const std::string& message, const char* key) {
  const std::string before = fmt::format("try 'normal_stiffness: {{{}: ", key);
  const size_t at = message.find(before);
  return at == std::string::npos ? 0 : std::stod(message.substr(at + before.size()));
}

const std::string kDropped = "position: [0, 0, 0.55]";
const std::string kThrown = "position: [0, 0, 0.8]";
const std::string kBox = "box: {centre: [0, 0, 0], size: [1, 1, 1]}";

std::vector<Impact> impacts() {
  return {{"0.02", kDropped, kBox, "per_area", 1e7},
          {"0.02", kDropped, kBox, "per_length", 2.5e6},
          {"0.02", kDropped, kBox, "per_point", 2.5e6},
          {"0.1", kThrown, "sphere: {centre: [0, 0, 0], radius: 0.5}", "per_point", 1e5},
          {"0.1", kThrown, "capsule: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.5}", "per_length", 5e4},
          {"0.1", kThrown, "capsule: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.5}", "per_area", 5e4}};
}

TEST(BodyThinWalls, AreNotPassedUnnoticed) {
  for (const Impact& i : impacts()) {
    double height = 0;
    const std::string what = moved(i, i.stiffness, height);
    printf("%s\n", what.c_str());
    EXPECT_NE(what.find("volume hull of body load is pressed"), std::string::npos) << what << height;
    EXPECT_NE(what.find(fmt::format("past the middle of its thickness of {} m", i.wall)), std::string::npos)
        << what;
    const double stiffness = proposed(what, i.key);
    ASSERT_GT(stiffness, i.stiffness) << what;
    EXPECT_EQ(moved(i, stiffness, height), "");
    EXPECT_GT(height, 0) << i.key;
    printf("%s: %g, height %g\n", i.key, stiffness, height);
  }
}

// At rest the crate of 6 t would be 5.9 cm deep in a deck of 10 cm: with a stiffness that halves this it
// rests.
TEST(BodyThinWalls, HoldInStatics) {
  for (const char* position : {"position: [0, 0, 0.5]", "position: [0, 0, 0.55]"}) {
    const Impact i{"0.1", position, kBox, "per_area", 1e6};
    double stiffness = 0;
    try {
      BodiesRun r(case_text(i, i.stiffness, "{contact_friction: true}"));
      r.sim.solve_statics();
      ADD_FAILURE() << "it rests";
    } catch (const SolveError& e) {
      const std::string what = e.what();
      printf("%s\n", what.c_str());
      EXPECT_NE(what.find("past the middle of its thickness of 0.1 m"), std::string::npos) << what;
      stiffness = proposed(what, i.key);
    }
    EXPECT_NEAR(stiffness, 2e6, 1e5);
    BodiesRun r(case_text(i, stiffness, "{contact_friction: true}"));
    r.sim.solve_statics();
    const double depth = 0.5 - r.poses(r.sim.state().at_rest())[0].position.z();
    EXPECT_GT(depth, 0.02);
    EXPECT_LT(depth, 0.03);
  }
}

// A crate that starts past the middle of a deck does not come to rest there.
TEST(BodyThinWalls, NothingRestsInTheMiddle) {
  const Impact i{"1", "position: [0, 0, -0.1]", kBox, "per_area", 1e7};
  BodiesRun r(case_text(i, i.stiffness, "{contact_friction: true}"));
  try {
    r.sim.solve_statics();
    ADD_FAILURE() << "it rests";
  } catch (const SolveError& e) {
    printf("%s\n", e.what());
    EXPECT_NE(std::string(e.what()).find("middle of its thickness of 1 m"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace hawser::test::body_thin_walls
