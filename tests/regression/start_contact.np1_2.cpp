// Lines that start inside volumes: excluded contact, errors, and messages.
#include <algorithm>
#include <numeric>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/run/volumes.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::start_contact {
namespace {

// A rope from its fairlead, 3 m inside a hull, to an anchor far below.
const char* const kFairlead = R"(hawser: 1
line_types:
  rope: {outer_diameter: 0.2, mass_per_length: 30, EA: 1.0e7, bending: false}
bodies:
  ship: {}
volumes:
  hull: {shape: {box: {centre: [0, 0, 0], size: [40, 10, 8]}}, body: ship, normal_stiffness: {per_length: 1.0e6}}
lines:
  mooring:
    sections: [{type: rope, length: 125, elements: 50}]
    end_a: {anchor: [100, 0, -60]}
    end_b: {body: ship, at: [17, 0, 0]}
contact: {method: METHOD}
dynamics: {duration: 0.4, step: 0.02}
output: {every: 0.1}
)";

struct Ready {
  model::Case c;
  std::vector<run::LoadedVolume> volumes;
  std::unique_ptr<run::Simulation> sim;
};
Ready ready(const std::string& path) {
  Ready r;
  r.c = io::read_case(path);
  r.volumes = run::load_volumes(r.c, MPI_COMM_WORLD);
  r.sim = std::make_unique<run::Simulation>(MPI_COMM_WORLD, r.c, run::surfaces(r.volumes));
  return r;
}
std::string join(const std::vector<std::string>& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::string(),
                         [](const std::string& a, const std::string& b) { return a + b + "\n"; });
}
// Largest value over all nodes; no rank requests the same node twice.
double largest(Ready& r, const std::string& field) {
  double most = 0;
  const FieldRegistry fields = r.sim->system().fields();
  for (const FieldSource& f : fields.sources()) {
    if (f.name != field) continue;
    std::vector<double> values(r.sim->state().x.size() * static_cast<size_t>(f.components));
    f.fill(r.sim->state().at_rest(), values);
    for (size_t i = 0; i < static_cast<size_t>(r.sim->local().owned * f.components); ++i)
      most = std::max(most, std::abs(values[i]));
  }
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return most;
}
std::string refused(Ready& r) {
  try {
    r.sim->solve_statics();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}
#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(StartContact, AFairleadInItsHullIsExcluded) {
  const std::string path = folder("start_contact") + "/fairlead";
  for (const std::string method : {"line", "nodes"}) {
    write_case(path + method + ".yaml", kFairlead, {{"METHOD", method}});
    Ready r = ready(path + method + ".yaml");
    const std::string notes = join(r.sim->notes());
    EXPECT_HAS(notes, "lines.mooring.end_b: starts up to ");
    EXPECT_HAS(notes, " m inside volume hull; the ");
    EXPECT_HAS(notes,
               " m of line up to where it is clear of it have no contact with it ('no_contact_within' sets");
    EXPECT_TRUE(r.sim->warnings().empty()) << join(r.sim->warnings());
    EXPECT_EQ(refused(r), "");
    // The hull has no effect: the tension is that without it.
    EXPECT_LT(largest(r, "contact_normal_force"), 1e-6);
    const double tension = largest(r, "effective_tension");
    write_case(path + "_alone.yaml", kFairlead, {{"METHOD", method + ", volumes: []"}});
    Ready alone = ready(path + "_alone.yaml");
    EXPECT_EQ(refused(alone), "");
    EXPECT_GT(tension, 1e4);
    EXPECT_NEAR(largest(alone, "effective_tension"), tension, 1e-6 * tension);
  }
}

// With a given, too short length without contact the line starts inside and statics leaves it there: an
// error.
TEST(StartContact, AStretchOfTheCaseCounts) {
  const std::string path = folder("start_contact_said") + "/said.yaml";
  write_case(path, kFairlead,
             {{"METHOD", "line"}, {"at: [17, 0, 0]}", "at: [17, 0, 0], no_contact_within: 1}"}});
  Ready r = ready(path);
  EXPECT_HAS(join(r.sim->warnings()), "lines.mooring: its start shape passes through volume hull from ");
  const std::string what = refused(r);
  EXPECT_HAS(what, "said.yaml: lines.mooring: starts inside volume hull, and statics leaves it there, from ");
  EXPECT_HAS(what, " to 124 m of arc length, deepest at ");
  EXPECT_HAS(what, "; 'no_contact_within' of end_b must be at least ");
  write_case(path, kFairlead,
             {{"METHOD", "line"}, {"at: [17, 0, 0]}", "at: [17, 0, 0], no_contact_within: 12}"}});
  Ready enough = ready(path);
  EXPECT_TRUE(enough.sim->warnings().empty()) << join(enough.sim->warnings());
  EXPECT_TRUE(join(enough.sim->notes()).find("no_contact_within") == std::string::npos);
  EXPECT_EQ(refused(enough), "");
  EXPECT_LT(largest(enough, "contact_normal_force"), 1e-6);
}

