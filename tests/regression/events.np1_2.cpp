// What happens during a run: lines that are cut, ends that are attached, winches that start and stop, volumes
// that lines begin to touch, one event after another, stages of statics; restarts around each.
#include "hawser/base/error.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::events {
namespace {

constexpr double kGravity = 9.80665;

// The sum of mass times a component of a vector field over nodes [from, to] of an output, over their mass;
// `ends`: kg of the first and last beside 5 kg of half an element, else 10 kg a node.
double mean_of(const Results& r, const std::string& field, size_t output, size_t from, size_t to, size_t c,
               double first = 0, double last = 0) {
  const auto& x = r.fields.at(field);
  const size_t nodes = x.size() / 3 / r.output_times.size();
  double sum = 0, mass = 0;
  for (size_t n = from; n <= to; ++n) {
    const double m = n == from ? 5 + first : n == to ? 5 + last : 10;
    sum += m * x.at(3 * (nodes * output + n) + c), mass += m;
  }
  return sum / mass;
}

std::string error_of(const std::string& input, const std::string& file) {
  app::RunOptions o;
  o.case_path = input, o.output = file, o.quiet = true;
  try {
    app::run(MPI_COMM_WORLD, o);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

void expect_same_positions(const Results& whole, const Results& rest, double tolerance) {
  const auto& a = whole.fields.at("position");
  const auto& b = rest.fields.at("position");
  const std::vector<double> last(a.end() - static_cast<long>(b.size() / rest.output_times.size()), a.end());
  const std::vector<double> other(b.end() - static_cast<long>(last.size()), b.end());
  EXPECT_LE(largest_difference(last, other), tolerance);
}

// Stops before, at and after the event at 0.5 s; on one rank as well.
void expect_same_after_restarts(const std::string& path, const std::string& input, double tolerance) {
  run_on_all({input, path + "/whole.h5"});
  run_on_one({input, path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) == 0)
    expect_same_positions(read(path + "/whole.h5"), read(path + "/one.h5"), tolerance);
  for (const double stop : {0.25, 0.5, 0.75}) {
    run_on_all({input, path + "/half.h5", "", stop});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) == 0)
      expect_same_positions(read(path + "/whole.h5"), read(path + "/rest.h5"), tolerance);
  }
}

// A chain that hangs in air and is cut at mid-length. Nodes 0 to 10 are of its lower part, which falls.
const char* const kHanging = R"(hawser: 1
title: A chain that parts
environment: {gravity: 9.80665}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 1e-3}
lines:
  chain:
    sections: [{type: chain, length: 20, elements: 20}]
    end_a: free
    end_b: {anchor: [0, 0, 100]}
dynamics: {duration: 1, max_step: 0.01}
events:
  - {cut: {line: chain, at: 10}, time: 0.5}
output: {every: 0.25}
contact: {between_lines: false}
)";

