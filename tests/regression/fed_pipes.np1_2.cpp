// Pipes that are paid out of a clamp and hauled in: axial force on the clamp by bending, energy balance,
// constant tension on a heaving barge, restarts, ranks, and rejected input.
#include <fmt/format.h>

#include "hawser/base/error.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::fed_pipes {
namespace {

constexpr double kEI = 2e5;

const char* const kCantilever = R"(hawser: 1
title: A pipe that leaves a clamp horizontally and hangs freely
environment: {gravity: 9.80665}
line_types:
  pipe: {outer_diameter: 0.1, mass_per_length: 20, EA: 5e8, EI: 2e5, GJ: 1.5e5}
lines:
  pipe:
    sections: [{type: pipe, length: 30, elements: 30}]
    end_a:
      anchor: [0, 0, 100]
      direction: [1, 0, 0]
      clamped: true
      feed: {stock: 20, speed_table: [[0, 0], [10, 0.1], [40, 0.1], [60, -0.1], [80, -0.1]]}
    end_b: free
dynamics: {duration: 80}
output: {every: 2, histories: [{line: pipe, at: end_b, name: tip}, {line: pipe, at: end_a, name: clamp}]}
contact: {between_lines: false}
)";

// A tensioner on a heaving barge keeps the tension of a pipe, which leaves it on a slope over the rollers of
// a ramp.
const char* const kRamp = R"(hawser: 1
title: A pipe over a ramp that heaves, held by a tensioner
environment: {gravity: 9.80665}
line_types:
  pipe: {outer_diameter: 0.1, mass_per_length: 20, EA: 5e7, EI: 2e5, GJ: 1.5e5}
bodies:
  barge: {motion: {harmonic: {amplitude: [0.4, 0, 0], period: 8}, ramp: 8}}
supports:
  ramp:
    body: barge
    path: {from: [0, 0, 10], direction: [1, 0, 0], segments: [{length: 4}, {length: 16, radius: 40}]}
    boxes:
      - {at: [2, 5, 8, 11, 14, 17], above_path: 0.5, type: U, roller_diameter: 0.3, roller_length: 1, side_height: 0.5,
         normal_stiffness: 1.0e6}
lines:
  pipe:
    sections: [{type: pipe, length: 60, elements: 60}]
    end_a:
      body: barge
      at: [0, 0, 10.7]
      direction: [1, 0, 0]
      clamped: true
      feed: {stock: 20, tension: 40 kN, speed_per_tension: 5e-5}
    end_b: {anchor: [38.25, 0, 0.5]}
dynamics: {duration: 24, step: 0.02}
output: {every: 2, histories: [{line: pipe, at: end_a, name: tensioner}]}
contact: {between_lines: false}
)";

const char* const kShortRamp = R"(hawser: 1
title: A pipe that is held between a wall and the first roller of a ramp
environment: {gravity: 9.80665}
line_types:
  pipe: {outer_diameter: 0.1, mass_per_length: 20, EA: 5e7, EI: 2e5, GJ: 1.5e5}
supports:
  ramp:
    path: {from: [0, 0, 10], direction: [1, 0, 0], segments: [{length: 4}, {length: 16, radius: 40}]}
    boxes:
      - {at: [0.25, 2, 5, 8, 11, 14, 17], above_path: 0.5, type: U, roller_diameter: 0.3, roller_length: 1, side_height: 0.5,
         normal_stiffness: 1.0e6}
volumes:
  wall: {shape: {box: {centre: [-0.6, 0, 10.7], size: [1, 2, 2]}}, normal_stiffness: {per_length: 1.0e6}}
lines:
  pipe:
    sections: [{type: pipe, length: 60, elements: 20}]
    end_a:
      anchor: [0, 0, 10.7]
      direction: [1, 0, 0]
      clamped: true
      feed: {stock: 20, speed: 0.2}
    end_b: {anchor: [38.25, 0, 0.5]}
dynamics: {duration: 0.2, step: 0.02}
contact: {between_lines: false}
)";

