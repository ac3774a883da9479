// Ends of lines released during a run: free fall, the wave along a parted line, release at a tension, and
// restarts.
#include <numeric>

#include "hawser/base/error.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::release {
namespace {

constexpr double kGravity = 9.80665;

// A chain hangs in air from an anchor with a weight below, and is released at its upper end.
const char* const kFalling = R"(hawser: 1
title: A chain with a weight that is cast off
environment: {gravity: 9.80665}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 50, EA: 1e8, bending: false}
lines:
  chain:
    sections: [{type: chain, length: 20, elements: 10}]
    end_a: free
    end_b: {anchor: [0, 0, 100]}
    masses: [{at: end_a, mass: 1000}]
dynamics: {duration: 1.5}
events:
  - {release: {line: chain, end: end_b}, time: 0.5}
output: {every: 0.25}
contact: {between_lines: false}
)";

double centre_of_mass(const Results& r, size_t output) {
  double sum = 0, mass = 0;
  const auto& x = r.fields.at("position");
  for (size_t n = 0; n <= 10; ++n) {
    const double m = (n == 0 || n == 10 ? 50.0 : 100.0) + (n == 0 ? 1000.0 : 0.0);
    sum += m * x.at(3 * (11 * output + n) + 2);
    mass += m;
  }
  return sum / mass;
}

TEST(Release, FallsFreely) {
  const std::string path = folder("release-fall");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kFalling);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  ASSERT_EQ(r.output_times.size(), 7u);
  const double rest = centre_of_mass(r, 0);
  EXPECT_NEAR(centre_of_mass(r, 2), rest, 1e-8);
  for (size_t i = 3; i < 7; ++i) {
    const double t = r.output_times[i] - 0.5;
    EXPECT_NEAR(centre_of_mass(r, i), rest - 0.5 * kGravity * t * t, 1e-5 * kGravity * t * t) << t;
  }
}

TEST(Release, GoesOnAfterARestart) {
  const std::string path = folder("release-restart");
  const std::string input = path + "/case.yaml";
  write_case(input, kFalling);
  run_on_all({input, path + "/whole.h5"});
  for (const double stop : {0.25, 0.5, 1.0}) {
    run_on_all({input, path + "/half.h5", "", stop});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results whole = read(path + "/whole.h5");
    const Results rest = read(path + "/rest.h5");
    EXPECT_NEAR(centre_of_mass(whole, 6), centre_of_mass(rest, rest.output_times.size() - 1), 1e-9) << stop;
  }
}

// A restart after a release without this event in the case is rejected, because the end would be held again.
TEST(Release, ARestartWithoutTheEventIsRefused) {
  const std::string path = folder("release-other");
  const std::string input = path + "/case.yaml";
  const std::string other = path + "/other.yaml";
  write_case(input, kFalling);
  write_case(other, kFalling, {{"events:\n  - {release: {line: chain, end: end_b}, time: 0.5}\n", ""}});
  run_on_all({input, path + "/half.h5", "", 0.75});
  run::RunOptions o;
  o.case_path = other;
  o.output = path + "/rest.h5";
  o.restart = path + "/half.h5";
  o.quiet = true;
  try {
    run::run(MPI_COMM_WORLD, o);
    FAIL() << "it goes on";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("'end B of line chain released' happened at t = 0.5 s"),
              std::string::npos)
        << e.what();
  }
}

// A body with an initial velocity releases an end at t = 0: the end has zero velocity, and the rope recoils
// as from a body at rest.
TEST(Release, AtTheStartFromABodyThatMovesAtOnce) {
  const std::string path = folder("release-jerk");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A rope that is let go of
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e5, bending: false}
bodies:
  tug: {position: [10.1, 0, 0], motion: {velocity: [5, 0, 0]}}
lines:
  rope:
    sections: [{type: rope, length: 10, elements: 10}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {body: tug, at: [0, 0, 0]}
dynamics: {duration: 0.5}
events:
  - {release: {line: rope, end: end_b}, time: 0}
output: {every: 0.01}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const std::vector<double> T = read(file).fields.at("effective_tension");
  EXPECT_LT(*std::max_element(T.begin(), T.end()), 1050);  // 1000 N at rest
  EXPECT_GT(*std::max_element(T.begin(), T.end()), 999);
}

// Until the wave returns from the other end, the anchor force is the initial tension and is the only force on
// the line: its centre of mass accelerates accordingly.
TEST(Release, AWaveRunsAlongTheLine) {
  const std::string path = folder("release-wave");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A rope that parts
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e6, bending: false}
lines:
  rope:
    sections: [{type: rope, length: 100, elements: 100}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [101, 0, 0]}
