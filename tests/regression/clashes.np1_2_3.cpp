// Clash report and clearances of whole runs against formulas, on any number of ranks, and after a restart.
#include <tuple>

#include "hawser/io/clash_rows.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::clashes {
namespace {

// A bar of 6 m falls flat by 0.2 m on the ground, a linear spring, and bounces.
constexpr double kGravity = 9.81, kMass = 50 * 6, kStiffness = 2.0e5 * 6, kFall = 0.2, kStep = 0.001;
const char* const kBar = R"(hawser: 1
environment: {gravity: 9.81}
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e8, EI: 1.0e5, GJ: 1.0e5}
volumes:
  ground:
    shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}
    normal_stiffness: {per_length: 2.0e5}
    smoothing: 0
lines:
  bar:
    sections: [{type: bar, length: 6, elements: 12}]
    end_a: free
    end_b: free
    start: {points: [[0, 0, 0.3], [6, 0, 0.3]]}
contact: {method: METHOD}
statics: false
dynamics: {duration: 1.3, step: 0.001, rho_infinity: 1}
output: {every: 0.1, clashes: {merge_gap: GAP}}
)";

// Bars with different motions fall on each other and on rollers: clashes of lines and of places on volumes.
const char* const kHeap = R"(hawser: 1
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e7, EI: 1.0e5, GJ: 1.0e5, stiffness_damping: 0.002}
bodies:
  carriage: {motion: {velocity: [0, 0, 0.5]}}
volumes:
  left: {shape: {cylinder: {from: [-2, -1, 0], to: [-2, 1, 0], radius: 0.3}}, normal_stiffness: {per_length: 2.0e6}}
  right: {shape: {cylinder: {from: [2, -1, 0], to: [2, 1, 0], radius: 0.3}}, normal_stiffness: {per_length: 2.0e6}}
  rollers: {mesh: rollers.obj, normal_stiffness: {per_length: 2.0e6}, smooth: false}
  lamp: {shape: {sphere: {centre: [0, 5, 2], radius: 0.5}}, body: carriage}
  underside: {mesh: slab.obj, smooth: false, active: {box: [[-20, -20, -0.6], [20, 20, -0.4]]}}
lines:
  lower:
    sections: [{type: bar, length: 8, elements: 16}]
    end_a: free
    end_b: free
    start: {points: [[-4, 0.1, 0.45], [4, 0, 0.41]]}
  upper:
    sections: [{type: bar, length: 6, elements: 13}]
    end_a: free
    end_b: free
    start: {points: [[0.3, -3, 0.8], [0.1, 3, 0.9]]}
  still:
    sections: [{type: bar, length: 10.001, elements: 7}]
    end_a: {anchor: [-4, 5, 4], direction: [1, 0, 0], clamped: true}
    end_b: {anchor: [6, 5, 4], direction: [1, 0, 0], clamped: true}
    start: straight
contact:
  volumes: [left, right, rollers]
  between_lines: {normal_stiffness: {per_length: 1.0e6}, relative_damping: 0.1}
statics: false
dynamics: {duration: 0.5, step: 0.0025}
output:
  every: 0.05
  clashes: {merge_gap: 0.02}
  clearances:
    - {line: upper, other_line: lower}
    - {line: lower, volume: left}
    - {line: upper, volume: rollers, name: hook}
    - {line: still, volume: lamp}
    - {line: still, volume: underside}
)";