const char* const kUnderWater = R"(hawser: 1
title: A pipe that a heaving ship pays out under water
environment: {gravity: 9.80665, water: {density: 1025, depth: 100}, current: {speed: 1.0, direction_deg: 0}}
line_types:
  pipe: {outer_diameter: 0.2, mass_per_length: 60, EA: 5e8, EI: 2e6, GJ: 1.5e6, Cd_normal: 1.2, Ca_normal: 1}
bodies:
  ship: {motion: {harmonic: {amplitude: [1, 0, 1], period: 8}, ramp: 4}}
lines:
  pipe:
    sections: [{type: pipe, length: 220, element_length: 2}]
    end_a:
      body: ship
      at: [0, 0, -5]
      direction: [1, 0, -1]
      clamped: true
      feed: {stock: 200, speed_table: [[0, 0], [2, 0.2], [40, 0.2]]}
    end_b: free
dynamics: {duration: 8, step: 0.04}
contact: {between_lines: false}
)";

double work(const std::vector<double>& brought) {
  double sum = 0;
  for (size_t i = 1; i < brought.size(); ++i) sum += std::abs(brought[i] - brought[i - 1]);
  return sum;
}

TEST(FedPipes, ABendActsOnTheClamp) {
  const std::string path = folder("fed-pipes-clamp");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kCantilever);
  run_on_all({input, file});
  // Reference: the same outside length in statics.
  write_case(input, kCantilever, {{"stock: 20", "stock: 17"}, {"dynamics: {duration: 80}\n", ""}});
  run_on_all({input, path + "/still.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const Results still = read(path + "/still.h5");
  const auto F = named(file, r, "pipe_end_a_feed", "tension");
  const auto out = named(file, r, "pipe_end_a_feed", "paid_out");
  const auto M = named(file, r, "clamp", "bending_moment");
  const auto z = named(file, r, "tip", "position_z");
  const auto error = named(file, r, "energy", "error");
  const auto brought = named(file, r, "energy", "brought_in");
  // The clamp is horizontal: except for inertia, the feeder force is that of the bend alone, M²/2EI.
  double off = 0, jump = 0;
  for (size_t i = 0; i < F.size(); ++i) {
    off += (F[i] - M[i] * M[i] / (2 * kEI)) / F[i] / static_cast<double>(F.size());
    if (i > 0) jump = std::max(jump, std::abs(error[i] - error[i - 1]));
  }
  double lowest = HUGE_VAL;
  for (const double h : z) lowest = std::min(lowest, h);
  const double there = named(path + "/still.h5", still, "tip", "position_z").front();
  double middle = 0;  // at 3 m outside, paying out and hauling in
  for (size_t i = 1; i < z.size(); ++i)
    if ((out[i] - 3) * (out[i - 1] - 3) <= 0 && out[i] != out[i - 1])
      middle = std::max(
          middle, std::abs(z[i - 1] + (z[i] - z[i - 1]) * (3 - out[i - 1]) / (out[i] - out[i - 1]) - there));
  printf(
      "  force of the clamp off by %.1e in the mean, tip %.1e m from rest, energy %.1e of the work, jumps "
      "%.2g J\n",
      off, middle, largest(error) / work(brought), jump);
  EXPECT_LT(std::abs(off), 0.005);
  EXPECT_GT(lowest, 95);
  EXPECT_GT(middle, 0);
  EXPECT_LT(middle, 0.002);
  EXPECT_LT(largest(error), 5e-4 * work(brought));
}

TEST(FedPipes, ATensionIsKeptOverRollers) {
  const std::string path = folder("fed-pipes-ramp");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kRamp);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto F = named(file, r, "pipe_end_a_feed", "tension");
  const auto v = named(file, r, "pipe_end_a_feed", "feed_speed");
  const auto out = named(file, r, "pipe_end_a_feed", "paid_out");
  const auto error = named(file, r, "energy", "error");
  const auto brought = named(file, r, "energy", "brought_in");
  double law = 0, most = -HUGE_VAL, least = HUGE_VAL;
  for (size_t i = 1; i < F.size(); ++i) {
    if (r.step_times[i] < 10) continue;
    law = std::max(law, std::abs(F[i] - 40e3 - v[i] / 5e-5));
    most = std::max(most, out[i]);
    least = std::min(least, out[i]);
  }
  // Statics has found the initial length for this tension.
  EXPECT_NEAR(F.front(), 40e3, 0.1);
  EXPECT_NEAR(v.front(), 0, 1e-5);
  printf("  off its law by %.2g N, paid out from %.3f to %.3f m, energy %.1e\n", law, least, most,
         largest(error) / work(brought));
  EXPECT_LT(law, 400);  // weight and inertia between the feeder and the middle of its element
  EXPECT_NEAR(most - least, 0.8, 0.1);
  EXPECT_LT(largest(error), 0.01 * work(brought));
}

