// Pipe code checks in whole runs against the formulas with the loads of each output, over every step, and
// after a restart; on 1 and 2 ranks.
#include "hawser/kernels/pipe_codes.hpp"
#include "regression/event_runs.hpp"

namespace hawser::runs::pipe_strength {
namespace {

constexpr double kDensity = 1025, kGravity = 9.80665;

// A pipe from a heaving vessel to the bed, with a section of hose at its upper end.
const char* const kCase = R"(hawser: 1
environment:
  water: {}
  seabed: {depth: 60}
line_types:
  steel: {pipe: {outer_diameter: 0.25, wall_thickness: 0.015, grade: X65, safety_class: medium CONDITION}, contents: {density: 800, pressure: 2 MPa}}
  hose: {outer_diameter: 0.25, mass_per_length: 90, EA: 1e9, EI: 1e6, GJ: 1e6}
bodies:
  vessel: {position: [0, 0, 0], motion: {harmonic: {amplitude: [0, 0, 0.5], period: 4}, ramp: 1}}
lines:
  riser:
    sections: [{type: hose, length: 20, elements: 5}, {type: steel, length: 200, elements: 50}]
    end_a: {body: vessel, at: [0, 0, 5]}
    end_b: {anchor: [190, 0, -59.875]}
contact: {between_lines: false}
dynamics: {duration: 2, max_step: 0.05}
output: {every: 0.5}
)";

PipeCodes codes() {
  PipeSteel s;
  s.outer = 0.25;
  s.wall = 0.015;
  s.smys = 450e6;
  s.smts = 535e6;
  s.safety_class = 1.14;
  return PipeCodes(s);
}

TEST(PipeStrength, AtOutputsAndOverEveryStep) {
  const std::string path = folder("pipe-strength");
  const std::string input = path + "/case.yaml";
  const std::string file = path + "/whole.h5";
  write_case(input, kCase, {{"CONDITION", ""}});
  run_on_all({input, file});
  run_on_one({input, path + "/one.h5"});
  run_on_all({input, path + "/half.h5", "", 1.0});
  run_on_all({input, path + "/half.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results r = read(file);
  const PipeCodes by = codes();
  const size_t nodes = 56;
  const auto of = [&](const char* field, size_t output, size_t node) {
    return r.fields.at(field).at(nodes * output + node);
  };
  double most = 0;
  for (size_t k = 0; k < r.output_times.size(); ++k)
    for (size_t n = 0; n < nodes; ++n) {
      const double found = of("dnv_local_buckling", k, n);
      ASSERT_EQ(std::isnan(found), n < 5) << n;
      if (n < 5) continue;
      const auto loads = [&](size_t at) {
        return PipeLoads{of("bending_moment_2", at, n), of("bending_moment_3", at, n),
                         of("effective_tension", at, n)};
      };
      const double depth = -r.fields.at("position").at(3 * (nodes * k + n) + 2);
      const double outside = kDensity * kGravity * std::max(depth, 0.0);
      const double inside = 2e6 + 800 * kGravity * depth;
      EXPECT_NEAR(found, by.local_buckling(loads(0), loads(k), 1, outside, inside), 1e-12) << k << " " << n;
      EXPECT_NEAR(of("api_bending_pressure", k, n),
                  by.bending_and_pressure(0.125 * of("curvature", k, n), outside, inside), 1e-12);
      EXPECT_NEAR(of("api_tension_pressure", k, n),
                  by.tension_and_pressure(loads(k).tension, outside, inside), 1e-12);
      most = std::max(most, found);
    }
  // The maximum over all steps is at least that at outputs, and equal on one rank and after a restart.
  const auto largest_of = [&](const std::string& from) {
    const io::h5::Id h5 = io::h5::open_read(from);
    const auto all = io::h5::read_array(h5, "statistics/dnv_local_buckling").values;
    double largest = 0;
    for (size_t n = 5; n < nodes; ++n) largest = std::max(largest, all.at(6 * n + 2));
    return largest;
  };
  EXPECT_GE(largest_of(file), most * (1 - 1e-12));
  EXPECT_LE(largest_of(file), 1.2 * most);
  EXPECT_NEAR(largest_of(path + "/one.h5"), largest_of(file), 1e-6);
  EXPECT_NEAR(largest_of(path + "/half.h5"), largest_of(file), 1e-9);
}

// The factor gamma_C of functional loads applies on the seabed only.
TEST(PipeStrength, ConditionOnTheSeabed) {
  const std::string path = folder("pipe-condition");
  const std::string input = path + "/case.yaml";
  for (const auto& [name, text] :
       {std::pair("plain", ""), {"uneven", ", condition_factor: {seabed: 1.07}"}}) {
    write_case(input, kCase, {{"CONDITION", text}, {"duration: 2", "duration: 0.1"}});
    run_on_all({input, path + "/" + name + ".h5"});
  }
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  const Results plain = read(path + "/plain.h5");
  const Results uneven = read(path + "/uneven.h5");
  const PipeCodes by = codes();
  const double touchdown = named(path + "/plain.h5", plain, "touchdown", "end_a_arc_length").front();
  EXPECT_GT(touchdown, 60);
  EXPECT_LT(touchdown, 120);
  for (size_t n = 5; n < 56; ++n) {
    const double arc = 4. * static_cast<double>(n);
    const auto of = [&](const char* field) { return plain.fields.at(field).at(n); };
    const PipeLoads rest{of("bending_moment_2"), of("bending_moment_3"), of("effective_tension")};
    const double depth = -plain.fields.at("position").at(3 * n + 2);
    const double expected =
        by.local_buckling(rest, rest, arc >= touchdown ? 1.07 : 1, kDensity * kGravity * std::max(depth, 0.0),
                          2e6 + 800 * kGravity * depth);
    EXPECT_NEAR(uneven.fields.at("dnv_local_buckling").at(n), expected, 1e-12) << n;
  }
}

TEST(PipeStrength, BadInput) {
  const std::string path = folder("pipe-bad");
  const std::string input = path + "/case.yaml";
  write_case(input, kCase, {{"grade: X65, ", ""}, {"CONDITION", ""}});
  EXPECT_NE(events::error_of(input, path + "/out.h5").find("need the 'grade' of the steel as well"),
            std::string::npos);
}

}  // namespace
}  // namespace hawser::runs::pipe_strength