TEST(Events, WhatIsCutOffFallsFreelyAndTheRestHangs) {
  const std::string path = folder("events-cut"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(input, kHanging);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  ASSERT_EQ(r.fields.at("position").size(), 5u * 22 * 3);
  const double rest = mean_of(r, "position", 0, 0, 10, 2), above = mean_of(r, "position", 0, 11, 21, 2);
  EXPECT_NEAR(mean_of(r, "position", 2, 0, 10, 2), rest, 1e-8);
  for (size_t i = 3; i < 5; ++i) {
    const double t = r.output_times[i] - 0.5;
    const double fallen = rest - mean_of(r, "position", i, 0, 10, 2);
    printf("cut off for %.2f s: fallen %.3g m too far\n", t, fallen - 0.5 * kGravity * t * t);
    EXPECT_NEAR(fallen, 0.5 * kGravity * t * t, 1e-5) << t;
    // It recoils by what the weight of the lower part has stretched it: w l / EA of its own length on
    // average.
    EXPECT_NEAR(mean_of(r, "position", i, 11, 21, 2), above, 2 * 10 * kGravity * 10 / 1e7 * 10);
  }
}

TEST(Events, ACutGoesOnAfterARestart) {
  const std::string path = folder("events-cut-restart"), input = path + "/case.yaml";
  write_case(input, kHanging);
  expect_same_after_restarts(path, input, 1e-8);
}

// Until then it moves as a line that is not cut does.
TEST(Events, UntilItIsCutALineIsWhole) {
  const std::string path = folder("events-whole"), input = path + "/case.yaml", other = path + "/other.yaml";
  const Edits swing = {
      {"end_a: free\n    end_b: {anchor: [0, 0, 100]}",
       "end_a: {anchor: [0, 0, 100]}\n    end_b: {anchor: [12, 3, 96]}\n    loads: [{at: 7, force: "
       "[0, 100, 0], ramp: 0.2}]"}};
  Edits none = swing;
  none.push_back({"events:\n  - {cut: {line: chain, at: 10}, time: 0.5}\n", ""});
  write_case(input, kHanging, swing), write_case(other, kHanging, none);
  run_on_all({input, path + "/cut.h5", "", 0.5});
  run_on_all({other, path + "/whole.h5", "", 0.5});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const auto cut = read(path + "/cut.h5").fields.at("position"),
             whole = read(path + "/whole.h5").fields.at("position");
  for (size_t i = 0; i < 3; ++i)
    for (size_t n = 0; n <= 20; ++n)
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(cut.at(3 * (22 * i + n + (n > 10)) + c), whole.at(3 * (21 * i + n) + c), 1e-9)
            << i << ' ' << n;
}

// A rope between two weights that floats in space under tension: its parts go on with the momentum there is.
TEST(Events, ACutKeepsMomentum) {
  const std::string path = folder("events-momentum"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(
      input, kHanging,
      {{"{gravity: 9.80665}", "{gravity: 0}"},
       {"end_a: free\n    end_b: {anchor: [0, 0, 100]}",
        "end_a: {anchor: [0, 0, 0]}\n    end_b: {anchor: [20.2, 0, 0]}\n    masses: [{at: end_a, mass: 100}, "
        "{at: end_b, mass: 300}]"},
       {"events:\n",
        "events:\n  - {release: {line: chain, end: end_a}, time: 0}\n  - {release: {line: chain, "
        "end: end_b}, time: 0.1}\n"},
       {"at: 10}, time: 0.5", "at: 10}, time: 0.15"},
       {"duration: 1", "duration: 0.4"},
       {"every: 0.25", "every: 0.05"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto momentum = [&](size_t i) {
    return 200 * mean_of(r, "velocity", i, 0, 10, 0, 100) +
           400 * mean_of(r, "velocity", i, 11, 21, 0, 0, 300);
  };
  const double before = momentum(3);
  EXPECT_GT(std::abs(before), 100);  // of the weights one was let go of first
  double off = 0;
  for (size_t i = 4; i < 9; ++i) off = std::max(off, std::abs(momentum(i) / before - 1));
  printf("a cut: momentum kept to %.1e of %.0f kg m/s\n", off, before);
  EXPECT_LT(off, 1e-6);
  EXPECT_GT(std::abs(mean_of(r, "velocity", 8, 0, 10, 0, 100) - mean_of(r, "velocity", 8, 11, 21, 0, 0, 300)),
            0.1);
}

// It parts at its tension to 0.1 %, somewhere along its length.
TEST(Events, ALineIsCutAtATension) {
  const std::string path = folder("events-cut-tension"), input = path + "/case.yaml",
                    file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A rope that is pulled until it parts
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 1, EA: 1e6, bending: false, breaking_load: 13 kN}
bodies:
  tug: {position: [10.001, 0, 0], motion: {velocity: [0.1, 0, 0], ramp: 0.5}}
lines:
  rope:
    sections: [{type: rope, length: 10, elements: 5}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {body: tug, at: [0, 0, 0]}
dynamics: {duration: 3}
events:
  - {cut: {line: rope, at: 4}, tension: 12 kN}
output: {every: 0.5, histories: [{line: rope, at: 4, name: cut}, {line: rope, at: end_b, name: end}]}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto T = named(file, r, "cut", "effective_tension"), x = named(file, r, "cut", "position_x"),
             end = named(file, r, "end", "position_x");
  const double most = *std::max_element(T.begin(), T.end());
  printf("a line is cut at 12 kN and %.4f %% more\n", 100 * (most / 12e3 - 1));
  EXPECT_GE(most, 12e3);
  EXPECT_LE(most, 12e3 * 1.001);
  EXPECT_LT(x.back(), 4.05);
  EXPECT_NEAR(end.back(), 10.001 + 0.1 * (3 - 0.25), 1e-3);  // the tug goes on
  EXPECT_LT(T.back(), 1e3);
}

// A cantilever that is cut: statics is that of the whole, twist and moment included, and its outer part
// falls.
TEST(Events, ABeamIsCut) {
  const std::string path = folder("events-beam"), input = path + "/case.yaml", other = path + "/other.yaml";
  const std::string text = R"(hawser: 1
title: A cantilever that breaks
environment: {gravity: 9.80665}
line_types:
  pipe: {outer_diameter: 0.2, mass_per_length: 10, EA: 1e8, EI: 1e5, GJ: 1e5, stiffness_damping: 1e-3}
lines:
  pipe:
    sections: [{type: pipe, length: 20, elements: 20}]
    end_a: {anchor: [0, 0, 0], direction: [1, 0, 0], clamped: true}
    end_b: free
    loads: [{at: end_b, force: [0, 20, 0], moment: [50, 0, 0]}]
dynamics: {duration: 1, max_step: 0.01}
events:
  - {cut: {line: pipe, at: 8}, time: 0.5}
output: {every: 0.25, histories: [{line: pipe, at: 8, name: cut}]}
contact: {between_lines: false}
)";
  write_case(input, text);
  write_case(other, text, {{"events:\n  - {cut: {line: pipe, at: 8}, time: 0.5}\n", ""}});
  run_on_all({input, path + "/cut.h5"});
  run_on_all({other, path + "/uncut.h5", "", 0.25});
  expect_same_after_restarts(path, input, 1e-7);
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(path + "/cut.h5");
  const auto& cut = r.fields.at("position");
  const auto whole = read(path + "/uncut.h5").fields.at("position");
  for (size_t n = 0; n <= 20; ++n)
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(cut.at(3 * (n + (n > 8)) + c), whole.at(3 * n + c), 1e-7) << n;
  const double rest = mean_of(r, "position", 2, 9, 21, 2);
  // Its nodes stand for its axis, to what an element is bent.
  const double t = 0.5, side = 20 / 120.0;
  EXPECT_NEAR(mean_of(r, "position", 4, 9, 21, 2), rest - 0.5 * kGravity * t * t, 2e-3);
  EXPECT_NEAR(mean_of(r, "position", 4, 9, 21, 1) - mean_of(r, "position", 2, 9, 21, 1), 0.5 * side * t * t,
              2e-3);
  const auto M = named(path + "/cut.h5", r, "cut", "bending_moment");
  EXPECT_GT(M.front(), 4e3);  // of the 12 m beyond
  EXPECT_LT(M.back(), 10);
}

// A body in space that catches the end of a rope at rest: a plastic impact keeps the momentum.
TEST(Events, AnAttachmentKeepsMomentum) {
  const std::string path = folder("events-attach"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A body that catches a rope
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e5, bending: false, stiffness_damping: 0.01}
bodies:
  load: {position: [0, 0, 1], floating: {mass: 100, inertia: [50, 50, 50], velocity: [2, 0, 0]}}
lines:
  rope:
    sections: [{type: rope, length: 5, elements: 5}]
    end_a: free
    end_b: free
    start: {points: [[1, 0, 1], [6, 0, 1]]}
statics: false
dynamics: {duration: 1, max_step: 0.005}
events:
  - {attach: {line: rope, end: end_a, body: load, at: [0, 0, 0], within: 0.05}, time: 0.5}
output: {every: 0.25, histories: [{body: load}]}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  expect_same_after_restarts(path, input, 1e-8);
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto v = named(file, r, "load", "velocity_x"), x = named(file, r, "load", "position_x");
  const auto kinetic = named(file, r, "energy", "kinetic"), error = named(file, r, "energy", "error");
  for (size_t i = 2; i < 5; ++i) {
    const auto step = std::find_if(r.step_times.begin(), r.step_times.end(),
                                   [&](double t) { return t > r.output_times[i] - 1e-9; });
    const size_t s = static_cast<size_t>(step - r.step_times.begin());
    EXPECT_NEAR(100 * v[s] + 50 * mean_of(r, "velocity", i, 0, 5, 0), 200, 1e-5) << i;
  }
  EXPECT_NEAR(kinetic.front(), 200, 1e-9);
  // The end's 5/12 m of 10 kg were at rest; the consistent part of the mass takes 1/12 m of the next node's.
  EXPECT_LT(kinetic.back(), 200 - 3);
  printf("a body catches a rope: of 200 J %.2f are lost in the impact and by damping, error %.1e J\n",
         200 - kinetic.back() - named(file, r, "energy", "strain").back(), largest(error));
  for (const double e : error) EXPECT_LT(std::abs(e), 0.2);
  // It goes with the body.
  EXPECT_NEAR(r.fields.at("position").at(3 * 6 * 4), x.back(), 1e-9);
}

// A weight that falls past a hook and is caught as soon as it is near enough, and held where it is.
TEST(Events, AnEndIsAttachedWhenItIsNear) {
  const std::string path = folder("events-near"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(input, kHanging,
             {{"{cut: {line: chain, at: 10}, time: 0.5}",
               "{release: {line: chain, end: end_b}, time: 0.1}\n  - {attach: {line: chain, end: end_b, at: "
               "[0.3, 0, "
               "99], within: 0.5}}"},
              {"every: 0.25", "every: 0.1, histories: [{line: chain, at: end_b, name: end}]"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto z = named(file, r, "end", "position_z");
  EXPECT_NEAR(z.back(), 99.4, 2e-3);  // 0.3 aside, 0.4 above
  for (size_t i = 0; i < z.size(); ++i)
    if (r.step_times[i] > 0.6) {
      EXPECT_NEAR(z[i], z.back(), 1e-12);
    }
}

TEST(Events, AnEndThatIsNotWhereItIsToBeAttachedStopsTheRun) {
  const std::string path = folder("events-far"), input = path + "/case.yaml";
  write_case(input, kHanging,
             {{"{cut: {line: chain, at: 10}, time: 0.5}",
               "{attach: {line: chain, end: end_a, at: [0, 0, 79], within: 0.5}, time: 0.5}"}});
  const std::string why = error_of(input, path + "/whole.h5");
  EXPECT_NE(why.find("end A of line chain is to be attached, but it is 0.998 m"), std::string::npos) << why;
}

// A wire that is paid out from 0.5 s on until 0.4 m are out, rests, and then keeps a tension.
TEST(Events, AWinchStartsStopsAndKeepsATension) {
  const std::string path = folder("events-winch"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A winch
environment: {gravity: 9.80665}
line_types:
  wire: {outer_diameter: 0.02, mass_per_length: 2, EA: 1e6, bending: false, stiffness_damping: 0.01}
lines:
  wire:
    sections: [{type: wire, length: 20, elements: 20}]
    end_a: {anchor: [0, 0, 20], feed: {stock: 10, speed: 0}}
    end_b: free
    masses: [{at: end_b, mass: 200}]
dynamics: {duration: 2.5, max_step: 0.01}
events:
  - {name: start, feed: {line: wire, end: end_a, speed: 0.5, ramp: 0.2}, time: 0.5}
  - {name: stop, feed: {line: wire, end: end_a, speed: 0, ramp: 0.1}, when: {paid_out: {line: wire, end: end_a, above: 0.4}}}
  - {feed: {line: wire, end: end_a, tension: 2 kN, speed_per_tension: 1e-3}, after: stop, delay: 0.5}
output: {every: 0.25}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  for (const double stop : {0.5, 1.25, 2.25}) {
    run_on_all({input, path + "/half.h5", "", stop});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) == 0) expect_same_positions(read(file), read(path + "/rest.h5"), 1e-7);
  }
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto out = named(file, r, "wire_end_a_feed", "paid_out"),
             v = named(file, r, "wire_end_a_feed", "feed_speed");
  const auto error = named(file, r, "energy", "error"), in = named(file, r, "energy", "brought_in");
  for (size_t i = 0; i < out.size(); ++i) {
    const double t = r.step_times[i];
    if (t < 0.5) {
      EXPECT_NEAR(out[i], 0, 1e-12);
    }
    if (t > 0.7 && t < 1.3) {
      EXPECT_NEAR(out[i], 0.05 + 0.5 * (t - 0.7), 1e-9) << t;
    }
    if (t > 1.55 && t < 1.88) {  // it has come to rest after 0.4 m, 1 mm at most, and 0.1 s at half its speed
      EXPECT_NEAR(v[i], 0, 1e-12) << t;
      EXPECT_GE(out[i], 0.425) << t;
      EXPECT_LE(out[i], 0.4262) << t;
    }
  }
  EXPECT_GT(v.back(), 0.01);  // 2.16 kN pull at 2 kN
  for (size_t i = 0; i < error.size(); ++i)
    EXPECT_LT(std::abs(error[i]), 0.02 * largest(in)) << r.step_times[i];
}

// A floor under a rope at rest: nothing happens when it is there, and it holds the rope when that is let go.
const char* const kFloor = R"(hawser: 1
title: A rope over a floor
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 1e-3}
volumes:
  floor: {shape: {box: {centre: [5, 0, -1.5], size: [30, 20, 1]}}, normal_stiffness: {per_length: 1e5}, relative_damping: 0.5}
lines:
  rope:
    sections: [{type: rope, length: 10, elements: 10}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [9.99, 0, 0]}
dynamics: {duration: 1.5, max_step: 0.01}
events:
  - {name: on, contact: {volume: floor, enabled: true}, time: 0.25}
  - {release: {line: rope, end: end_a}, after: on, delay: 0.25}
  - {release: {line: rope, end: end_b}, after: on, delay: 0.25}
output: {every: 0.25}
contact: {between_lines: false}
)";

double lowest(const Results& r, size_t output) {
  double z = HUGE_VAL;
  for (size_t n = 0; n <= 10; ++n) z = std::min(z, r.fields.at("position").at(3 * (11 * output + n) + 2));
  return z;
}

TEST(Events, AVolumeIsSwitchedOn) {
  const std::string path = folder("events-volume"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(input, kFloor);
  run_on_all({input, file});
  expect_same_after_restarts(path, input, 1e-6);
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const double rest = lowest(r, 0);
  EXPECT_NEAR(lowest(r, 1), rest, 1e-8);
  EXPECT_NEAR(lowest(r, 2), rest, 1e-8);
  EXPECT_NEAR(lowest(r, 6), -0.95, 0.02);  // its axis is half a diameter above
}

// Off again, what lies on it falls; what its contact held goes with it and is accounted for.
TEST(Events, AVolumeIsSwitchedOff) {
  const std::string path = folder("events-off"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(
      input, kFloor,
      {{"centre: [5, 0, -1.5], size: [30, 20, 1]", "centre: [5, 0, -1.2], size: [30, 20, 1.6]"},
       {"  - {name: on, contact: {volume: floor, enabled: true}, time: 0.25}\n  - {release: {line: rope, "
        "end: "
        "end_a}, after: on, delay: 0.25}\n  - {release: {line: rope, end: end_b}, after: on, delay: 0.25}\n",
        "  - {release: {line: rope, end: end_a}, time: 0}\n  - {release: {line: rope, end: end_b}, time: "
        "0}\n  "
        "- {contact: {volume: floor, enabled: false}, time: 1}\n"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  EXPECT_NEAR(lowest(r, 4), -0.35, 0.02);
  EXPECT_NEAR(lowest(r, 6), lowest(r, 4) - 0.5 * kGravity * 0.25, 0.02);
  const auto error = named(file, r, "energy", "error"), in = named(file, r, "energy", "brought_in");
  EXPECT_LT(largest(error), 0.02 * largest(in));
}

// In a line at rest it would be struck.
TEST(Events, AVolumeIsNotSwitchedOnAroundALine) {
  const std::string path = folder("events-around"), input = path + "/case.yaml";
  write_case(input, kFloor,
             {{"centre: [5, 0, -1.5], size: [30, 20, 1]", "centre: [5, 0, -0.5], size: [30, 20, 3]"}});
  const std::string why = error_of(input, path + "/whole.h5");
  EXPECT_NE(why.find("contact with volume floor is to be switched on, but line rope is inside it"),
            std::string::npos)
      << why;
}

// At a position of a body, to 1 mm, and so much later.
TEST(Events, OneAfterAnother) {
  const std::string path = folder("events-after"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(
      input, kHanging,
      {{"lines:\n", "bodies:\n  ship: {position: [0, 0, 100], motion: {velocity: [0.1, 0, 0]}}\nlines:\n"},
       {"{cut: {line: chain, at: 10}, time: 0.5}",
        "{name: here, cut: {line: chain, at: 10}, when: {position: {body: ship, axis: x, above: 0.03}}}\n  - "
        "{release: {line: chain, end: end_b}, after: here, delay: 0.2}"},
       {"every: 0.25",
        "every: 0.1, histories: [{line: chain, at: end_b, name: end}, {line: chain, at: end_a, "
        "name: low}]"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const double rest = mean_of(r, "position", 0, 0, 10, 2);
  const double fell = rest - mean_of(r, "position", 10, 0, 10, 2), from = 1 - std::sqrt(2 * fell / kGravity);
  EXPECT_GE(from, 0.3 - 1e-6);
  EXPECT_LE(from, 0.31);
  const auto z = named(file, r, "end", "position_z");
  for (size_t i = 0; i < z.size(); ++i)
    if (r.step_times[i] < from + 0.2 - 1e-6) {
      EXPECT_NEAR(z[i], 100, 1e-12);
    }
  EXPECT_LT(z.back(), 99.9);
}

// A weight that hangs on two legs, one of which lets go in a stage of statics, hangs straight down
// afterwards.
TEST(Events, AStageOfStatics) {
  const std::string path = folder("events-stage"), input = path + "/case.yaml", file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A weight on two legs
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 1, EA: 1e6, bending: false}
joints:
  shackle: {start: [0, 0, -3]}
lines:
  leg 1:
    sections: [{type: rope, length: 5, elements: 5}]
    end_a: {anchor: [-4, 0, 0]}
    end_b: {joint: shackle}
  leg 2:
    sections: [{type: rope, length: 5, elements: 5}]
    end_a: {anchor: [4, 0, 0]}
    end_b: {joint: shackle}
  weight:
    sections: [{type: rope, length: 1, elements: 1}]
    end_a: {joint: shackle}
    end_b: free
    masses: [{at: end_b, mass: 100}]
stages: [two legs, one leg]
events:
  - {release: {line: leg 2, end: end_b}, stage: one leg}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const auto& x = read(file).fields.at("position");
  EXPECT_NEAR(x.at(3 * 5), -4, 1e-6);
  const double weight = kGravity * (100 + 1), own = kGravity * 5;
  EXPECT_NEAR(x.at(3 * 5 + 2), -5 - 5 * (weight + own / 2) / 1e6, 1e-5);
  EXPECT_NEAR(x.at(3 * 11), 4, 1e-6);
  EXPECT_NEAR(x.at(3 * 11 + 2), -5 - 5 * own / 2 / 1e6, 1e-5);
}

}  // namespace
}  // namespace hawser::runs::events