// Statistics at stations fixed to the feeder are those of the material that passes them, step by step.
TEST(FedPipes, StationsStayWithTheirFeeder) {
  const std::string path = folder("fed-pipes-stations");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kRamp, {{"duration: 24", "duration: 8"}, {"every: 2", "every: 0.02"}});
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  ASSERT_EQ(r.output_times, r.step_times);
  const auto feed_point = named(file, r, "pipe_end_a_feed", "mouth_length");
  const auto& x = r.fields.at("position");
  const size_t nodes = 61;
  double moved = 0;
  for (const char* field : {"bending_moment", "effective_tension", "curvature"}) {
    const auto& v = r.fields.at(field);
    const std::vector<double> found =
        io::h5::read_array(io::h5::open_read(file), std::string("statistics/") + field + "_at_stations")
            .values;
    ASSERT_EQ(found.size(), 6 * nodes);
    double size = 0;
    for (const double value : v) size = std::max(size, std::abs(value));
    for (size_t i = 0; i < nodes; ++i) {
      double least = HUGE_VAL;
      double most = -HUGE_VAL;
      double sum = 0;
      double time = 0;
      double last = std::nan("");
      for (size_t k = 0; k < r.output_times.size(); ++k) {
        size_t free = 1;
        while ((x[3 * (nodes * k + free)] == x[3 * nodes * k])) ++free;
        const double feeder = static_cast<double>(free) - feed_point[k];  // m; elements of 1 m
        const double s = feeder + static_cast<double>(i);
        double now = std::nan("");
        if (s < static_cast<double>(nodes - 1)) {
          const size_t before = static_cast<size_t>(std::max(s, static_cast<double>(free)));
          const double share = std::max(s, static_cast<double>(free)) - static_cast<double>(before);
          now = v[nodes * k + before] + share * (v[nodes * k + before + 1] - v[nodes * k + before]);
          least = std::min(least, now);
          most = std::max(most, now);
        }
        if (const double h = k > 0 ? r.output_times[k] - r.output_times[k - 1] : 0;
            !std::isnan(now) && !std::isnan(last)) {
          sum += 0.5 * h * (last + now);
          time += h;
        }
        last = now;
        moved = std::max(moved, std::abs(feed_point[k] - feed_point[0]));
      }
      if (least == HUGE_VAL) {
        EXPECT_TRUE(std::isnan(found[6 * i])) << field << i;
        continue;
      }
      EXPECT_NEAR(found[6 * i], least, 1e-9 * size) << field << i;
      EXPECT_NEAR(found[6 * i + 2], most, 1e-9 * size) << field << i;
      if (time > 0) {
        EXPECT_NEAR(found[6 * i + 4], sum / time, 1e-9 * size) << field << i;
      }
    }
  }
  EXPECT_GT(moved, 0.2);  // m
}

void expect_same(const std::string& a, const std::string& b, double tolerance) {
  const Results whole = read(a);
  const Results rest = read(b);
  const auto x = tail(whole.fields.at("position"), rest.fields.at("position"));
  EXPECT_LT(largest_difference(x, rest.fields.at("position")), tolerance) << b;
  const auto F = named(a, whole, "pipe_end_a_feed", "tension");
  const auto G = named(b, rest, "pipe_end_a_feed", "tension");
  ASSERT_FALSE(G.empty());
  EXPECT_NEAR(F.back(), G.back(), 1e-4 * F.back());
}

const Edits kShort{{"duration: 80", "duration: 24"}};

