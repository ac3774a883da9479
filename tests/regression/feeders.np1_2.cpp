// Lines that are paid out and hauled in: a line that runs between two winches, a weight lowered and raised,
// constant tensions, restarts, and rejected input.
#include <fmt/format.h>

#include <optional>

#include "hawser/base/error.hpp"
#include "hawser/kernels/catenary.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::feeders {
namespace {

constexpr double kGravity = 9.80665;

const char* const kWeight = R"(hawser: 1
title: A weight that is lowered and hauled up again
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 0.02}
lines:
  rope:
    sections: [{type: rope, length: 60, elements: 30}]
    end_a:
      anchor: [0, 0, 100]
      feed: {stock: 40, speed_table: [[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]}
    end_b: free
    masses: [{at: end_b, mass: 1000}]
dynamics: {duration: 40}
output: {every: 1, histories: [{line: rope, at: end_b, name: weight}, {line: rope, at: end_a, name: winch}]}
contact: {between_lines: false}
)";

// Sum of the steps' absolute work.
double work(const std::vector<double>& brought) {
  double sum = 0;
  for (size_t i = 1; i < brought.size(); ++i) sum += std::abs(brought[i] - brought[i - 1]);
  return sum;
}

// Length paid out by the rows of the table.
double paid(double t) {
  if (t < 2) return 0.25 * t * t;
  if (t < 20) return t - 1;
  if (t < 24) return 19 + (t - 20) - 0.25 * (t - 20) * (t - 20);
  return 19 - (t - 24);
}
double acceleration(double t) { return t < 2 ? 0.5 : t < 20 ? 0 : t < 24 ? -0.5 : 0; }

