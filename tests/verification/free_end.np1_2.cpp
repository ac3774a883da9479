// Lines with one free end that lies on the bed or floats, from case files with the automatic start shape.
// Along a line in equilibrium without friction, T + M²/2EI less the weight up to the height of the point is
// constant. So the tension at a hinge is the weight of the line between the heights of its free end and of
// the hinge.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "../regression/runs.hpp"
#include "hawser/base/error.hpp"
#include "hawser/geometry/segment_distance.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/bed.hpp"
#include "support/mooring.hpp"

namespace hawser::test::free_end {
namespace {

constexpr const char* kWater = "water: {depth: 150}";
constexpr const char* kBed = "water: {depth: 150}, seabed: {friction: 0.4}";
constexpr const char* kChain = "sections: [{type: chain, length: 320, elements: 80}]";
constexpr const char* kHose = "sections: [{type: hose, length: 100, elements: 60}]";

model::Case read(const std::string& environment, const std::string& line, const std::string& bodies = "") {
  return io::read_case_text("hawser: 1\nenvironment: {" + environment + "}\n" + bodies + R"(line_types:
  chain: {library: chain-studlink, diameter: 90 mm, grade: R3S}
  beam: {outer_diameter: 0.25, mass_per_length: 120, EA: 5e8, EI: 3e5, GJ: 3e5}
  light: {outer_diameter: 0.25, mass_per_length: 70, EA: 5e8, EI: 3e5, GJ: 3e5}
  heavy: {outer_diameter: 0.25, mass_per_length: 160, EA: 5e8, EI: 3e5, GJ: 3e5}
  hose: {outer_diameter: 0.5, mass_per_length: 120, EA: 6e7, EI: 2e5, GJ: 2e5}
  cord: {outer_diameter: 0.5, mass_per_length: 120, EA: 6e7, bending: false}
lines:
  r: {)" + line + "}\n",
                            HAWSER_SOURCE_DIR "/tests/free_end.yaml");
}

// Wet fraction of a cylinder's section with its axis at z.
double wet(double z, double radius) {
  const double u = std::clamp(z / radius, -1.0, 1.0);
  const double half = std::acos(u);
  return (half - u * std::sqrt(1 - u * u)) / M_PI;
}

// Weight [N] of a line between the heights `low` and `high`, by Simpson's rule.
double weight_between(const model::Case& c, const std::string& type, double low, double high) {
  const model::LineType& t = c.line_type(type);
  const double g = c.environment.gravity;
  const double d = t.displaced();
  const double displaced = c.environment.water.present ? c.environment.water.density * M_PI / 4 * d * d : 0;
  const auto per_metre = [&](double z) { return g * (t.mass_per_length - displaced * wet(z, 0.5 * d)); };
  constexpr int kParts = 20000;
  double sum = 0;
  for (int i = 0; i <= kParts; ++i)
    sum += (i % 2 ? 4 : i == 0 || i == kParts ? 1 : 2) * per_metre(low + (high - low) * i / kParts);
  return sum * (high - low) / kParts / 3;
}

struct Rest {
  Vec3 held, end;       // m, positions of the ends
  std::vector<Vec3> x;  // from the held end
  double tension = 0;   // N, at the held end
  int iterations = 0;
};

// Statics from the automatic start shape; at most so many iterations, and equal positions on one rank and on
// all.
Rest rest(const model::Case& c, int most_iterations = 150) {
  Simulation all(PETSC_COMM_WORLD, c);
  Simulation one(PETSC_COMM_SELF, c);
  const StaticsReport report = all.solve_statics();
  EXPECT_LE(report.iterations, most_iterations);
  EXPECT_EQ(report.negative_eigenvalues, 0);
  one.solve_statics();
  expect_same_positions(all, all.state().at_rest(), one.state().at_rest(), 1e-6, "statics");
  Rest r;
  r.x = one.state().x;
  r.iterations = report.iterations;
  const bool a = c.lines[0].end_a.kind != model::EndKind::free;
  const size_t held = a ? 0 : r.x.size() - 1;
  const Vec3 pull = Eigen::Map<const Vec3>(one.system().reactions().data() + 3 * one.local().block[held]);
  const bool turns = one.local().rotates(static_cast<int>(held));
  r.tension = turns ? std::abs(pull.dot(one.state().q[held] * Vec3::UnitX())) : pull.norm();
  if (!a) std::reverse(r.x.begin(), r.x.end());
  r.held = r.x.front();
  r.end = r.x.back();
  return r;
}

void expect_tension(const Rest& r, double expected, double most) {
  if (runs::rank_of(MPI_COMM_WORLD) == 0)
    printf("  tension %+.0f N of %.0f N, %d iterations\n", r.tension - expected, expected, r.iterations);
  EXPECT_NEAR(r.tension, expected, most);
}

double off(const Vec3& a, const Vec3& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

// The underside of the free end lies on the bed; penetration is that of its weight.
void expect_on_bed(const model::Case& c, const Vec3& x, const std::string& type) {
  const double radius = 0.5 * c.line_type(type).contact_diameter;
  EXPECT_NEAR(model::height_above_bed(c.environment.seabed, x), radius, 0.05);
}

// The line hangs vertically from 145 m above the bed, and 175 m of it lie on the bed.
TEST(FreeEnd, ComesToLieOnTheBed) {
  struct Row {
    std::string type, line;
    double element;  // m
  };
  const std::string down = ", end_a: {anchor: [0, 0, -5]}, end_b: free";
  for (const Row& row : {Row{"chain", kChain + down, 4},
                         Row{"chain", std::string(kChain) + ", end_a: free, end_b: {anchor: [0, 0, -5]}", 4},
                         Row{"chain", "sections: [{type: chain, length: 320, elements: 40}]" + down, 8},
                         Row{"chain", "sections: [{type: chain, length: 320, elements: 320}]" + down, 1},
                         Row{"beam", "sections: [{type: beam, length: 320, elements: 80}]" + down, 4}}) {
    SCOPED_TRACE(row.line);
    const model::Case c = read(kBed, row.line);
    const Rest r = rest(c);
    expect_on_bed(c, r.end, row.type);
    const double expected = weight_between(c, row.type, r.end.z(), r.held.z());
    // A node of a cable hangs or lies; half of the element between belongs to each part.
    const double most = row.type == "beam" ? 1e-3 : 0.5 * row.element / 145;
    expect_tension(r, expected, most * expected);
    // The bend of a beam has the length (EI/w)^(1/3), 7.6 m.
    const double reach = off(r.held, r.end) - (320 - (r.held.z() - r.end.z()));
    EXPECT_GT(reach, -row.element);
    EXPECT_LT(reach, row.type == "beam" ? 7.6 : row.element);
    // The line neither folds nor runs backwards; the cable may cut the corner at the touchdown with one
    // shorter element.
    int cut = 0;
    for (size_t i = 1; i < r.x.size(); ++i) {
      EXPECT_LT(off(r.held, r.x[i - 1]), off(r.held, r.x[i]) + 1e-3);
      const double length = (r.x[i] - r.x[i - 1]).norm();
      EXPECT_LT(length, row.element + 0.02);
      cut += length < row.element - 0.02;
    }
    EXPECT_LE(cut, 1);
  }
}

// The line has one element on the bed, ends just above the bed, or starts on it.
TEST(FreeEnd, LiesWithLittleOrAllOfIt) {
  struct Row {
    double z, length, hangs;  // m
  };
  for (const Row& row : {Row{-5, 148, 145}, Row{-5, 144, 144}, Row{-149, 320, 1}, Row{-150, 320, 0}}) {
    SCOPED_TRACE(testing::Message() << row.length << " m from " << row.z);
    const model::Case c = read(kBed, "sections: [{type: chain, length: " + std::to_string(row.length) +
                                         ", element_length: 4}], end_a: {anchor: [0, 0, " +
                                         std::to_string(row.z) + "]}, end_b: free");
    const Rest r = rest(c);
    const double w = weight_between(c, "chain", -101, -100);
    EXPECT_GT(w, 0);
    expect_tension(r, w * row.hangs, 4 * w);
    EXPECT_NEAR(off(r.held, r.end), row.length - row.hangs, 4);
  }
}

// On a slope the part on the bed pulls at the line; friction does not act.
TEST(FreeEnd, ComesToLieOnASlope) {
  for (const double slope : {10.0, 35.0}) {
    SCOPED_TRACE(slope);
    const model::Case c =
        read("water: {depth: 150}, seabed: {friction: 0.4, slope_direction_deg: 30, slope_deg: " +
                 std::to_string(slope) + "}",
             std::string(kChain) + ", end_a: {anchor: [0, 0, -5]}, end_b: free");
    const Rest r = rest(c);
    expect_on_bed(c, r.end, "chain");
    const double expected = weight_between(c, "chain", r.end.z(), r.held.z());
    expect_tension(r, expected, 5e-3 * expected);
    EXPECT_NEAR(std::atan2(r.end.y(), r.end.x()), M_PI / 6, 1e-4);
  }
}

// A gridded bed, a valley that descends towards y: the line lies in it, down the slope.
TEST(FreeEnd, ComesToLieOnAMeasuredBed) {
  const std::string path = runs::folder("free_end") + "/bed.xyz";
  if (runs::rank_of(MPI_COMM_WORLD) == 0) {
    std::ofstream grid(path);
    for (int x = -300; x <= 300; x += 20)
      for (int y = -300; y <= 300; y += 20)
        grid << x << " " << y << " " << -150 - 0.1 * y + 2e-4 * x * x << "\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const model::Case c = read("water: {depth: 150}, seabed: {friction: 0.4, grid: {file: " + path + "}}",
                             std::string(kChain) + ", end_a: {anchor: [0, 0, -5]}, end_b: free");
  const Rest r = rest(c);
  expect_on_bed(c, r.end, "chain");
  const double expected = weight_between(c, "chain", r.end.z(), r.held.z());
  expect_tension(r, expected, 5e-3 * expected);
  EXPECT_NEAR(r.end.x(), 0, 0.1);
  EXPECT_GT(r.end.y(), 160);
}

// Two sections of different weight in either order, and a clump weight on the suspended part or on the bed.
TEST(FreeEnd, IsMadeOfParts) {
  const std::string down = ", end_a: {anchor: [0, 0, -5]}, end_b: free";
  const std::string parts[2] = {"{type: light, length: 100, elements: 50}",
                                "{type: heavy, length: 220, elements: 110}"};
  for (const bool light_first : {true, false}) {
    const std::string types[2] = {light_first ? "light" : "heavy", light_first ? "heavy" : "light"};
    const model::Case c = read(
        kBed, "sections: [" + parts[light_first ? 0 : 1] + ", " + parts[light_first ? 1 : 0] + "]" + down);
    const Rest r = rest(c);
    expect_on_bed(c, r.end, types[1]);
    const double joint = r.x[light_first ? 50 : 110].z();
    const double expected =
        weight_between(c, types[0], joint, r.held.z()) + weight_between(c, types[1], r.end.z(), joint);
    expect_tension(r, expected, 1e-3 * expected);
  }
  const double weight = 9.80665 * (5000 - 1025 * 0.6);
  for (const double at : {60.0, 200.0}) {
    const model::Case c = read(kBed, "sections: [{type: beam, length: 320, elements: 160}], masses: [{at: " +
                                         std::to_string(at) + ", mass: 5000, volume: 0.6}]" + down);
    const Rest r = rest(c);
    const double expected = weight_between(c, "beam", r.end.z(), r.held.z()) + (at < 145 ? weight : 0);
    expect_tension(r, expected, 1e-3 * expected);
  }
}

// A hose held above, at or below the surface floats at its draught, straight out. A cable with elements
// shorter than its diameter needs more iterations.
TEST(FreeEnd, Floats) {
  struct Row {
    const char* type;
    double z, most;  // m; of the tension, N
    int elements, iterations = 150;
  };
  for (const Row& row : {Row{"hose", 3, 10, 60}, Row{"hose", 30, 30, 60}, Row{"hose", -40, 30, 60},
                         Row{"cord", 3, 1000, 60, 250},
                         // Half of the element that crosses the surface, whose end carries 9 N, is inclined:
                         // 0.7 % of the tension.
                         Row{"cord", 3, 25, 200, 600}, Row{"cord", 0, 20, 400, 300}}) {
    for (const bool a : {true, false}) {
      SCOPED_TRACE(testing::Message() << row.type << " from " << row.z << (a ? " end A" : " end B"));
      const std::string ends[2] = {"{anchor: [0, 0, " + std::to_string(row.z) + "]}", "free"};
      const model::Case c = read(kWater, "sections: [{type: " + std::string(row.type) +
                                             ", length: 100, elements: " + std::to_string(row.elements) +
                                             "}], end_a: " + ends[a ? 0 : 1] + ", end_b: " + ends[a ? 1 : 0]);
      const Rest r = rest(c, row.iterations);
      EXPECT_NEAR(wet(r.end.z(), 0.25), 120 / (1025 * M_PI / 4 * 0.25), 1e-3);
      const double expected = weight_between(c, row.type, r.end.z(), r.held.z());
      expect_tension(r, expected, row.most);
      EXPECT_GT(off(r.held, r.end), 99 - std::abs(row.z));
    }
  }
}

// The line lies along the current; without current it lies away from the ship that holds it.
TEST(FreeEnd, GoesItsWay) {
  const auto way = [](const Rest& r) { return std::atan2(r.end.y() - r.held.y(), r.end.x() - r.held.x()); };
  for (const double speed : {0.1, 1.5}) {
    const std::string current = ", current: {direction_deg: 60, speed: " + std::to_string(speed) + "}";
    const Rest lies = rest(read(kBed + current,
                                "sections: [{type: beam, length: 320, elements: 80}], "
                                "end_a: {anchor: [0, 0, -5]}, end_b: free"));
    EXPECT_NEAR(way(lies), M_PI / 3, 1e-3);
    const Rest floats = rest(read(kWater + current,
                                  std::string(kHose) + ", end_a: {anchor: [0, 0, -40]}, "
                                                       "end_b: free",
                                  "contact: {between_lines: {friction: 0}}\n"));
    EXPECT_NEAR(way(floats), M_PI / 3, 1e-3);
  }
  const Rest away =
      rest(read(kBed, std::string(kChain) + ", end_a: {body: ship, at: [0, -20, -5]}, end_b: free",
                "bodies: {ship: {position: [0, 0, 0]}}\n"));
  EXPECT_NEAR(way(away), -M_PI / 2, 1e-3);
}

// A line that starts exactly on itself has no defined side of contact: round-off alone decides how it
// separates. Statics finds an equilibrium without penetration, or reports that there is none. It neither
// returns NaN nor iterates forever.
TEST(FreeEnd, AStartOnItselfComesApartOrIsRefused) {
  if (!std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  const model::Case c =
      read(kBed, std::string(kChain) +
                     ", start: {points: [[0, 0, -5], [0, 0, -145], [0, 0, -5], [0, 0, -45]]}"
                     ", end_a: {anchor: [0, 0, -5]}, end_b: free");
  Simulation s(PETSC_COMM_WORLD, c);
  try {
    s.solve_statics();
  } catch (const SolveError& e) {
    EXPECT_NE(std::string(e.what()).find("not at rest after"), std::string::npos) << e.what();
    return;
  }
  const std::vector<LocalElement>& elements = s.local().elements;
  const std::vector<Vec3>& x = s.state().x;
  double least = HUGE_VAL;
  for (const LocalElement& e : elements)
    for (const LocalElement& f : elements) {
      if (f.global < e.global + 2) continue;
      const auto at = [&](int node) { return x[static_cast<size_t>(node)]; };
      least = std::min(
          least, closest_points_of_segments(at(e.first), at(e.second), at(f.first), at(f.second)).distance);
    }
  EXPECT_GT(least, 0.9 * c.line_type("chain").contact_diameter);
}

// A pile clamped in the bed with its direction upwards stands without a note about its direction. Its
// shortening by its weight in water and air is EA u = integral of the weight above (by hand).
TEST(FreeEnd, APileThatIsClampedUpwardsStands) {
  const model::Case c = io::read_case_text(R"(hawser: 1
environment: {water: {depth: 30}}
line_types: {pile: {outer_diameter: 1.0, mass_per_length: 1000, EA: 1e10, EI: 1e10, GJ: 1e10}}
lines:
  pile:
    sections: [{type: pile, length: 45, elements: 90}]
    end_a: {anchor: [0, 0, -30], clamped: true, direction: [0, 0, 1]}
    end_b: free
)",
                                           HAWSER_SOURCE_DIR "/tests/free_end.yaml");
  Simulation s(PETSC_COMM_WORLD, c);
  for (const std::string& note : s.notes()) EXPECT_EQ(note.find("direction"), std::string::npos) << note;
  s.solve_statics();
  const double g = c.environment.gravity;
  const double air = 1000 * g;
  const double lift = 1025 * g * M_PI / 4;
  const double shorter = (0.5 * air * 45 * 45 - 0.5 * lift * 30 * 30) / 1e10;
  const int n = s.local().find(90);
  if (n < 0 || n >= s.local().owned) return;
  const Vec3 top = s.state().x[static_cast<size_t>(n)];
  EXPECT_NEAR(top.z(), 15 - shorter, 1e-5);
  EXPECT_LT(std::hypot(top.x(), top.y()), 1e-9);
}

}  // namespace
}  // namespace hawser::test::free_end