TEST(FedPipes, GoOnAfterARestart) {
  const std::string path = folder("fed-pipes-restart");
  for (const auto& [name, text, edits] :
       {std::tuple{"clamp", kCantilever, kShort}, {"ramp", kRamp, Edits{}}}) {
    const std::string input = path + "/" + name + ".yaml";
    const std::string whole = path + "/" + name + ".h5";
    const std::string half = path + "/" + name + "-half.h5";
    const std::string rest = path + "/" + name + "-rest.h5";
    write_case(input, text, edits);
    run_on_all({input, whole});
    run_on_all({input, half, "", 14});
    run_on_all({input, rest, half});
    if (rank_of(MPI_COMM_WORLD) == 0) expect_same(whole, rest, 1e-6);
  }
}

TEST(FedPipes, AreTheSameOnAllRanks) {
  const std::string path = folder("fed-pipes-ranks");
  if (size_of(MPI_COMM_WORLD) == 1) GTEST_SKIP() << "one rank";
  for (const auto& [name, text, edits] :
       {std::tuple{"clamp", kCantilever, kShort}, {"ramp", kRamp, Edits{}}}) {
    const std::string input = path + "/" + name + ".yaml";
    const std::string all = path + "/" + name + "-all.h5";
    const std::string one = path + "/" + name + "-one.h5";
    write_case(input, text, edits);
    run_on_all({input, all});
    run_on_one({input, one});
    if (rank_of(MPI_COMM_WORLD) == 0) expect_same(one, all, 1e-5);
  }
}

// The stock has no contact, although its nodes are at one point between wall and roller: ten times the stock
// gives the same roller forces.
TEST(FedPipes, TheStockTouchesNothing) {
  const std::string path = folder("fed-pipes-stock");
  const std::string input = path + "/case.yaml";
  std::vector<std::vector<double>> force;
  for (const int stock : {20, 200}) {
    const std::string file = fmt::format("{}/{}.h5", path, stock);
    write_case(input, kShortRamp,
               {{"stock: 20,", fmt::format("stock: {},", stock)},
                {"length: 60, elements: 20",
                 fmt::format("length: {0}, elements: {1}", 40 + stock, (40 + stock) / 3)}});
    run_on_all({input, file});
    if (rank_of(MPI_COMM_WORLD) != 0) continue;
    const Results r = read(file);
    std::vector<double>& last = force.emplace_back();
    for (int box = 1; box <= 7; ++box)
      last.push_back(named(file, r, fmt::format("ramp_{}", box), "force_z").back());
  }
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  for (size_t box = 0; box < 7; ++box)
    printf("  roller %zu: %.4f and %.4f N\n", box + 1, force[0][box], force[1][box]);
  EXPECT_EQ(force[0].front(), 0);
  EXPECT_GT(largest(force[0]), 100);
  EXPECT_LT(largest_difference(force[0], force[1]), 1e-4 * largest(force[0]));
}

// Water does no work on the stock: the energy balance closes.
TEST(FedPipes, EnergyUnderWater) {
  const std::string path = folder("fed-pipes-water");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kUnderWater);
  run_on_all({input, file});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const auto error = named(file, r, "energy", "error");
  const auto brought = named(file, r, "energy", "brought_in");
  printf("  error %.3g J of %.4g J\n", largest(error), work(brought));
  EXPECT_LT(largest(error), 0.01 * work(brought));
}

TEST(FedPipes, RefuseWhatTheyCannotDo) {
  const std::string path = folder("fed-pipes-bad");
  const std::string input = path + "/case.yaml";
  const std::vector<std::pair<Edits, std::string>> bad{
      {{{"      clamped: true\n", ""}}, "such a line must be clamped at a feeder"},
      {{{"GJ: 1.5e5", "GJ: 1.5e5, stiffness_damping: 0.01"}}, "has 'stiffness_damping'"},
  };
  for (const auto& [edits, text] : bad) {
    write_case(input, kCantilever, edits);
    run::RunOptions o;
    o.case_path = input;
    o.output = path + "/bad.h5";
    o.quiet = true;
    std::string message;
    try {
      run::run(MPI_COMM_WORLD, o);
    } catch (const std::exception& e) {
      message = e.what();
    }
    EXPECT_NE(message.find(text), std::string::npos) << text << ": " << message;
  }
}

}  // namespace
}  // namespace hawser::runs::fed_pipes