// When an element leaves the feeder, its new node moves under the weight of its surroundings and the energy
// falls by F²/2K, F = w L/2, K = EA (1/l + 1/(L - l)): 3/16 (w l/T)² of the energy of an element.
TEST(Feeders, AnElementLeavesWithTheEnergyOfItsWeight) {
  constexpr double l = 2, w = 10 * kGravity, EA = 1e6;  // m, N/m, N
  const std::string path = folder("feeders-leaves");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kWeight,
             {{"EA: 1e7", "EA: 1e6"},
              {"stock: 40", "stock: 52"},
              {"[[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]", "[[0, 0], [20, 0.05], [40, 0.05]]"},
              {"duration: 40", "duration: 32, step: 0.02"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto L = named(file, r, "rope_end_a_feed", "mouth_length");
  const auto T = named(file, r, "rope_end_a_feed", "tension");
  const auto error = named(file, r, "energy", "error");
  int left = 0;
  for (size_t i = 1; i + 1 < L.size(); ++i) {
    if (L[i + 1] > L[i] - 0.5 * l) continue;
    const double F = 0.5 * w * L[i];
    const double K = EA * (1 / l + 1 / (L[i] - l));
    const double lost = error[i] - error[i + 1];
    printf("  energy that goes: %.5f J, by hand %.5f J; of the element's %.1e\n", lost, 0.5 * F * F / K,
           lost / (0.5 * T[i] * T[i] * l / EA));
    EXPECT_NEAR(lost, 0.5 * F * F / K, 0.02 * lost);
    ++left;
  }
  EXPECT_EQ(left, 1);
}

TEST(Feeders, LowerAndRaiseAWeight) {
  const std::string path = folder("feeders-weight");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kWeight);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto out = named(file, r, "rope_end_a_feed", "paid_out");
  const auto T = named(file, r, "rope_end_a_feed", "tension");
  const auto end = named(file, r, "winch", "effective_tension");
  const auto error = named(file, r, "energy", "error");
  const auto brought = named(file, r, "energy", "brought_in");
  double off = 0, worst = 0;
  for (size_t i = 0; i < out.size(); ++i) {
    const double t = r.step_times[i];
    EXPECT_NEAR(out[i], paid(t), 1e-9) << t;
    EXPECT_EQ(end[i], T[i]);
    // The whole line accelerates with the feed speed; after the corners of the table it vibrates.
    bool corner = t < 0.5;
    for (const double c : {2.0, 20.0, 24.0}) corner |= t >= c - 0.05 && t < c + 0.5;
    const double still = (1000 + 10 * (20 + paid(t))) * (kGravity - acceleration(t));
    if (!corner) off = std::max(off, std::abs(T[i] - still) / still);
    worst = std::max(worst, std::abs(error[i]));
  }
  printf("  tension off by %.1e, energy by %.1e of what was brought in\n", off, worst / work(brought));
  EXPECT_LT(off, 0.02);             // axial vibration after the corners of the table
  EXPECT_GT(r.summary.at(3), 5e3);  // the least tension is that of the outside part
  EXPECT_LT(worst, 0.01 * work(brought));
}

// A node leaves at 5 m paid out, in the step that ends at an event: the motion and the energy continue
// without a jump.
TEST(Feeders, ANodeLeavesAtAnEvent) {
  const std::string path = folder("feeders-event");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(
      input, kWeight,
      {{"[20, 1], [24, -1], [40, -1]", "[40, 1]"},
       {"duration: 40}",
        "duration: 7}\nevents: [{feed: {line: rope, end: end_a, speed: 1}, when: {paid_out: {line: rope, "
        "end: end_a, above: 5}}}]"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto T = named(file, r, "rope_end_a_feed", "tension");
  const auto L = named(file, r, "rope_end_a_feed", "mouth_length");
  const auto error = named(file, r, "energy", "error");
  double off = 0, shortest = HUGE_VAL;
  for (size_t i = 0; i < T.size(); ++i) {
    const double t = r.step_times[i];
    const double weight = (1000 + 10 * (20 + paid(t))) * kGravity;
    if (t < 5) continue;
    off = std::max(off, std::abs(T[i] / weight - 1));
    shortest = std::min(shortest, L[i]);
  }
  printf("  tension off by %.1e, energy by %.1e J\n", off, largest(error));
  EXPECT_LT(shortest, 1.1);  // of 3 m before
  EXPECT_LT(off, 0.01);
  EXPECT_LT(largest(error), 0.01 * work(named(file, r, "energy", "brought_in")));
}

// A line that runs with V between two winches keeps the shape of its catenary and has m V² more tension
// (Routh 1884: for any line that moves along itself). The additional tension stretches it. P, in balance with
// shape and weight, is the tension of an elastic catenary whose material is longer by m V² λ / EA, and
// lighter and stiffer per length accordingly. T = P + m V² λ, λ = 1 + T/EA, because V is the speed of the
// unstretched line.
const char* const kRunning = R"(hawser: 1
title: A catenary that runs from one winch to another
environment: {gravity: 9.80665}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 0.02}
lines:
  rope:
    sections: [{type: rope, length: 900, elements: 900}]
    end_a:
      anchor: [0, 0, 0]
      feed: {stock: 700, speed_table: [PAYS OUT]}
    end_b:
      anchor: [100, 0, 0]
      feed: {stock: 90, speed_table: [HAULS IN]}
    start: catenary
dynamics: {duration: 36}
output: {every: 0.5, histories: [{line: rope, at: end_a, name: winch}]}
contact: {between_lines: false}
)";

CatenaryShape running(double V, double& T) {
  constexpr double m = 10, EA = 1e7, outside = 110;
  std::optional<CatenaryShape> shape;
  for (int i = 0; i < 20; ++i) {
    const double more = m * V * V * (1 + (i > 0 ? T : 0) / EA);
    const double longer = 1 + more / EA;
    shape = catenary(Vec3::Zero(), Vec3(100, 0, 0),
                     {{outside * longer, Vec3(0, 0, -m * kGravity / longer), EA * longer, Vec3::Zero(), 0}});
    T = shape->tension_a().norm() + more;
  }
  return *shape;
}

TEST(Feeders, ALineThatRunsKeepsItsShape) {
  if (size_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  const std::string path = folder("feeders-running");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  for (const double V : {5.0, 10.0, 20.0}) {
    const double least = size_of(MPI_COMM_WORLD) > 1 ? 20 : 10;
    if (V < least && !std::getenv("HAWSER_FULL")) continue;  // slower runs
    // A smooth start causes little oscillation.
    std::string out, in;
    for (int i = 0; i <= 10; ++i) {
      const double u = 0.1 * i;
      const double v = V * u * u * (3 - 2 * u);
      out += fmt::format("[{}, {:.6f}],", 20 * u, v);
      in += fmt::format("[{}, {:.6f}],", 20 * u, -v);
    }
    write_case(input, kRunning, {{"PAYS OUT", out}, {"HAULS IN", in}});
    run_on_all({input, file});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results r = read(file);
    const auto A = named(file, r, "rope_end_a_feed", "tension");
    const auto B = named(file, r, "rope_end_b_feed", "tension");
    double at_a = 0, at_b = 0, time = 0;
    for (size_t i = 1; i < A.size(); ++i)
      if (r.step_times[i - 1] > 24) {
        const double h = r.step_times[i] - r.step_times[i - 1];
        at_a += 0.5 * h * (A[i - 1] + A[i]);
        at_b += 0.5 * h * (B[i - 1] + B[i]);
        time += h;
      }
    const double mean = 0.5 * (at_a + at_b) / time;
    const auto& x = r.fields.at("position");
    const size_t nodes = 901;
    double low = 0;  // mean over the remaining oscillation
    int outputs = 0;
    for (size_t k = 0; k < r.output_times.size(); ++k) {
      if (r.output_times[k] <= 24) continue;
      double z = 0;
      for (size_t n = 0; n < nodes; ++n) z = std::min(z, x.at(3 * (nodes * k + n) + 2));
      low += z;
      ++outputs;
    }
    low /= outputs;
    double at_rest = 0, expected = 0;
    running(0, at_rest);
    const CatenaryShape shape = running(V, expected);
    const double sag = shape.position(0.5 * shape.length()).z();
    const auto off = [&](double T) { return 100 * (T / expected - 1); };
    printf(
        "  %2.0f m/s: at rest %.2f (%.2f), running %.2f (%.2f, %+.3f %%; A %+.3f, B %+.3f %%), lowest %.4f "
        "(%.4f)\n",
        V, A[0], at_rest, mean, expected, off(mean), off(at_a / time), off(at_b / time), low, sag);
    EXPECT_NEAR(A[0], at_rest, 2e-4 * at_rest);
    EXPECT_NEAR(mean, expected, 1e-3 * expected) << V;
    EXPECT_NEAR(low, sag, 2e-3 * std::abs(sag)) << V;
  }
}

// A tug pulls a rope back and forth; a winch keeps its tension, exactly or within a band.
const char* const kTug = R"(hawser: 1
title: A winch that keeps a tension
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.05, mass_per_length: 1, EA: 1e6, bending: false, stiffness_damping: 0.02}
bodies:
  tug: {position: [101, 0, 0], motion: {harmonic: {amplitude: [6, 0, 0], period: 60}, ramp: 20}}
lines:
  rope:
    sections: [{type: rope, length: 160, elements: 80}]
    end_a:
      anchor: [0, 0, 0]
      feed: {stock: 60, tension: 10 kN}
    end_b: {body: tug, at: [0, 0, 0]}
dynamics: {duration: 100}
output: {every: 1, histories: [{line: rope, at: end_a, name: winch}]}
contact: {between_lines: false}
)";

TEST(Feeders, KeepATension) {
  const std::string path = folder("feeders-kept");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kTug);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto T = named(file, r, "rope_end_a_feed", "tension");
  const auto out = named(file, r, "rope_end_a_feed", "paid_out");
  double off = 0;
  for (size_t i = 1; i < T.size(); ++i) off = std::max(off, std::abs(T[i] - 1e4));
  const auto error = named(file, r, "energy", "error");
  const auto brought = named(file, r, "energy", "brought_in");
  printf("  off by %.2g N, paid out %.3f m, energy %.1e\n", off, largest(out),
         largest(error) / work(brought));
  EXPECT_LT(off, 10);  // inertia of the element at the feed point
  EXPECT_NEAR(largest(out), 6 / 1.01, 0.05);
  EXPECT_LT(largest(error), 0.01 * work(brought));
}

