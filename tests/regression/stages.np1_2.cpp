// Stages of statics: lines paid out and hauled in, scaled currents, friction on and off, and the equilibria
// of all stages in the results; on 1 and 2 ranks.
#include "regression/event_runs.hpp"

namespace hawser::runs::stages {
namespace {

using events::error_of;

// Positions of an output.
std::vector<double> shape(const Results& r, size_t output) {
  const auto& x = r.fields.at("position");
  const size_t size = x.size() / r.output_times.size();
  return {x.begin() + static_cast<std::ptrdiff_t>(output * size),
          x.begin() + static_cast<std::ptrdiff_t>((output + 1) * size)};
}

double largest_from(const std::vector<double>& a, const std::vector<double>& b, size_t node) {
  double most = 0;
  for (size_t i = 3 * node; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// A line between a winch and an anchor; `STOCK` metres are inside.
std::string line(const std::string& type, const std::string& end, const std::string& more) {
  return R"(hawser: 1
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, )" +
         type + R"(}
lines:
  rope:
    sections: [{type: rope, length: 100, elements: 50}]
    end_a: {anchor: [0, 0, 0], )" +
         end + R"(, feed: {stock: STOCK, speed: 0}}
    end_b: {anchor: [60, 0, -10]}
contact: {between_lines: false}
)" + more;
}

// A stage that pays out or hauls in has the equilibrium of a case with that stock, at the nodes outside in
// both.
void expect_another_stock(const std::string& name, const std::string& type, const std::string& end) {
  const std::string path = folder("stages-" + name);
  const std::string input = path + "/case.yaml";
  const std::string known = path + "/known.yaml";
  for (const auto& [from, by, to] : {std::tuple("20", "15.3", "4.7"), {"4.7", "-15.3", "20"}}) {
    write_case(input,
               line(type, end,
                    "stages: [given, moved]\nevents:\n  - {feed: {line: rope, end: end_a, paid_out: BY}, "
                    "stage: moved}\n"),
               {{"STOCK", from}, {"BY", by}});
    write_case(known, line(type, end, ""), {{"STOCK", to}});
    run_on_all({input, path + "/staged.h5"});
    run_on_all({known, path + "/known.h5"});
    write_case(known, line(type, end, ""), {{"STOCK", from}});
    run_on_all({known, path + "/before.h5"});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results staged = read(path + "/staged.h5");
    EXPECT_EQ(staged.output_times, (std::vector<double>{-1, 0}));
    EXPECT_LE(largest_from(shape(staged, 0), shape(read(path + "/before.h5"), 0), 0), 1e-9);
    const double off = largest_from(shape(staged, 1), shape(read(path + "/known.h5"), 0), 11);
    printf("%s: %s m paid out in a stage, nodes off by %.2g m\n", name.c_str(), by, off);
    EXPECT_LE(off, 1e-6);
    // The stage moves the line.
    EXPECT_GT(largest_from(shape(staged, 1), shape(staged, 0), 11), 1);
  }
}

TEST(Stages, PayOutARope) { expect_another_stock("rope", "bending: false", "clamped: false"); }

TEST(Stages, PayOutAPipe) {
  expect_another_stock("pipe", "EI: 1e4, GJ: 1e4", "direction: [1, 0, -1], clamped: true");
}

// A run continues in time from the stage with the length paid out, also from a checkpoint.
TEST(Stages, GoOnInTime) {
  const std::string path = folder("stages-time");
  const std::string input = path + "/case.yaml";
  write_case(
      input,
      line(
          "bending: false", "clamped: false",
          "stages: [given, moved]\nevents:\n  - {feed: {line: rope, end: end_a, paid_out: 6}, stage: moved}\n"
          "  - {feed: {line: rope, end: end_a, speed: 0.5}, time: 0}\n"
          "dynamics: {duration: 1, max_step: 0.02}\noutput: {every: 0.5}\n"),
      {{"STOCK", "20"}});
  run_on_all({input, path + "/whole.h5"});
  run_on_all({input, path + "/half.h5", "", 0.5});
  run_on_all({input, path + "/rest.h5", path + "/half.h5"});
  // A restart without that event is rejected.
  write_case(input, line("bending: false", "clamped: false", "dynamics: {duration: 1}\n"), {{"STOCK", "20"}});
  run::RunOptions o;
  o.case_path = input;
  o.output = path + "/other.h5";
  o.restart = path + "/half.h5";
  o.quiet = true;
  EXPECT_THROW(run::run(MPI_COMM_WORLD, o), InputError);
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results whole = read(path + "/whole.h5");
  const Results rest = read(path + "/rest.h5");
  EXPECT_EQ(whole.output_times, (std::vector<double>{-1, 0, 0.5, 1}));
  events::expect_same_positions(whole, rest, 1e-9);
  const auto out = named(path + "/whole.h5", whole, "rope_end_a_feed", "paid_out");
  EXPECT_NEAR(out.front(), 0, 1e-12);
  EXPECT_NEAR(out.back(), 0.5, 1e-9);
}

const char* const kStreamed = R"(hawser: 1
environment:
  water: {depth: 200}
  current: {speed: SPEED}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 12, EA: 1e7, bending: false}
lines:
  rope:
    sections: [{type: rope, length: 100, elements: 20}]
    end_a: {anchor: [0, 0, -5]}
    end_b: free
    masses: [{at: end_b, mass: 300}]
contact: {between_lines: false}
)";

