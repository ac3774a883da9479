// Winches that start and stop during a run, contact with volumes switched on and off, events that depend on
// others, stages of statics; restarts around them.
#include "hawser/io/checkpoint.hpp"
#include "regression/event_runs.hpp"

namespace hawser::runs::events {
namespace {

// A wire is paid out from 0.5 s until 0.4 m are out, stands still, and then a tension is kept.
TEST(Events, AWinchStartsStopsAndKeepsATension) {
  const std::string path = folder("events-winch");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  const auto out = named(file, r, "wire_end_a_feed", "paid_out");
  const auto v = named(file, r, "wire_end_a_feed", "feed_speed");
  const auto error = named(file, r, "energy", "error");
  const auto in = named(file, r, "energy", "brought_in");
  for (size_t i = 0; i < out.size(); ++i) {
    const double t = r.step_times[i];
    if (t < 0.5) {
      EXPECT_NEAR(out[i], 0, 1e-12);
    }
    if (t > 0.7 && t < 1.3) {
      EXPECT_NEAR(out[i], 0.05 + 0.5 * (t - 0.7), 1e-9) << t;
    }
    if (t > 1.55 && t < 1.88) {  // stop at 0.4 m, 1 mm late at most, plus 0.1 s at half the speed
      EXPECT_NEAR(v[i], 0, 1e-12) << t;
      EXPECT_GE(out[i], 0.425) << t;
      EXPECT_LE(out[i], 0.4262) << t;
    }
  }
  EXPECT_GT(v.back(), 0.01);  // 2.16 kN pull against 2 kN
  for (size_t i = 0; i < error.size(); ++i)
    EXPECT_LT(std::abs(error[i]), 0.02 * largest(in)) << r.step_times[i];
}

// The winch hauls in until its tension is 100 kN, within 0.1 %. The stop then causes waves along the line.
TEST(Events, AWinchStopsAtATension) {
  const std::string path = folder("events-winch-tension");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, R"(hawser: 1
title: A winch that stops at a tension
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 0.02}
lines:
  rope:
    sections: [{type: rope, length: 60, elements: 30}]
    end_a: {anchor: [0, 0, 100], feed: {stock: 30.5, speed: -0.1}}
    end_b: {anchor: [0, 0, 71]}
dynamics: {duration: 10, max_step: 0.2}
events:
  - {feed: {line: rope, end: end_a, speed: 0}, when: {tension: {line: rope, at: end_a, above: 100 kN}}}
output: {every: 1, histories: [{line: rope, at: end_a, name: winch}]}
contact: {between_lines: false}
)");
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto T = named(file, r, "winch", "effective_tension");
  const auto stops = std::find_if(T.begin(), T.end(), [](double tension) { return tension >= 1e5; });
  ASSERT_NE(stops, T.end());
  printf("a winch stops at 100 kN and %.4f %% more\n", 100 * (*stops / 1e5 - 1));
  EXPECT_LE(*stops, 1.001e5);
}

// A floor under a rope at rest: switching it on has no effect at first, and it carries the rope when this is
// released.
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
  const std::string path = folder("events-volume");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kFloor);
  run_on_all({input, file});
  expect_same_after_restarts(path, input, 1e-6);
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const double rest = lowest(r, 0);
  EXPECT_NEAR(lowest(r, 1), rest, 1e-8);
  EXPECT_NEAR(lowest(r, 2), rest, 1e-8);
  EXPECT_NEAR(lowest(r, 6), -0.95, 0.02);  // the axis is half a diameter above the floor
}