const Edits kBand{{"tension: 10 kN}", "tension: 10 kN, dead_band: [8 kN, 12 kN], speed_per_tension: 2e-4}"}};

// The speed law uses the tension including damping, so damping causes no peak at the edge of the band.
TEST(Feeders, RestWithinTheirBand) {
  const std::string path = folder("feeders-band");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  // The recorded tension contains the inertia of the element at the feed point, which the law does not use.
  // Its share increases with damping, because the speed then changes faster.
  for (const auto& [damping, tolerance] : {std::pair{"0.02", 0.025}, {"1e-4", 0.01}}) {
    Edits edits = kBand;
    edits.push_back({"stiffness_damping: 0.02", fmt::format("stiffness_damping: {}", damping)});
    write_case(input, kTug, edits);
    run_on_all({input, file});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results r = read(file);
    const auto T = named(file, r, "rope_end_a_feed", "tension");
    const auto v = named(file, r, "rope_end_a_feed", "feed_speed");
    // At the start of motion the tension is that of the band's edge or, later in the step, that of the law.
    int starts = 0;
    double off = 0, beyond = 0;
    for (size_t i = 1; i < T.size(); ++i) {
      const double law = 2e-4 * (T[i] - 1e4);
      beyond = std::max(beyond, std::abs(T[i] - 1e4));
      const bool starting = v[i] != 0 && v[i - 1] == 0;
      starts += starting;
      if (v[i] == 0) {
        EXPECT_LT(std::abs(T[i] - 1e4), 2e3 + 1) << r.step_times[i];
      } else if (starting && std::abs(v[i]) < std::abs(law)) {
        EXPECT_NEAR(std::abs(T[i] - 1e4), 2e3, 1) << r.step_times[i];
      } else {
        off = std::max(off, std::abs(v[i] - law));
      }
    }
    printf("  damping %s s: begins %d times, law off by %.1e m/s, at most %.0f N beside the middle\n",
           damping, starts, off, beyond);
    EXPECT_GE(starts, 4);
    EXPECT_LE(starts, 30);
    EXPECT_LT(off, tolerance * 2e-4 * 2e3);
    EXPECT_LT(beyond, 4e3);
  }
}