TEST(Stages, ScaleTheCurrent) {
  const std::string path = folder("stages-current");
  const std::string input = path + "/case.yaml";
  const std::string plain = path + "/plain.yaml";
  write_case(input,
             std::string(kStreamed) +
                 "stages: [still, half, full]\nevents:\n  - {current: {factor: 0}, stage: still}\n"
                 "  - {current: {factor: 0.5}, stage: half}\n  - {current: {factor: 1}, stage: full}\n",
             {{"SPEED", "1.2"}});
  run_on_all({input, path + "/staged.h5"});
  size_t output = 0;
  for (const char* speed : {"0", "0.6", "1.2"}) {
    write_case(plain, kStreamed, {{"SPEED", speed}});
    run_on_all({plain, path + "/plain.h5"});
    if (rank_of(MPI_COMM_WORLD) == 0) {
      EXPECT_LE(
          largest_difference(shape(read(path + "/staged.h5"), output), shape(read(path + "/plain.h5"), 0)),
          1e-6)
          << speed;
    }
    ++output;
  }
}

// A chain is laid straight on the bed and stretched: without friction its tension is uniform.
TEST(Stages, SwitchFriction) {
  const std::string path = folder("stages-friction");
  const std::string input = path + "/case.yaml";
  write_case(input, R"(hawser: 1
environment: {seabed: {depth: 10, friction: 0.6}}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 1e7, bending: false}
lines:
  chain:
    sections: [{type: chain, length: 100, elements: 50}]
    end_a: {anchor: [0, 0, -9.95]}
    end_b: {anchor: [100.2, 0, -9.95]}
    start: {points: [[0, 0, -9.95], [100.2, 0, -9.95]]}
stages: [smooth, rough]
events:
  - {friction: {enabled: false}, stage: smooth}
  - {name: rubs, friction: {enabled: true}, stage: rough}
  - {release: {line: chain, end: end_b}, stage: rough}
contact: {between_lines: false}
)");
  run_on_all({input, path + "/staged.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(path + "/staged.h5");
  const auto& T = r.fields.at("effective_tension");
  const size_t nodes = T.size() / r.output_times.size();
  for (size_t n = 1; n + 1 < nodes; ++n) EXPECT_NEAR(T[n], T[1], 30) << n;
  EXPECT_NEAR(T[1], 1e7 * 0.002, 400);
  // The released end recoils as far as friction of 589 N/m allows: the tension of 20 kN decays over 34 m.
  const double* rough = T.data() + nodes;
  EXPECT_NEAR(rough[1], 20e3, 500);
  EXPECT_NEAR(rough[nodes / 2], 20e3, 500);
  EXPECT_NEAR(rough[nodes - 1 - 10], 589 * 20, 1500);
}

TEST(Stages, BadInput) {
  const std::string path = folder("stages-bad");
  const std::string input = path + "/case.yaml";
  const auto message = [&](const std::string& event, const std::string& more,
                           const std::string& stock = "20") {
    write_case(input,
               line("bending: false", "clamped: false",
                    "stages: [given, moved]\nevents:\n  - " + event + "\n" + more),
               {{"STOCK", stock}});
    return error_of(input, path + "/out.h5");
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(message("{feed: {line: rope, end: end_a, paid_out: 25}, stage: moved}", ""),
      "-5 m would remain inside: ");
  has(message("{feed: {line: rope, end: end_a, paid_out: -85}, stage: moved}", ""),
      "-5 m would remain outside: ");
  has(message("{feed: {line: rope, end: end_a, paid_out: 5}, time: 1}", "dynamics: {duration: 2}\n"),
      "in time a feeder has a 'speed'");
  has(message("{feed: {line: rope, end: end_a, paid_out: 5, speed: 1}, stage: moved}", ""),
      "give one of 'speed', 'tension' and 'paid_out'");
  has(message("{current: {factor: 0.5}, stage: moved}", ""), "the water has no current that could be scaled");
  has(message("{friction: {enabled: false}, time: 1}", "dynamics: {duration: 2}\n"),
      "in a 'stage' of statics only");
}

// A chain is released in a stage, falls on the bed and comes to rest along the current. Drag has no
// potential: with inertia the chain would oscillate about that direction without end. The slack end has no
// stiffness and is loaded by its drag only, less than a millionth of the forces; this determines the
// tolerance.
TEST(Stages, ReleasedOntoTheBedInACurrent) {
  const std::string path = folder("stages-let-go");
  const std::string input = path + "/case.yaml";
  write_case(input, R"(hawser: 1
environment:
  water: {density: 1025, depth: 30}
  seabed: {depth: 30, normal_stiffness: {per_area: 100 kN/m3}, friction: 0.5, friction_in_statics: none}
  current: {speed: 0.5, direction_deg: 40}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 60, EA: 200 MN, bending: false}
bodies: {vessel: {position: [0, 0, 0]}}
lines:
  leg:
    sections: [{type: chain, length: 62, elements: 20}]
    end_a: {anchor: [50, 0, -30]}
    end_b: {body: vessel, at: [1, 0, 0]}
contact: {between_lines: false}
statics: {tolerance: 1.0e-6}
stages: [let go]
events: [{release: {line: leg, end: end_b}, stage: let go}]
)",
             {});
  run_on_all({input, path + "/out.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(path + "/out.h5");
  const std::vector<double> last = shape(r, r.output_times.size() - 1);
  const double* end = last.data() + last.size() - 3;
  const double x = end[0] - 50;
  const double y = end[1];
  const double turn = std::atan2(y, x) * 180 / M_PI;
  const double away = std::hypot(x, y);
  printf("let go in a current of 40 degrees: lies %.2f m away at %.2f degrees\n", away, turn);
  EXPECT_NEAR(turn, 40, 2);
  EXPECT_NEAR(away, 62, 0.62);
}

}  // namespace
}  // namespace hawser::runs::stages