dynamics: {duration: 0.25, max_step: 1e-3}
events:
  - {release: {line: rope, end: end_b}, time: 0.05}
output: {every: 0.05, histories: [{line: rope, at: end_a, name: anchor}]}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto held = named(file, r, "anchor", "effective_tension");
  const double T = 1e6 * 0.01, line = 1000;
  // The wave speed is 316 m/s; it reaches the anchor at 0.05 s + 100 m / 316 m/s.
  for (const double value : held) EXPECT_NEAR(value, T, 1e-3 * T);
  const auto centre = [&](size_t output) {
    double sum = 0;
    for (size_t n = 0; n <= 100; ++n)
      sum += (n == 0 || n == 100 ? 0.5 : 1.0) * r.fields.at("position").at(3 * (101 * output + n)) / 100;
    return sum;
  };
  for (size_t i = 2; i < r.output_times.size(); ++i) {
    const double t = r.output_times[i] - 0.05;
    EXPECT_NEAR(centre(0) - centre(i), 0.5 * T / line * t * t, 1e-3 * 0.5 * T / line * t * t) << t;
  }
}

// A load on a rope is released at its rope.
TEST(Release, ABodyFallsFreely) {
  const std::string path = folder("release-body");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A load that is dropped
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 5e7, bending: false}
bodies:
  load: {position: [0, 0, 10], floating: {mass: 5000, inertia: [2e3, 2e3, 2e3], weight: true}}
lines:
  rope:
    sections: [{type: rope, length: 19, elements: 8}]
    end_a: {body: load, at: [0, 0, 1]}
    end_b: {anchor: [0, 0, 30]}
dynamics: {duration: 1}
events:
  - {release: {line: rope, end: end_a}, time: 0.25}
output: {every: 0.25, histories: [{body: load}]}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto z = named(file, r, "load", "position_z");
  EXPECT_LT(z.front() - z.back(), 0.51 * kGravity * 0.75 * 0.75);
  for (size_t i = 0; i < z.size(); ++i) {
    const double t = std::max(r.step_times[i] - 0.25, 0.0);
    EXPECT_NEAR(z[i], z.front() - 0.5 * kGravity * t * t, 1e-5) << r.step_times[i];
  }
}

// The rope is released when its tension reaches the limit, within 0.1 % at any step: the largest tension is
// the limit. The tension rises linearly, so at most two rejected steps find the time.
TEST(Release, AtATension) {
  const std::string path = folder("release-tension");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  for (const std::string step : {"0.1", "0.07", "0.013"}) {
    write_case(input, R"(hawser: 1
title: A rope that is pulled until it parts
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 1, EA: 1e6, bending: false}
bodies:
  tug: {position: [10.001, 0, 0], motion: {velocity: [0.1, 0, 0], ramp: 0.5}}
lines:
  rope:
    sections: [{type: rope, length: 10, elements: 5}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {body: tug, at: [0, 0, 0]}
dynamics: {duration: 3, max_step: STEP}
events:
  - {release: {line: rope, end: end_b}, tension: 12 kN}
output: {every: 0.5, histories: [{line: rope, at: end_b, name: end}]}
contact: {between_lines: false}
)",
               {{"STEP", step}});
    run_on_all({input, file});
    // The search needs no history from before the step, so a restart from 1 s finds the same time.
    run_on_all({input, path + "/half.h5", "", 1});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results r = read(file);
    const Results rest = read(path + "/rest.h5");
    EXPECT_EQ(std::vector<double>(r.step_times.end() - 20, r.step_times.end()),
              std::vector<double>(rest.step_times.end() - 20, rest.step_times.end()));
    const auto T = named(file, r, "end", "effective_tension");
    const auto x = named(file, r, "end", "position_x");
    const auto again = named(path + "/rest.h5", rest, "end", "effective_tension");
    EXPECT_EQ(*std::max_element(again.begin(), again.end()), *std::max_element(T.begin(), T.end())) << step;
    const size_t parted = static_cast<size_t>(std::max_element(T.begin(), T.end()) - T.begin());
    EXPECT_GE(T[parted], 12e3) << step;
    EXPECT_LE(T[parted], 12e3 * 1.001) << step;
    EXPECT_LT(x.back(), 10.12) << step;  // the rope stays behind; the tug is at 10.28 m
    const auto tries = named(file, r, "solver", "rejected");
    const auto before = tries.begin() + static_cast<std::ptrdiff_t>(parted) + 1;
    // Two for the event; the others while the rope comes taut.
    EXPECT_LE(std::accumulate(tries.begin(), before, 0.0), 10) << step;
  }
}

}  // namespace
}  // namespace hawser::runs::release
