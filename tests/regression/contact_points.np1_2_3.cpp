// Contact points at outputs: their forces against the nodal fields, their positions against the surfaces, on
// any number of ranks and after a restart.
#include <array>

#include "hawser/io/contact_rows.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::contact_points {
namespace {

// A rope is drawn over a taut wire and a roller; a sliding box on the ground comes to rest.
const char* const kCase = R"(hawser: 1
line_types:
  wire: {outer_diameter: 0.1, mass_per_length: 30, EA: 1.0e7, EI: 1.0e4, GJ: 1.0e4, stiffness_damping: 0.005}
  rope: {outer_diameter: 0.06, mass_per_length: 30, EA: 1.0e7, EI: 5.0e2, GJ: 5.0e2, stiffness_damping: 0.005}
bodies:
  carriage: {motion: {velocity: [0, 0.5, 0], ramp: 0.3}}
  box: {position: [0, 8, -0.20075], floating: {mass: 1000, inertia: [200, 200, 200], velocity: [0, 0.3, 0], stiffness: [100, 100, 0],
                  turning_stiffness: [0, 0, 100], loads: [{force: [0, 0, -3000]}]}}
volumes:
  lamp: {shape: {sphere: {centre: [0, 0, 9], radius: 1}}}
  roller: {shape: {cylinder: {from: [-2, 1, -0.36], to: [2, 1, -0.36], radius: 0.2}}, friction: 0.2,
           normal_stiffness: {per_length: 2.0e6}}
  ground: {shape: {plane: {point: [0, 0, -0.7], normal: [0, 0, 1]}}, normal_stiffness: {per_point: 1.0e6},
           friction: 0.3}
  box: {shape: {box: {centre: [0, 0, 0], size: [1, 1, 1]}}, body: box, friction: 0.3,
        normal_stiffness: {per_point: 1.0e6}, relative_damping: 0.3}
lines:
  wire:
    sections: [{type: wire, length: 7.98, elements: 24}]
    end_a: {anchor: [-4, 0, 0]}
    end_b: {anchor: [4, 0, 0]}
  rope:
    sections: [{type: rope, length: 8.1, elements: 34}]
    end_a: {body: carriage, at: [0, -4, 0.12]}
    end_b: {body: carriage, at: [0.2, 4, 0.12]}
    start: straight
  on_the_ground:  # where there are several ranks it is cut
    sections: [{type: rope, length: 20, elements: 60}]
    end_a: {anchor: [-10, -8, -0.6701]}
    end_b: {anchor: [10, -8, -0.6701]}
    start: straight
contact:
  volumes: [roller, ground, box]
  between_lines: {normal_stiffness: {per_length: 2.0e6}, friction: 0.3, relative_damping: 0.1}
dynamics: {duration: 0.4, step: auto, max_step: 0.02}
output: {every: 0.05}
)";
constexpr double kRope = 0.03, kWire = 0.05, kRoller = 0.2, kWeight = 3000;

struct Point {
  std::array<int, 4> pair{};  // line, other line, volume, other volume
  Vec3 place, force;
  bool operator<(const Point& o) const {
    return std::tuple(pair, place.x(), place.y()) < std::tuple(o.pair, o.place.x(), o.place.y());
  }
};
using Outputs = std::vector<std::vector<Point>>;

Outputs read_points(const std::string& path) {
  const auto file = io::h5::open_read(path);
  const auto counts = io::h5::read_array(file, io::kContactCounts);
  const auto pairs = io::h5::read_array(file, io::kContactPairs);
  const auto places = io::h5::read_array(file, io::kContactPositions);
  const auto forces = io::h5::read_array(file, io::kContactForces);
  Outputs out;
  size_t row = 0;
  for (const double end : counts.values) {
    auto& points = out.emplace_back();
    for (; row < static_cast<size_t>(end); ++row) {
      Point& p = points.emplace_back();
      for (size_t i = 0; i < 4; ++i) p.pair[i] = static_cast<int>(pairs.values[4 * row + i]);
      p.place = Eigen::Map<const Vec3>(&places.values[3 * row]);
      p.force = Eigen::Map<const Vec3>(&forces.values[3 * row]);
    }
    std::sort(points.begin(), points.end());
  }
  return out;
}

void expect_same(const Outputs& a, const Outputs& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].size(), b[k].size()) << k;
    for (size_t i = 0; i < a[k].size(); ++i) {
      EXPECT_EQ(a[k][i].pair, b[k][i].pair);
      EXPECT_LE((a[k][i].place - b[k][i].place).norm(), tolerance);
      EXPECT_LE((a[k][i].force - b[k][i].force).norm(), tolerance * kWeight);
    }
  }
}

class ContactPoints : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    path = folder("contact_points");
    input = path + "/case.yaml";
    write_case(input, kCase);
    run_on_one({input, path + "/one.h5"});
    run_on_all({input, path + "/all.h5"});
  }
  static inline std::string path, input;
};