// A rope that starts 0.5 m below a deck comes out and lies on it.
const char* const kDeck = R"(hawser: 1
line_types:
  rope: {outer_diameter: 0.2, mass_per_length: 30, EA: 1.0e6, bending: false}
volumes:
  deck: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, normal_stiffness: {per_length: 1.0e6}}
lines:
  rope:
    sections: [{type: rope, length: 30, elements: 60}]
    end_a: {anchor: [0, 0, -0.5]}
    end_b: {anchor: [29.5, 0, 2]}
contact: {method: METHOD}
)";
TEST(StartContact, TheRestOfTheLineTouches) {
  const std::string path = folder("start_contact_rest") + "/deck.yaml";
  for (const std::string method : {"line", "nodes"}) {
    write_case(path, kDeck,
               {{"METHOD", method + ", volumes: [deck]"},
                {"end_b: {anchor: [29.5, 0, 2]}\n",
                 "end_b: {anchor: [29.5, 0, 2]}\n    start: {points: [[0, 0, -0.5], [1, 0, 0.1], [20, 0, "
                 "0.1], [29.5, 0, 2]]}\n"}});
    Ready r = ready(path);
    EXPECT_HAS(join(r.sim->notes()), "lines.rope.end_a: starts up to 0.5 m inside volume deck; the ");
    EXPECT_TRUE(r.sim->warnings().empty()) << join(r.sim->warnings());
    EXPECT_EQ(refused(r), "");
    double lowest = 1, weight = 0;
    for (int n = 0; n < r.sim->local().owned; ++n) {
      const double arc =
          r.sim->mesh().node(static_cast<size_t>(r.sim->local().global[static_cast<size_t>(n)])).arc;
      if (arc > 3) lowest = std::min(lowest, r.sim->state().x[static_cast<size_t>(n)].z());
    }
    MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    weight = 30 * 9.80665;  // N/m; penetration 0.29 mm on 1 MN/m²
    EXPECT_NEAR(lowest, 0.1 - weight / 1e6, 1e-3) << method;
  }
}

// A rope that starts inside a bollard is accepted if statics moves it out, whatever its start shape.
const char* const kBollard = R"(hawser: 1
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1.0e6, bending: false}
volumes:
  bar: {shape: {cylinder: {from: [0, -5, 0], to: [0, 5, 0], radius: 0.5}}, normal_stiffness: {per_length: 1.0e6}}
lines:
  sling:
    sections: [{type: rope, length: 20.8, elements: 40}]
    end_a: {anchor: [-10, 0, HEIGHT]}
    end_b: {anchor: [10, 0, HEIGHT]}
    start: {points: [[-10, 0, HEIGHT], [0, 0, MIDDLE], [10, 0, HEIGHT]]}
STATICS
)";
std::string bollard(const std::string& height, const std::string& middle, const std::string& rest = "") {
  const std::string path = folder("start_contact_bollard") + "/bollard.yaml";
  write_case(path, kBollard,
             {{"HEIGHT", height},
              {"HEIGHT", height},
              {"HEIGHT", height},
              {"MIDDLE", middle},
              {"HEIGHT", height},
              {"STATICS", rest}});
  return path;
}

TEST(StartContact, WhatStaticsBringsOutIsAccepted) {
  Ready r = ready(bollard("-1", "0.2"));
  EXPECT_HAS(join(r.sim->warnings()), "lines.sling: its start shape passes through volume bar from ");
  EXPECT_HAS(join(r.sim->warnings()), "; move the points of its 'start' out of it");
  EXPECT_EQ(refused(r), "");
}

// The points pass over the bar at (0, 0, 0.52). A straight element of 20.8/41 m between them, with this
// corner in its middle, is at z = 0.482 m, one of half that length at 0.501 m.
TEST(StartContact, ElementsThatCutTheBarWhileTheirPointsAreOutside) {
  const std::string path = folder("start_contact_corner") + "/corner.yaml";
  write_case(path, kBollard,
             {{"elements: 40", "elements: 41"},
              {"HEIGHT", "-1"},
              {"HEIGHT", "-1"},
              {"HEIGHT", "-1"},
              {"MIDDLE", "0.52"},
              {"HEIGHT", "-1"},
              {"STATICS", ""}});
  Ready r = ready(path);
  EXPECT_HAS(join(r.sim->warnings()),
             "; the points of its 'start' are outside, but straight elements between them cut the volume: "
             "give it elements of at most 0.24 m there");
}

TEST(StartContact, WithoutStaticsItIsRefused) {
  const std::string path = bollard("-1", "0.2", "statics: false\ndynamics: {duration: 1}");
  run::RunOptions o;
  o.case_path = path;
  o.quiet = true;
  std::string what;
  try {
    run::run(MPI_COMM_WORLD, o);
  } catch (const InputError& e) {
    what = e.what();
  }
  EXPECT_HAS(what, "lines.sling: starts inside volume bar, and there are no statics to move it out: from ");
}