void expect_same(const std::string& a, const std::string& b, double tolerance) {
  const Results whole = read(a);
  const Results rest = read(b);
  const auto x = tail(whole.fields.at("position"), rest.fields.at("position"));
  EXPECT_LT(largest_difference(x, rest.fields.at("position")), tolerance) << b;
  const auto T = named(a, whole, "rope_end_a_feed", "tension");
  const auto U = named(b, rest, "rope_end_a_feed", "tension");
  ASSERT_FALSE(U.empty());
  EXPECT_NEAR(T.back(), U.back(), 1e-6 * T.back());
  const auto e = named(a, whole, "energy", "error");
  const auto f = named(b, rest, "energy", "error");
  EXPECT_NEAR(e.back(), f.back(), 1e-3 + 1e-6 * largest(named(a, whole, "energy", "brought_in")));
}

// Restart in the middle of an element.
TEST(Feeders, GoOnAfterARestart) {
  const std::string path = folder("feeders-restart");
  for (const auto& [name, text, edits] :
       {std::tuple{"weight", kWeight, Edits{{"duration: 40", "duration: 30"}}},
        {"band", kTug, kBand},
        {"kept", kTug, Edits{}}}) {
    const std::string input = path + "/" + name + ".yaml";
    const std::string whole = path + "/" + name + ".h5";
    const std::string half = path + "/" + name + "-half.h5";
    const std::string rest = path + "/" + name + "-rest.h5";
    write_case(input, text, edits);
    run_on_all({input, whole});
    run_on_all({input, half, "", 17});
    run_on_all({input, rest, half});
    if (rank_of(MPI_COMM_WORLD) == 0) expect_same(whole, rest, 1e-7);
  }
}

TEST(Feeders, AreTheSameOnAllRanks) {
  const std::string path = folder("feeders-ranks");
  if (size_of(MPI_COMM_WORLD) == 1) GTEST_SKIP() << "one rank";
  for (const auto& [name, text, edits] :
       {std::tuple{"weight", kWeight, Edits{}}, {"band", kTug, kBand}, {"kept", kTug, Edits{}}}) {
    const std::string input = path + "/" + name + ".yaml";
    const std::string all = path + "/" + name + "-all.h5";
    const std::string one = path + "/" + name + "-one.h5";
    write_case(input, text, edits);
    run_on_all({input, all});
    run_on_one({input, one});
    if (rank_of(MPI_COMM_WORLD) == 0) expect_same(one, all, 1e-7);
  }
}