TEST_F(ContactPoints, SumToTheForcesAndLieOnTheSurfaces) {
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Outputs outputs = read_points(path + "/all.h5");
  const Results r = read(path + "/all.h5");
  ASSERT_EQ(outputs.size(), r.output_times.size());
  const auto poses = io::h5::read_array(io::h5::open_read(path + "/all.h5"), "bodies/position");
  constexpr size_t kWireNodes = 25, kRopeEnds = 60, kNodes = 121;
  const auto sum_of = [&](const std::string& field, size_t output, size_t from, size_t to) {
    Vec3 sum = Vec3::Zero();
    for (size_t n = from; n < to; ++n)
      sum += Eigen::Map<const Vec3>(&r.fields.at(field)[3 * (kNodes * output + n)]);
    return sum;
  };
  std::array<int, 4> found{};  // counts: roller, two lines, line on the ground, box on the ground
  double slid = 0;             // N, largest friction of the box
  for (size_t k = 0; k < outputs.size(); ++k) {
    Vec3 roller = Vec3::Zero(), lines = Vec3::Zero(), ground = Vec3::Zero(), box = Vec3::Zero();
    double most = 0;
    const double middle = poses.values[6 * k + 4];  // m, y of the box
    for (const Point& p : outputs[k]) {
      most = std::max(most, p.force.norm());
      if (p.pair == std::array{1, -1, 1, -1}) {
        roller += p.force;
        ++found[0];
        // Tolerance: L²/(8 R) of some centimetres in contact.
        EXPECT_NEAR(std::hypot(p.place.y() - 1, p.place.z() + 0.36), kRoller, 1e-3) << k;
      } else if (p.pair == std::array{0, 1, -1, -1}) {
        lines += p.force;
        ++found[1];
        // In the middle of the overlap.
        double wire = 1, rope = 1;
        for (size_t n = 0; n + 1 < kRopeEnds; ++n) {
          if (n + 1 == kWireNodes) continue;
          const Eigen::Map<const Vec3> a(&r.fields.at("position")[3 * (kNodes * k + n)]);
          const Eigen::Map<const Vec3> b(&r.fields.at("position")[3 * (kNodes * k + n + 1)]);
          const double share = std::clamp((p.place - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
          double& nearest = n < kWireNodes ? wire : rope;
          nearest = std::min(nearest, (p.place - a - share * (b - a)).norm());
        }
        const auto& depths = r.fields.at("line_penetration");
        const auto first = depths.begin() + static_cast<std::ptrdiff_t>(kNodes * k);
        const double half = 0.5 * *std::max_element(first, first + kNodes);
        const double chord = 3e-3;
        EXPECT_LE(wire, kWire + chord) << k;
        EXPECT_GE(wire, kWire - half - chord) << k;
        EXPECT_LE(rope, kRope + chord) << k;
        EXPECT_GE(rope, kRope - half - chord) << k;
      } else if (p.pair == std::array{2, -1, 2, -1}) {
        ground += p.force;
        ++found[2];
        EXPECT_NEAR(p.place.z(), -0.7, 1e-6);
      } else {
        ASSERT_EQ(p.pair, (std::array{-1, -1, 2, 3}));
        box += p.force;
        ++found[3];
        EXPECT_NEAR(p.place.z(), -0.7, 1e-6);
        EXPECT_NEAR(std::abs(p.place.x()), 0.5, 1e-3);
        EXPECT_NEAR(std::abs(p.place.y() - middle), 0.5, 1e-3);
      }
    }
    const double tolerance = 1e-6 * std::max(most, 1.0) * 20;  // single precision
    EXPECT_LE((roller - sum_of("contact_force", k, kWireNodes, kRopeEnds)).norm(), tolerance) << k;
    EXPECT_LE((ground - sum_of("contact_force", k, kRopeEnds, kNodes)).norm(), 10 * tolerance) << k;
    EXPECT_LE((lines - sum_of("line_contact_force", k, 0, kWireNodes)).norm(), tolerance) << k;
    EXPECT_LE((lines + sum_of("line_contact_force", k, kWireNodes, kRopeEnds)).norm(), tolerance) << k;
    slid = std::max(slid, box.head<2>().norm());
    // The force acts on the volume with the smaller number, the ground.
    if (k == 0) {
      EXPECT_NEAR(box.z(), -kWeight, 1e-3 * kWeight);
    }
  }
  EXPECT_GE(found[0], 5);
  EXPECT_GE(found[1], 5);
  EXPECT_EQ(found[2], 60 * static_cast<int>(outputs.size()));
  EXPECT_EQ(found[3], 4 * static_cast<int>(outputs.size()));
  EXPECT_NEAR(slid, 0.3 * kWeight, 0.02 * kWeight);
}

TEST_F(ContactPoints, OnAnyNumberOfRanks) {
  if (rank_of(MPI_COMM_WORLD) == 0)
    expect_same(read_points(path + "/one.h5"), read_points(path + "/all.h5"), 1e-5);
}

TEST_F(ContactPoints, ThroughARestart) {
  run_on_all({input, path + "/half.h5", "", 0.2});
  run_on_all({input, path + "/half.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) == 0)
    expect_same(read_points(path + "/all.h5"), read_points(path + "/half.h5"), 1e-5);
}

}  // namespace
}  // namespace hawser::runs::contact_points
