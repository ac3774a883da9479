// A farm in whole runs: a platform that is moved and rotated, with the waves rotated by the same angle and in
// the same phase, moves as the platform alone; a farm continues from a checkpoint, on one rank and on two.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/waves.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::farm {
namespace {

constexpr double kHeight = 3, kPeriod = 9, kDepth = 200;  // m, s, m
constexpr double kDirection = 20, kHeading = 37;          // deg

// The spar of the tutorial with its coefficients, a boat moved by response amplitude operators, a sled in
// harmonic motion, and lines to all of them.
std::string platform(double direction, double phase, bool alone) {
  const std::string sea = fmt::format(
      "environment:\n"
      "  water: {{density: 1025, depth: {:g}}}\n"
      "  current: {{speed: 0.5, direction_deg: {:.17g}}}\n"
      "  waves: {{regular: {{height: {:g}, period: {:g}, direction_deg: {:.17g}, phase_deg: {:.17g}}}, ramp: "
      "4}}\n"
      "  seabed: {{depth: {:g}, normal_stiffness: {{per_area: 1e5}}, friction: 0.4}}\n"
      "contact: {{between_lines: false}}\n"
      "statics: {{tolerance: 1e-11}}\n"
      "dynamics: {{duration: 6, step: 0.1, tolerance: 1e-11}}\n",
      kDepth, direction, kHeight, kPeriod, direction, phase, kDepth);
  if (!alone) return sea;
  return "hawser: 1\n" + sea + R"(
line_types:
  chain: {outer_diameter: 0.2, mass_per_length: 300, EA: 1e9, bending: false}
  hose: {outer_diameter: 0.3, mass_per_length: 120, EA: 1e8, EI: 1e6, GJ: 1e6}
bodies:
  spar:
    floating:
      mass: 28640 t
      centre_of_mass: [0, 0, -54]
      inertia: [4.5e10, 4.5e10, 1.5e9]
      hydrodynamics:
        wamit: spar
        displaced_volume: 28274
        place: [2, 1, 0]
        heading_deg: 3
        stiffness: [[2e6, 0, 0, 0, 0, 0], [0, 3e5, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e9]]
        quadratic_damping: [1.0e6, 1.0e6, 3e5, 1.5e11, 1.5e11, 0]
      loads: [{force: [1.0e6, 2.0e5, 0], at: [0, 0, 90], axes: body}]
  boat:
    position: [120, 30, 0]
    rotation_deg: [0, 0, 25]
    motion: {rao: {rows: [[8, 0, 0.4, 80, 0, 0, 0.9, 10, 0, 0, 2, 100, 0, 0], [8, 90, 0, 0, 0.5, 85, 0.9, 10, 3, 95, 0, 0, 0, 0],
                          [8, 180, 0.4, -80, 0, 0, 0.9, 10, 0, 0, 2, -100, 0, 0], [8, 270, 0, 0, 0.5, -85, 0.9, 10, 3, -95, 0, 0, 0, 0]]}}
  sled: {position: [60, -40, -20], motion: {harmonic: {amplitude: [1, 2, 0], phase_deg: [0, 50, 0], rotation_amplitude_deg: [3, 2, 4], period: 5}, ramp: 3}}
lines:
  bow:
    sections: [{type: chain, length: 640, elements: 20}]
    end_a: {anchor: [-600, 0, -200]}
    end_b: {body: spar, at: [-10, 0, -20]}
  port:
    sections: [{type: chain, length: 640, elements: 20}]
    end_a: {anchor: [300, 519.6, -200]}
    end_b: {body: spar, at: [5, 8.66, -20]}
  starboard:
    sections: [{type: chain, length: 640, elements: 20}]
    end_a: {anchor: [300, -519.6, -200]}
    end_b: {body: spar, at: [5, -8.66, -20]}
  hose:
    sections: [{type: hose, length: 140, elements: 14}]
    end_a: {body: spar, at: [10, 0, -2]}
    end_b: {body: boat, at: [-5, 0, -1]}
  tow:
    sections: [{type: hose, length: 60, elements: 6}]
    end_a: {anchor: [60, 20, -30], direction: [0.1, -1, 0], clamped: true}
    end_b: {body: sled, at: [1, 2, 0.5]}
links:
  spring: {end_a: {body: spar, at: [0, 0, -60]}, end_b: {anchor: [40, 30, -90]}, stiffness: 1e5}
output: {every: 1, histories: [{body: spar}]}
)";
}