// An end inside a volume that is switched on later has its length without contact, too.
TEST(Events, AnEndInsideAVolumeThatIsSwitchedOn) {
  const std::string path = folder("events-inside");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kFloor,
             {{"centre: [5, 0, -1.5], size: [30, 20, 1]", "centre: [0, 0, -0.2], size: [1, 1, 1]"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_EQ(read(file).output_times.back(), 1.5);
}

// A floor is switched off: the rope on it falls, and the elastic energy of the contact is in the energy
// balance.
TEST(Events, AVolumeIsSwitchedOff) {
  const std::string path = folder("events-off");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  const auto error = named(file, r, "energy", "error");
  const auto in = named(file, r, "energy", "brought_in");
  EXPECT_LT(largest(error), 0.02 * largest(in));
}

// Switching on a volume around a line is an error, because it would be an impact.
TEST(Events, AVolumeIsNotSwitchedOnAroundALine) {
  const std::string path = folder("events-around");
  const std::string input = path + "/case.yaml";
  write_case(input, kFloor,
             {{"centre: [5, 0, -1.5], size: [30, 20, 1]", "centre: [5, 0, -0.5], size: [30, 20, 3]"}});
  const std::string why = error_of(input, path + "/whole.h5");
  EXPECT_NE(why.find("contact with volume floor is to be switched on, but line rope is inside it"),
            std::string::npos)
      << why;
}

// After this error the checkpoint contains none of the events of that instant.
TEST(Events, WhatIsRefusedTakesAllOfItsInstantBack) {
  const std::string path = folder("events-back");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kFloor,
             {{"centre: [5, 0, -1.5], size: [30, 20, 1]", "centre: [5, 0, -0.5], size: [30, 20, 3]"},
              {"  - {name: on,",
               "  - {name: let go, release: {line: rope, end: end_b}, time: 0.25}\n  - {name: on,"},
              {"  - {release: {line: rope, end: end_b}, after: on, delay: 0.25}\n", ""}});
  EXPECT_NE(error_of(input, file).find("is to be switched on, but"), std::string::npos);
  std::vector<int> owned;  // 11 nodes
  for (int n = 0; n < 11 && rank_of(MPI_COMM_WORLD) == 0; ++n) owned.push_back(n);
  const io::Checkpoint c = io::read_checkpoint(MPI_COMM_WORLD, file, 11, owned);
  EXPECT_NEAR(c.time, 0.25, 1e-9);
  EXPECT_FALSE(c.scalars.count("event.let go"));
  EXPECT_FALSE(c.scalars.count("event.on"));
}

// An event at a position of a body, within 1 mm, and another one after a delay.
TEST(Events, OneAfterAnother) {
  const std::string path = folder("events-after");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  const double drop = rest - mean_of(r, "position", 10, 0, 10, 2);
  const double from = 1 - std::sqrt(2 * drop / kGravity);
  EXPECT_GE(from, 0.3 - 1e-6);
  EXPECT_LE(from, 0.31);
  const auto z = named(file, r, "end", "position_z");
  for (size_t i = 0; i < z.size(); ++i)
    if (r.step_times[i] < from + 0.2 - 1e-6) {
      EXPECT_NEAR(z[i], 100, 1e-12);
    }
  EXPECT_LT(z.back(), 99.9);
}

// A leg released in a stage of statics falls on the bed, where many shapes are possible. One rank and two
// find the same one, and a note reports that there are others.
TEST(Events, ALegThatFallsInAStageLiesWhereRanksAgree) {
  const std::string path = folder("events-fallen");
  const std::string input = path + "/case.yaml";
  write_case(input, R"(hawser: 1
title: Two legs, one of which falls
environment: {water: {density: 1025, depth: 100}, seabed: {depth: 100}}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 500 MN, bending: false}
lines:
  leg 1: {sections: [{type: chain, length: 200, elements: 60}], end_a: {anchor: [-160, 0, -100]}, end_b: {anchor: [0, 0, 0]}}
  leg 2: {sections: [{type: chain, length: 200, elements: 60}], end_a: {anchor: [160, 0, -100]}, end_b: {anchor: [0, 0, 0]}}
stages: [two legs, one leg]
events:
  - {release: {line: leg 2, end: end_b}, stage: one leg}
)");
  run_on_all({input, path + "/all.h5"});
  run_on_one({input, path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results all = read(path + "/all.h5");
  const Results one = read(path + "/one.h5");
  EXPECT_LT(largest_difference(all.fields.at("position"), one.fields.at("position")), 1e-6);
  std::string message;
  const auto file = io::h5::open_read(path + "/all.h5");
  for (const std::string& m : io::h5::read_texts(file, "messages")) message += m + "\n";
  EXPECT_NE(message.find("lines.leg 2: "), std::string::npos) << message;
  EXPECT_NE(message.find("have no tension at rest and can rest in other positions as well"),
            std::string::npos)
      << message;
}

// A weight hangs on two legs, one of which is released in a stage of statics: it then hangs vertically on the
// other.
TEST(Events, AStageOfStatics) {
  const std::string path = folder("events-stage");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
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
  // The first stage is at -1 s, the second at 0.
  const std::vector<double> both = read(file).fields.at("position");
  const std::vector<double> x(both.begin() + std::ssize(both) / 2, both.end());
  EXPECT_NEAR(x.at(3 * 5), -4, 1e-6);
  const double weight = kGravity * (100 + 1), own = kGravity * 5;
  EXPECT_NEAR(x.at(3 * 5 + 2), -5 - 5 * (weight + own / 2) / 1e6, 1e-5);
  EXPECT_NEAR(x.at(3 * 11), 4, 1e-6);
  EXPECT_NEAR(x.at(3 * 11 + 2), -5 - 5 * own / 2 / 1e6, 1e-5);
}

}  // namespace
}  // namespace hawser::runs::events