// Output of hawser check.
TEST(StartContact, CheckReports) {
  if (size_of(MPI_COMM_WORLD) > 1) GTEST_SKIP() << "check runs on one rank";
  const auto check = [](const std::string& path) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(run::check_case(MPI_COMM_WORLD, {.case_path = path, .ranks = 1, .trial = false}), 0);
    std::fflush(stdout);
    return testing::internal::GetCapturedStdout();
  };
  const std::string out = check(bollard("-1", "0.2"));
  EXPECT_HAS(out, "warning: lines.sling: its start shape passes through volume bar from ");
  EXPECT_HAS(out, " of arc length, deepest at ");
  EXPECT_HAS(out, " m inside at (");
  EXPECT_HAS(out, "the case is valid if statics moves the lines out of the volumes in which they start");
  const std::string path = folder("start_contact_check") + "/case.yaml";
  write_case(path, kFairlead, {{"METHOD", "line"}});
  const std::string fairlead = check(path);
  EXPECT_HAS(fairlead, "note: lines.mooring.end_b: starts up to ");
  EXPECT_HAS(fairlead, "the case is valid\n");
  run::CheckOptions inside{.ranks = 1, .trial = false};
  inside.case_path = bollard("-1", "0.2", "statics: false\ndynamics: {duration: 1}");
  EXPECT_THROW(run::check_case(MPI_COMM_WORLD, inside), InputError);
}

// A slack line with the automatic start shape hangs below the roller on which it should lie: a warning.
TEST(StartContact, HangingUnderAVolumeIsReported) {
  const std::string path = folder("start_contact_under") + "/under.yaml";
  const Edits under{{"HEIGHT", "1"},
                    {"HEIGHT", "1"},
                    {"    start: {points: [[-10, 0, HEIGHT], [0, 0, MIDDLE], [10, 0, HEIGHT]]}\n", ""},
                    {"STATICS", ""}};
  write_case(path, kBollard, under);
  Ready r = ready(path);
  const std::string message = join(r.sim->warnings());
  EXPECT_HAS(message,
             "lines.sling: volume bar is between its start shape and the straight line between its "
             "ends: the start shape is below that part of the volume, ");
  EXPECT_HAS(message,
             "; if the line is intended to be there, or in a bore of the volume, confirm it with 'start: ");
  // With both ends below the roller there is no warning.
  Edits below = under;
  below[0].second = below[1].second = "-1";
  write_case(path, kBollard, below);
  EXPECT_TRUE(ready(path).sim->warnings().empty());
}

// A restart excludes the same contact as the first run.
TEST(StartContact, GoesOnAsItStarted) {
  const std::string at = folder("start_contact_restart");
  write_case(at + "/case.yaml", kFairlead, {{"METHOD", "line"}});
  run_on_all({at + "/case.yaml", at + "/whole.h5"});
  run_on_all({at + "/case.yaml", at + "/first.h5", {}, 0.2});
  run_on_all({at + "/case.yaml", at + "/rest.h5", at + "/first.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results whole = read(at + "/whole.h5");
  const Results rest = read(at + "/rest.h5");
  const auto& a = whole.fields.at("position");
  const auto& b = rest.fields.at("position");
  ASSERT_GT(b.size(), 0U);
  const size_t last = 3 * 51;
  for (size_t i = 0; i < last; ++i) EXPECT_NEAR(a[a.size() - last + i], b[b.size() - last + i], 1e-9);
}

// The axis of a line lies half a diameter above the bed, and the bed is lowered at its anchor: there is no
// initial penetration.
const char* const kAnchor = R"(hawser: 1
environment:
  water: {density: 1025, depth: 50}
  seabed: {depth: 50, normal_stiffness: {per_length: 1.0e7}}
line_types:
  hose: {outer_diameter: 0.5, mass_per_length: 250, EA: 1.0e7, bending: false}
lines:
  hose:
    sections: [{type: hose, length: 90, elements: 45}]
    end_a: {anchor: [0, 0, ANCHOR]}
    end_b: {anchor: [70, 0, -10]}
)";
TEST(StartContact, TheBedGivesWayToAnAnchor) {
  const std::string path = folder("start_contact_anchor") + "/anchor.yaml";
  for (const std::string z : {"-50", "-49.9", "-50.2"}) {
    write_case(path, kAnchor, {{"ANCHOR", z}});
    Ready r = ready(path);
    EXPECT_EQ(r.c.lines[0].end_a.at.z(), std::stod(z));
    EXPECT_EQ(refused(r), "");
    // The bed carries only the weight of the line; a penetration of half a diameter would be 2.5 MN/m.
    const double weight = (250 - 1025 * 0.25 * M_PI * 0.25) * 9.80665;  // N/m
    EXPECT_GT(largest(r, "seabed_force"), 1.5 * weight);
    EXPECT_LT(largest(r, "seabed_force"), 2.5 * weight);
  }
}

}  // namespace
}  // namespace hawser::runs::start_contact