std::string refusal(const std::string& input, const std::string& output) {
  run::RunOptions o;
  o.case_path = input;
  o.output = output;
  o.quiet = true;
  try {
    run::run(MPI_COMM_WORLD, o);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

// Statics does not move the feeder: the start with a speed and damping is that of a table that begins at 0.
TEST(Feeders, StaticsDoesNotFeed) {
  const std::string path = folder("feeders-statics");
  const std::string input = path + "/case.yaml";
  const std::string table = "speed_table: [[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]";
  write_case(input, kWeight, {{"duration: 40", "duration: 1"}});
  run_on_all({input, path + "/slow.h5"});
  write_case(input, kWeight, {{"duration: 40", "duration: 1"}, {table, "speed: -2"}});
  run_on_all({input, path + "/fast.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results slow = read(path + "/slow.h5");
  const Results fast = read(path + "/fast.h5");
  const auto& a = slow.fields.at("position");
  const auto& b = fast.fields.at("position");
  const size_t first = a.size() / slow.output_times.size();
  for (size_t i = 0; i < first; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << i;
}

TEST(Feeders, StopWhereTheStockRunsOut) {
  const std::string path = folder("feeders-out");
  const std::string input = path + "/case.yaml";
  write_case(input, kWeight, {{"[20, 1], [24, -1], [40, -1]", "[60, 1]"}, {"duration: 40", "duration: 60"}});
  EXPECT_NE(
      refusal(input, path + "/out.h5").find("40 m are paid out by t = 41 s, and the run goes on to 60 s"),
      std::string::npos);
  // It keeps a tension below the weight, so it pays out without an equilibrium length.
  write_case(input, kWeight,
             {{"speed_table: [[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]",
               "tension: 8 kN, speed_per_tension: 5e-4"},
              {"duration: 40", "duration: 60"}});
  EXPECT_NE(refusal(input, path + "/weight.h5").find("the stock at end A of line rope runs out at t = "),
            std::string::npos);
  write_case(input, kWeight, {{"[[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]", "[[0, 0], [2, -1]]"}});
  EXPECT_NE(refusal(input, path + "/in.h5").find("all of the line is hauled in at end A of line rope"),
            std::string::npos);
  write_case(input, kWeight,
             {{"[[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]", "[[0, 0], [2, -1]]"},
              {"output:", "events: [{cut: {line: rope, at: 50}, time: 39}]\noutput:"}});
  EXPECT_NE(refusal(input, path + "/cut.h5")
                .find("arc length 50 m of line 'rope' is hauled in at its end A by t = "),
            std::string::npos);
}

TEST(Feeders, RefuseWhatTheyCannotDo) {
  const std::string path = folder("feeders-bad");
  const std::string input = path + "/case.yaml";
  const std::string table = "speed_table: [[0, 0], [2, 1], [20, 1], [24, -1], [40, -1]]";
  const std::vector<std::pair<Edits, std::string>> bad{
      {{{"stock: 40", "stock: 0"}}, "must be above 0"},
      {{{"stock: 40", "stock: 3"}}, "a stock needs at least 2"},
      {{{"stock: 40", "stock: 58"}}, "it must leave at least 3"},
      {{{"[20, 1], [24", "[20, 1], [19"}}, "times must increase"},
      {{{table, "tension: 10 kN, dead_band: [12 kN, 8 kN], speed_per_tension: 1e-4"}}, "is not a band"},
      {{{table, "tension: 20 kN, dead_band: [8 kN, 12 kN], speed_per_tension: 1e-4"}}, "does not hold"},
      {{{table, "tension: 10 kN, dead_band: [8 kN, 12 kN]"}}, "needs 'speed_per_tension'"},
      {{{table, "tension: 10 kN, speed: 1"}}, "speed"},
      {{{"bending: false, ", "EI: 1e3, GJ: 1e3, "}}, "resists bending"},
      {{{"lines:", "bodies: {cart: {on: {line: rope, at: 55}}}\nlines:"}},
       "body 'cart' rides on line rope, and"},
  };
  for (const auto& [edits, text] : bad) {
    write_case(input, kWeight, edits);
    const std::string message = refusal(input, path + "/bad.h5");
    EXPECT_NE(message.find(text), std::string::npos) << text << ": " << message;
  }
}

}  // namespace
}  // namespace hawser::runs::feeders
