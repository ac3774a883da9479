// The energy balance contains the work of a rotating body on a line through its end spring, also after a
// restart.
#include "regression/runs.hpp"

namespace hawser::runs::end_spring_audit {
namespace {

constexpr double kHalf = 11, kEnd = 16;  // s

// Beams in air, rotated by a body about two axes, with springs at both ends; clamped for comparison.
const char* const kCase = R"(
hawser: 1
line_types:
  flex: {outer_diameter: 0.25, mass_per_length: 90, EA: 5e8, EI: 3e4, GJ: 3e4}
bodies:
  v: {motion: {harmonic: {rotation_amplitude_deg: [3, 5, 0], rotation_phase_deg: [70, 0, 0], period: 10}, ramp: 10}}
lines:
  one: {sections: [{type: flex, length: 20, elements: 20}], end_a: {body: v, at: [0, 0, 0], direction: [0, 0, -1], HOLD}, end_b: free}
  other: {sections: [{type: flex, length: 20, elements: 20}], end_a: free, end_b: {body: v, at: [0, 5, 0], direction: [0, 0.1, 1], HOLD}}
dynamics: {duration: 16}
output: {every: 1}
)";

class EndSpringAudit : public ::testing::Test {
 protected:
  void SetUp() override { path = folder("end_spring_audit"); }
  std::string put(const std::string& name, const std::string& hold) {
    write_case(path + "/" + name, kCase, {{"HOLD", hold}, {"HOLD", hold}});
    return path + "/" + name;
  }
  static bool first() { return rank_of(MPI_COMM_WORLD) == 0; }
  std::string path;
};

// Error of the energy balance over the work brought in.
TEST_F(EndSpringAudit, CloseAsThatOfAClampedEnd) {
  for (const char* hold : {"clamped: true", "rotational_stiffness: 5e5", "rotational_stiffness: 2e4"}) {
    run_on_all({put("audit.yaml", hold), path + "/audit.h5"});
    if (!first()) continue;
    const Results r = read(path + "/audit.h5");
    const double brought_in = largest(r.column("energy", 5));
    const double error = largest(r.column("energy", 6));
    printf("  %s: brought in up to %.4g J, %.4f %% of it not accounted for\n", hold, brought_in,
           100 * error / brought_in);
    EXPECT_GT(brought_in, 20);
    EXPECT_LT(error, 1e-3 * brought_in) << hold;
  }
}

TEST_F(EndSpringAudit, GoesOnAfterARestart) {
  const std::string input = put("restart.yaml", "rotational_stiffness: 5e5");
  run_on_all({input, path + "/whole.h5", "", kEnd});
  run_on_all({input, path + "/half.h5", "", kHalf});
  run_on_all({input, path + "/rest.h5", path + "/half.h5", kEnd});
  run_on_one({input, path + "/fewer.h5", path + "/half.h5", kEnd});
  if (!first()) return;
  const Results whole = read(path + "/whole.h5");
  // The work of the supports is restored as one sum, so on two ranks it has another round-off.
  const double same = size_of(MPI_COMM_WORLD) == 1 ? 0 : 1e-12;
  for (const auto& [file, tolerance] : {std::pair{"/rest.h5", same}, {"/fewer.h5", 1e-9}}) {
    const Results rest = read(path + file);
    EXPECT_EQ(rest.output_times.front(), kHalf);
    for (size_t c = 0; c < whole.columns.at("energy"); ++c) {
      const auto there = rest.column("energy", c);
      const auto here = tail(whole.column("energy", c), there);
      EXPECT_LE(largest_difference(here, there), tolerance * largest(whole.column("energy", 2)))
          << file << " energy " << c;
    }
  }
}

}  // namespace
}  // namespace hawser::runs::end_spring_audit