class FarmRuns : public ::testing::Test {
 protected:
  void SetUp() override {
    path = folder("farm");
    if (rank_of(MPI_COMM_WORLD) == 0)
      for (const char* file : {"spar.1", "spar.3", "spar.hst"})
        std::filesystem::copy_file(std::string(HAWSER_SOURCE_DIR "/docs/tutorial/") + file, path + "/" + file,
                                   std::filesystem::copy_options::overwrite_existing);
    write_case(path + "/alone.yaml", platform(kDirection, 0, true));
  }
  std::string path;
};

// Largest difference between `here` and the positions `there` moved back by x, y [m] and rotated by minus
// `heading` [rad].
double apart(const std::vector<double>& here, const std::vector<double>& there, double x, double y,
             double heading) {
  double most = here.empty() || here.size() != there.size() ? HUGE_VAL : 0;
  for (size_t i = 0; i + 2 < std::min(here.size(), there.size()); i += 3) {
    const double dx = there[i] - x;
    const double dy = there[i + 1] - y;
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    most = std::max({most, std::abs(c * dx + s * dy - here[i]), std::abs(c * dy - s * dx - here[i + 1]),
                     std::abs(there[i + 2] - here[i + 2])});
  }
  return most;
}

TEST_F(FarmRuns, TurnedInTurnedWavesIsTheSame) {
  // The phase for which the rotated wave has at the platform's place the phase of the other wave at the
  // origin: it lags by k x.
  constexpr double x = 700, y = -400, kDegree = M_PI / 180;
  const double direction = kDirection + kHeading;
  const double k = wave_number(2 * M_PI / kPeriod, kDepth, 9.80665);
  const double lag = k * (x * std::cos(direction * kDegree) + y * std::sin(direction * kDegree));
  for (const double sign : {1., -1.}) {  // one of the two sign conventions of the phase is right
    write_case(path + "/farm.yaml",
               fmt::format("hawser: 1\nfarm: {{of: alone.yaml, at: {{T: [{:g}, {:g}, {:g}]}}}}\n"
                           "output: {{every: 1, histories: [{{body: T/spar}}]}}\n",
                           x, y, kHeading) +
                   platform(direction, sign * lag / kDegree, false));
    run_on_all({path + "/farm.yaml", path + (sign > 0 ? "/farm.h5" : "/farm-.h5")});
  }
  run_on_all({path + "/alone.yaml", path + "/alone.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results alone = read(path + "/alone.h5");
  const Results one = read(path + "/farm.h5");
  const Results two = read(path + "/farm-.h5");
  const auto difference = [&](const Results& r) {
    return apart(alone.fields.at("position"), r.fields.at("position"), x, y, kHeading * kDegree);
  };
  const Results& turned = difference(one) < difference(two) ? one : two;
  const double moved =
      apart(alone.fields.at("position"), turned.fields.at("position"), x, y, kHeading * kDegree);
  double tension = 0;
  const auto& a = alone.fields.at("effective_tension");
  const auto& b = turned.fields.at("effective_tension");
  for (size_t i = 0; i < a.size(); ++i) tension = std::max(tension, std::abs(a[i] - b[i]));
  printf("  positions differ by %.1e m, tensions by %.1e of the largest\n", moved, tension / largest(a));
  EXPECT_LT(moved, 1e-8 * 600);
  EXPECT_LT(tension, 1e-8 * largest(a));
  EXPECT_GT(std::max(difference(one), difference(two)), 0.1) << "waves of another phase would not show";
}

// A line that starts from the results of a run of the platform alone starts so at each place, rotated with
// the platform; `start` of the farm uses the names of the lines in the farm.
TEST_F(FarmRuns, StartsFromOtherRuns) {
  const std::string sea = platform(kDirection, 0, false);
  write_case(path + "/still.yaml", platform(kDirection, 0, true), {{"duration: 6", "duration: 0.2"}});
  run_on_all({path + "/still.yaml", path + "/still.h5"});
  write_case(path + "/from.yaml", platform(kDirection, 0, true),
             {{"  hose:\n", "  hose:\n    start: {from: still.h5}\n"}});
  const auto farm = [&](const std::string& of, const std::string& more) {
    write_case(path + "/starts.yaml",
               "hawser: 1\nfarm: {of: " + of + ", at: {T: [700, -400, 37]}}\n" + more + sea,
               {{"duration: 6", "duration: 0.2"}});
    return path + "/starts.yaml";
  };
  const std::string first = farm("still.yaml", "");
  run_on_all({first, path + "/turned.h5"});
  const model::Case by_platform = io::read_case(farm("from.yaml", ""));
  const model::Case by_name = io::read_case(farm("still.yaml", "start: {from: turned.h5}\n"));
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const auto positions = [](const std::string& file) { return read(file).fields.at("position"); };
  const std::vector<double> alone = positions(path + "/still.h5");
  const std::vector<double> there = positions(path + "/turned.h5");
  const auto of = [](const model::Case& c) {
    std::vector<double> out;
    for (const Vec3& x : c.line("T/hose").previous_shape->position)
      out.insert(out.end(), x.data(), x.data() + 3);
    return out;
  };
  // Of the last output. Lines are in the order of the file: the hose is the fourth, 15 nodes after three
  // lines of 21.
  const auto hose = [](const std::vector<double>& all) {
    const size_t nodes = 3 * 21 + 15 + 7;
    const size_t last = all.size() - 3 * nodes;
    return std::vector<double>(all.begin() + static_cast<long>(last + 3 * 63),
                               all.begin() + static_cast<long>(last + 3 * 78));
  };
  EXPECT_EQ(by_platform.line("T/bow").previous_shape, nullptr);
  EXPECT_LT(apart(hose(alone), of(by_platform), 700, -400, kHeading * M_PI / 180), 1e-9);
  EXPECT_LT(largest_difference(hose(there), of(by_name)), 1e-12);
  EXPECT_NE(by_name.line("T/bow").previous_shape, nullptr);
}

TEST_F(FarmRuns, GoesOnFromACheckpoint) {
  write_case(path + "/two.yaml",
             "hawser: 1\nfarm: {of: alone.yaml, at: [[0, 0], [1500, 200, 120]]}\n"
             "lines: {export: {sections: [{type: hose, length: 1600, elements: 40}], end_a: {body: T1/spar, "
             "at: [10, 0, -30]}, "
             "end_b: {body: T2/spar, at: [10, 0, -30]}}}\n"
             "output: {every: 1, histories: [{body: T2/spar}, {line: export, at: end_b, name: export}]}\n" +
                 platform(kDirection, 0, false));
  run_on_all({path + "/two.yaml", path + "/whole.h5"});
  run_on_one({path + "/two.yaml", path + "/half.h5", "", 3});
  run_on_all({path + "/two.yaml", path + "/rest.h5", path + "/half.h5"});
  // The file of the platform is a part of the case and must not change.
  write_case(path + "/alone.yaml", platform(kDirection, 0, true), {{"stiffness: 1e5}", "stiffness: 2e5}"}});
  run::RunOptions changed;
  changed.case_path = path + "/two.yaml";
  changed.output = path + "/changed.h5";
  changed.restart = path + "/half.h5";
  changed.quiet = true;
  std::string why;
  try {
    run::run(MPI_COMM_WORLD, changed);
  } catch (const InputError& e) {
    why = e.what();
  }
  EXPECT_NE(why.find("alone.yaml: links.spring differs from the checkpoint"), std::string::npos) << why;
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results whole = read(path + "/whole.h5");
  const Results rest = read(path + "/rest.h5");
  const std::vector<double>& there = rest.fields.at("position");
  ASSERT_FALSE(there.empty());
  const std::vector<double> here = tail(whole.fields.at("position"), there);
  EXPECT_LT(largest_difference(here, there), 1e-7);
}

// Two entries that use the same file are changed separately, and a restart rejects a change of either.
TEST_F(FarmRuns, EntriesOfOneFileAreSeparateAtARestart) {
  write_case(
      path + "/twins.yaml",
      "hawser: 1\nfarm: [{of: alone.yaml, at: [[0, 0]]}, {of: alone.yaml, name: S, at: [[1500, 200]]}]\n"
      "output: {every: 1}\n" +
          platform(kDirection, 0, false));
  run_on_one({path + "/twins.yaml", path + "/twins-half.h5", "", 0.5});
  for (const char* entry : {"farm[0]", "farm[1]"}) {
    run::RunOptions changed;
    changed.case_path = path + "/twins.yaml";
    changed.output = path + "/twins-changed.h5";
    changed.restart = path + "/twins-half.h5";
    changed.changes = {std::string(entry) + ".of.links.spring.stiffness=2e5"};
    changed.quiet = true;
    std::string why;
    try {
      run::run(MPI_COMM_WORLD, changed);
    } catch (const InputError& e) {
      why = e.what();
    }
    EXPECT_NE(why.find(std::string(entry) + ", alone.yaml: links.spring differs from the checkpoint"),
              std::string::npos)
        << entry << ": " << why;
  }
}

}  // namespace
}  // namespace hawser::runs::farm