// Boxes of these half sizes, as one volume.
void write_boxes(const std::string& path, const std::vector<double>& places, double x1, double y1,
                 double z1) {
  if (rank_of(MPI_COMM_WORLD) == 0) {
    std::ofstream out(path);
    for (const double x : places)
      for (int i = 0; i < 8; ++i)
        out << "v " << x + (i & 1 ? x1 : -x1) << ' ' << (i & 2 ? y1 : -y1) << ' ' << (i & 4 ? z1 : -z1)
            << '\n';
    for (int b = 0; b < static_cast<int>(places.size()); ++b)
      for (const auto& f : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) {
        int v[4];
        std::sscanf(f, "%d %d %d %d", &v[0], &v[1], &v[2], &v[3]);
        for (int& k : v) k += 8 * b;
        out << "f " << v[0] << ' ' << v[1] << ' ' << v[2] << "\nf " << v[0] << ' ' << v[2] << ' ' << v[3]
            << '\n';
      }
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

bool first() { return rank_of(MPI_COMM_WORLD) == 0; }

void expect_same(const std::vector<io::ClashRow>& a, const std::vector<io::ClashRow>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    const auto pair = [](const io::ClashRow& r) { return std::tuple(r.line, r.other_line, r.volume); };
    EXPECT_EQ(pair(a[i]), pair(b[i])) << i;
    for (const auto member :
         {&io::ClashRow::start, &io::ClashRow::end, &io::ClashRow::from, &io::ClashRow::to,
          &io::ClashRow::other_from, &io::ClashRow::other_to, &io::ClashRow::peak_force,
          &io::ClashRow::peak_time, &io::ClashRow::peak_from, &io::ClashRow::peak_to, &io::ClashRow::impulse,
          &io::ClashRow::peak_energy, &io::ClashRow::penetration})
      EXPECT_LE(std::abs(a[i].*member - b[i].*member), tolerance * std::max(std::abs(a[i].*member), 0.01))
          << i;
  }
}

TEST(Clashes, ABarThatBounces) {
  const double omega = std::sqrt(kStiffness / kMass);
  const double speed = std::sqrt(2 * kGravity * kFall);
  const double still = kGravity / (omega * omega);  // m, static penetration by the weight
  const double meets = std::sqrt(2 * kFall / kGravity);
  const double flight = 2 * speed / kGravity;
  const double touches = 2 / omega * (M_PI - std::atan(speed * omega / kGravity));
  const double deep = still + std::hypot(still, speed / omega);
  const double impulse = kMass * (2 * speed + kGravity * touches);
  for (const std::string method : {"line", "nodes"}) {
    const std::string path = folder("clashes_bar_" + method);
    const std::string input = path + "/bar.yaml";
    write_case(input, kBar, {{"METHOD", method}, {"GAP", "0.1"}});
    run_on_all({input, path + "/bounce.h5"});
    write_case(input, kBar, {{"METHOD", method}, {"GAP", "1"}});
    run_on_all({input, path + "/merged.h5"});
    if (!first()) continue;
    const io::ClashTables t = io::read_clashes(path + "/bounce.h5");
    ASSERT_EQ(t.ended.size(), 3u);
    ASSERT_TRUE(t.open.empty());
    for (size_t i = 0; i < 3; ++i) {
      const io::ClashRow& r = t.ended[i];
      const double begin = meets + static_cast<double>(i) * (touches + flight);
      EXPECT_EQ(r.line, 0);
      EXPECT_EQ(r.other_line, -1);
      EXPECT_EQ(r.volume, 0);
      EXPECT_NEAR(r.start, begin, 1.5 * kStep);
      EXPECT_NEAR(r.end, begin + touches, 1.5 * kStep);
      EXPECT_EQ(r.from, 0);
      EXPECT_EQ(r.to, 6);
      EXPECT_NEAR(r.impulse, impulse, 2e-3 * impulse);
      EXPECT_NEAR(r.peak_force, kStiffness * deep, 2e-3 * kStiffness * deep);
      EXPECT_NEAR(r.peak_time, begin + 0.5 * touches, 1.5 * kStep);
      EXPECT_NEAR(r.penetration, deep, 1e-2 * deep);  // the ends have less mass and vibrate
      EXPECT_NEAR(r.peak_energy, 0.5 * kStiffness * deep * deep, 4e-3 * kStiffness * deep * deep);
    }
    const io::ClashTables merged = io::read_clashes(path + "/merged.h5");
    EXPECT_EQ(merged.ended.size(), 0u);
    ASSERT_EQ(merged.open.size(), 1u);
    EXPECT_NEAR(merged.open[0].impulse, 3 * impulse, 1e-2 * impulse);
  }
}

class Heap : public ::testing::Test {
 protected:
  void SetUp() override {
    path = folder("clashes_heap");
    input = path + "/heap.yaml";
    write_boxes(path + "/rollers.obj", {-3.2, 3.2}, 0.1, 1, 0.3);  // below the ends of the lower bar
    write_boxes(path + "/slab.obj", {0}, 19, 19, 0.5);
    write_case(input, kHeap);
  }
  std::string path, input;
};

TEST_F(Heap, OnAnyNumberOfRanks) {
  run_on_one({input, path + "/one.h5"});
  run_on_all({input, path + "/all.h5"});
  if (!first()) return;
  const io::ClashTables one = io::read_clashes(path + "/one.h5");
  const io::ClashTables all = io::read_clashes(path + "/all.h5");
  expect_same(one.ended, all.ended, 1e-6);
  expect_same(one.open, all.open, 1e-6);
  std::printf("%zu clashes ended, %zu go on\n", one.ended.size(), one.open.size());
  // Clashes of lines with each other, and at two places of one volume.
  const auto count = [&](const auto& is) {
    return std::count_if(one.ended.begin(), one.ended.end(), is) +
           std::count_if(one.open.begin(), one.open.end(), is);
  };
  EXPECT_GE(count([](const io::ClashRow& r) { return r.line == 0 && r.other_line == 1; }), 1);
  EXPECT_GE(count([](const io::ClashRow& r) { return r.volume == 2 && r.to < 4; }), 1);
  EXPECT_GE(count([](const io::ClashRow& r) { return r.volume == 2 && r.from > 4; }), 1);
  const Results a = read(path + "/one.h5");
  const Results b = read(path + "/all.h5");
  for (const std::string name : {"upper_to_lower", "lower_to_left", "hook", "still_to_lamp"})
    for (size_t c = 0; c < a.columns.at(name); ++c)
      EXPECT_LE(largest_difference(a.column(name, c), b.column(name, c)), 1e-6) << name << ' ' << c;
}

// The surface of the lamp rises at 0.5 m/s from 1.4 m below a nearly straight line.
TEST_F(Heap, Clearances) {
  run_on_all({input, path + "/heap.h5"});
  if (!first()) return;
  const Results r = read(path + "/heap.h5");
  const auto lamp = r.column("still_to_lamp", 0);
  const auto arc = r.column("still_to_lamp", 1);
  ASSERT_EQ(lamp.size(), r.step_times.size());
  EXPECT_NEAR(lamp.front(), 1.4, 1e-12);
  EXPECT_NEAR(arc.front(), 4.0004, 1e-4);
  EXPECT_NEAR(r.column("still_to_lamp", 2).front(), 0, 1e-6);
  EXPECT_NEAR(r.column("still_to_lamp", 4).front(), 2.5, 1e-9);
  EXPECT_NEAR(lamp.back(), 1.4 - 0.5 * r.step_times.back(), 0.1);
  // The underside of the volume faces away from the line: no clearance.
  for (size_t c = 0; c < r.columns.at("still_to_underside"); ++c)
    for (const double x : r.column("still_to_underside", c)) EXPECT_TRUE(std::isnan(x)) << c;
  // The penetration of the bars is that of the clash report.
  const auto between = r.column("upper_to_lower", 0);
  const double deepest = -*std::min_element(between.begin(), between.end());
  double message = 0;
  const io::ClashTables t = io::read_clashes(path + "/heap.h5");
  for (const auto* rows : {&t.ended, &t.open})
    for (const io::ClashRow& c : *rows)
      if (c.other_line == 1) message = std::max(message, c.penetration);
  EXPECT_GT(message, 1e-4);
  EXPECT_NEAR(deepest, message, 0.02 * message);
  // At the start the axes of the crossing bars are 0.42 m apart, within the tolerance of the sag.
  EXPECT_NEAR(between.front(), 0.85 - 0.43 - 0.2, 5e-3);
}

TEST_F(Heap, ThroughARestart) {
  run_on_all({input, path + "/whole.h5"});
  run_on_all({input, path + "/half.h5", "", 0.2});
  run_on_all({input, path + "/half.h5", path + "/half.h5"});
  if (!first()) return;
  const io::ClashTables whole = io::read_clashes(path + "/whole.h5");
  const io::ClashTables half = io::read_clashes(path + "/half.h5");
  // The second part begins with a new list of candidate pairs, and some step lengths depend on this list.
  const double tolerance = 1e-2;
  expect_same(whole.ended, half.ended, tolerance);
  expect_same(whole.open, half.open, tolerance);
  EXPECT_GT(whole.ended.size(), 1u);
}

}  // namespace
}  // namespace hawser::runs::clashes
