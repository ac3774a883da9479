// Events that cut lines and attach ends during a run, and restarts around them.
#include "regression/event_runs.hpp"

namespace hawser::runs::events {
namespace {

TEST(Events, WhatIsCutOffFallsFreelyAndTheRestHangs) {
  const std::string path = folder("events-cut");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kHanging);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  ASSERT_EQ(r.fields.at("position").size(), 5u * 22 * 3);
  const double rest = mean_of(r, "position", 0, 0, 10, 2);
  const double above = mean_of(r, "position", 0, 11, 21, 2);
  EXPECT_NEAR(mean_of(r, "position", 2, 0, 10, 2), rest, 1e-8);
  for (size_t i = 3; i < 5; ++i) {
    const double t = r.output_times[i] - 0.5;
    const double fallen = rest - mean_of(r, "position", i, 0, 10, 2);
    printf("cut off for %.2f s: fallen %.3g m too far\n", t, fallen - 0.5 * kGravity * t * t);
    EXPECT_NEAR(fallen, 0.5 * kGravity * t * t, 1e-5) << t;
    // The upper part recoils by its mean elongation under the weight of the lower part, w l / EA of its
    // length.
    EXPECT_NEAR(mean_of(r, "position", i, 11, 21, 2), above, 2 * 10 * kGravity * 10 / 1e7 * 10);
  }
}

TEST(Events, ACutGoesOnAfterARestart) {
  const std::string path = folder("events-cut-restart");
  const std::string input = path + "/case.yaml";
  write_case(input, kHanging);
  expect_same_after_restarts(path, input, 1e-8);
}

// Of two events at one instant the second stands first in the list: a restart repeats them in their order in
// time.
TEST(Events, TwoOfAnInstantGoOnInTheirOrderAfterARestart) {
  const std::string path = folder("events-order");
  const std::string input = path + "/case.yaml";
  write_case(input, kHanging,
             {{"end_a: free", "end_a: {anchor: [9, 0, 90]}"},
              {"  - {cut: {line: chain, at: 10}, time: 0.5}",
               "  - {attach: {line: chain, end: end_a}, after: let go}\n  - {name: let go, release: {line: "
               "chain, end: end_a}, time: 0.5}"}});
  expect_same_after_restarts(path, input, 1e-8);
}

// A buoy in waves whose mooring is cut: a restart from that instant has the same work.
TEST(Events, ACutInWavesGoesOnAfterARestart) {
  const std::string path = folder("events-waves");
  const std::string input = path + "/case.yaml";
  write_case(input, R"(hawser: 1
title: A buoy in waves whose mooring is cut
environment:
  water: {density: 1025, depth: 60}
  waves: {jonswap: {hs: 3, tp: 9, direction_deg: 0, seed: 5}, ramp: 0.2}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 60, EA: 1e8, bending: false, stiffness_damping: 1e-3, Cd_normal: 1.2, Ca_normal: 1}
bodies:
  buoy:
    position: [0, 0, -1]
    floating:
      mass: 180 t
      inertia: [1.5e6, 1.5e6, 2.5e6]
      weight: true
      turning_stiffness: [2e7, 2e7, 1e6]
      in_water: {volume: 300, height: 5, drag_area: [30, 30, 80], Cd: [1.0, 1.0, 1.2], Ca: [0.6, 0.6, 1.0]}
lines:
  chain:
    sections: [{type: chain, length: 50, elements: 10}]
    end_a: {anchor: [-35, 0, -30]}
    end_b: {body: buoy, at: [-2, 0, 0]}
dynamics: {duration: 1, max_step: 0.05}
events:
  - {cut: {line: chain, at: 25}, time: 0.5}
output: {every: 0.25}
contact: {between_lines: false}
)");
  expect_same_after_restarts(path, input, 1e-5);
  run_on_all({input, path + "/half.h5", "", 0.5});
  run_on_all({input, path + "/rest.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const auto brought_in = [&](const std::string& file) {
    return named(file, read(file), "energy", "brought_in").back();
  };
  const double whole = brought_in(path + "/whole.h5");
  const double rest = brought_in(path + "/rest.h5");
  printf("brought in: %.9g J, after a restart %.3g J more\n", whole, rest - whole);
  EXPECT_NEAR(rest, whole, 1e-8 * whole);
}

// Before its cut a line moves as one without the event.
TEST(Events, UntilItIsCutALineIsWhole) {
  const std::string path = folder("events-whole");
  const std::string input = path + "/case.yaml";
  const std::string other = path + "/other.yaml";
  const Edits swing = {
      {"end_a: free\n    end_b: {anchor: [0, 0, 100]}",
       "end_a: {anchor: [0, 0, 100]}\n    end_b: {anchor: [12, 3, 96]}\n    loads: [{at: 7, force: "
       "[0, 100, 0], ramp: 0.2}]"}};
  Edits none = swing;
  none.push_back({"events:\n  - {cut: {line: chain, at: 10}, time: 0.5}\n", ""});
  write_case(input, kHanging, swing);
  write_case(other, kHanging, none);
  run_on_all({input, path + "/cut.h5", "", 0.5});
  run_on_all({other, path + "/whole.h5", "", 0.5});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const auto cut = read(path + "/cut.h5").fields.at("position");
  const auto whole = read(path + "/whole.h5").fields.at("position");
  for (size_t i = 0; i < 3; ++i)
    for (size_t n = 0; n <= 20; ++n)
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(cut.at(3 * (22 * i + n + (n > 10)) + c), whole.at(3 * (21 * i + n) + c), 1e-9)
            << i << ' ' << n;
}

// A rope between two weights moves freely under tension and is cut: the total momentum is constant.
TEST(Events, ACutKeepsMomentum) {
  const std::string path = folder("events-momentum");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  EXPECT_GT(std::abs(before), 100);  // one weight was released earlier
  double off = 0;
  for (size_t i = 4; i < 9; ++i) off = std::max(off, std::abs(momentum(i) / before - 1));
  printf("a cut: momentum kept to %.1e of %.0f kg m/s\n", off, before);
  EXPECT_LT(off, 1e-6);
  EXPECT_GT(std::abs(mean_of(r, "velocity", 8, 0, 10, 0, 100) - mean_of(r, "velocity", 8, 11, 21, 0, 0, 300)),
            0.1);
}

// The rope is cut when the tension at the given place reaches its limit, within 0.1 %.
TEST(Events, ALineIsCutAtATension) {
  const std::string path = folder("events-cut-tension");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  const auto T = named(file, r, "cut", "effective_tension");
  const auto x = named(file, r, "cut", "position_x");
  const auto end = named(file, r, "end", "position_x");
  const double most = *std::max_element(T.begin(), T.end());
  printf("a line is cut at 12 kN and %.4f %% more\n", 100 * (most / 12e3 - 1));
  EXPECT_GE(most, 12e3);
  EXPECT_LE(most, 12e3 * 1.001);
  EXPECT_LT(x.back(), 4.05);
  EXPECT_NEAR(end.back(), 10.001 + 0.1 * (3 - 0.25), 1e-3);  // the tug continues its motion
  EXPECT_LT(T.back(), 1e3);
}

// A cantilever that is cut: statics is that of the uncut line, including torsion and moment; then its outer
// part falls.
TEST(Events, ABeamIsCut) {
  const std::string path = folder("events-beam");
  const std::string input = path + "/case.yaml";
  const std::string other = path + "/other.yaml";
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
  // The nodes represent the axis within the deflection of an element.
  const double t = 0.5, side = 20 / 120.0;
  EXPECT_NEAR(mean_of(r, "position", 4, 9, 21, 2), rest - 0.5 * kGravity * t * t, 2e-3);
  EXPECT_NEAR(mean_of(r, "position", 4, 9, 21, 1) - mean_of(r, "position", 2, 9, 21, 1), 0.5 * side * t * t,
              2e-3);
  const auto M = named(path + "/cut.h5", r, "cut", "bending_moment");
  EXPECT_GT(M.front(), 4e3);  // by the outer 12 m
  EXPECT_LT(M.back(), 10);
}

// A moving body catches the end of a rope at rest: a plastic impact conserves momentum.
TEST(Events, AnAttachmentKeepsMomentum) {
  const std::string path = folder("events-attach");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  const auto v = named(file, r, "load", "velocity_x");
  const auto x = named(file, r, "load", "position_x");
  const auto kinetic = named(file, r, "energy", "kinetic");
  const auto error = named(file, r, "energy", "error");
  for (size_t i = 2; i < 5; ++i) {
    const auto step = std::find_if(r.step_times.begin(), r.step_times.end(),
                                   [&](double t) { return t > r.output_times[i] - 1e-9; });
    const size_t s = static_cast<size_t>(step - r.step_times.begin());
    EXPECT_NEAR(100 * v[s] + 50 * mean_of(r, "velocity", i, 0, 5, 0), 200, 1e-5) << i;
  }
  EXPECT_NEAR(kinetic.front(), 200, 1e-9);
  // The end's 5/12 m of 10 kg were at rest; 1/12 m of the consistent mass belongs to the next node.
  EXPECT_LT(kinetic.back(), 200 - 3);
  printf("a body catches a rope: of 200 J %.2f are lost in the impact and by damping, error %.1e J\n",
         200 - kinetic.back() - named(file, r, "energy", "strain").back(), largest(error));
  for (const double e : error) EXPECT_LT(std::abs(e), 0.2);
  // The end moves with the body.
  EXPECT_NEAR(r.fields.at("position").at(3 * 6 * 4), x.back(), 1e-9);
}

// A falling weight is caught as soon as it is near a hook, and held at that position.
TEST(Events, AnEndIsAttachedWhenItIsNear) {
  const std::string path = folder("events-near");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  EXPECT_NEAR(z.back(), 99.4, 2e-3);  // 0.3 m aside, 0.4 m above the hook
  for (size_t i = 0; i < z.size(); ++i)
    if (r.step_times[i] > 0.6) {
      EXPECT_NEAR(z[i], z.back(), 1e-12);
    }
}

TEST(Events, AnEndThatIsNotWhereItIsToBeAttachedStopsTheRun) {
  const std::string path = folder("events-far");
  const std::string input = path + "/case.yaml";
  write_case(input, kHanging,
             {{"{cut: {line: chain, at: 10}, time: 0.5}",
               "{attach: {line: chain, end: end_a, at: [0, 0, 79], within: 0.5}, time: 0.5}"}});
  const std::string why = error_of(input, path + "/whole.h5");
  EXPECT_NE(why.find("end A of line chain is to be attached, but it is 0.998 m"), std::string::npos) << why;
}

// When a damped wire is cut, its parts whip and steps become short; strain rates then have an error near the
// tolerance of the balance. The upper part recoils, slackens and hangs: its tension never exceeds 1.05 of
// that at rest. Its warning concerns the lower part only, which whips.
TEST(Events, ADampedWireThatIsCutGoesOn) {
  const std::string path = folder("events-wire");
  const std::string input = path + "/case.yaml";
  write_case(input, R"(hawser: 1
line_types: {wire: {outer_diameter: 0.06, mass_per_length: 15, EA: 20 MN, bending: false, stiffness_damping: 0.01}}
lines: {hoist: {sections: [{type: wire, length: 40, elements: 40}], end_a: {anchor: [0, 0, 20]}, end_b: {anchor: [10, 0, -18.85]}}}
events: [{cut: {line: hoist, at: 20}, time: 1}]
dynamics: {duration: 4}
)");
  run_on_all({input, path + "/whole.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(path + "/whole.h5");
  EXPECT_NEAR(r.output_times.back(), 4, 1e-9);
  const double at_rest = r.fields.at("effective_tension").front();
  printf("largest tension of the upper part %.4g kN, at rest %.4g kN\n", r.summary.at(0) / 1000,
         at_rest / 1000);
  EXPECT_LT(r.summary.at(0), 1.05 * at_rest);
  std::string message;
  const auto written = io::h5::open_read(path + "/whole.h5");
  for (const std::string& m : io::h5::read_texts(written, "messages")) message += m + "\n";
  EXPECT_NE(message.find("largest tension of line hoist part 2"), std::string::npos) << message;
  EXPECT_EQ(message.find("largest tension of line hoist ("), std::string::npos) << message;
}

// The state after an event is evaluated in motion: damping of a line that a winch pays out must not see the
// winch at rest, which would give a tension of 23 kN instead of 12 kN for one instant and trigger the other
// event.
TEST(Events, AWinchThatRunsOnCausesNoOtherEvent) {
  const std::string path = folder("events-winch");
  const std::string input = path + "/case.yaml";
  write_case(input, R"(hawser: 1
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 0.02}
lines:
  rope:
    sections: [{type: rope, length: 60, elements: 30}]
    end_a: {anchor: [0, 0, 100], feed: {stock: 40, speed_table: [[0, 0], [2, 1], [20, 1]]}}
    end_b: free
    masses: [{at: end_b, mass: 1000}]
  other:
    sections: [{type: rope, length: 8, elements: 4}]
    end_a: {anchor: [20, 0, 100]}
    end_b: {anchor: [27, 0, 100]}
events:
  - {feed: {line: rope, end: end_a, speed: 1}, time: 4}
  - {release: {line: other, end: end_b}, when: {tension: {line: rope, at: end_a, above: 16 kN}}}
dynamics: {duration: 4.5}
output: {every: 0.5}
contact: {between_lines: false}
)");
  run_on_all({input, path + "/whole.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(path + "/whole.h5");
  EXPECT_NEAR(r.output_times.back(), 4.5, 1e-9);
  const auto& position = r.fields.at("position");
  EXPECT_EQ(position.back(), 100);  // end B of the other line is still held
}

}  // namespace
}  // namespace hawser::runs::events
