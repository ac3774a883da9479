// A body moves on straight lines between the rows of its table: steps end at the rows.
#include <algorithm>

#include "regression/runs.hpp"

namespace hawser::runs::linear_table {
namespace {

const char* const kCase = R"(
hawser: 1
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 8, EA: 1e6, bending: false}
bodies:
  winch: {motion: {table: {rows: [[0, 0, 0, 0], [0.13, 0, 0, 0.02], [0.37, 0, 0, 0.02], [1.01, 0.1, 0, -0.05], [2, 0, 0, 0]], interpolation: WORD}}}
lines:
  fall: {sections: [{type: rope, length: 20, elements: 10}], end_a: {body: winch, at: [0, 0, 0]}, end_b: free}
dynamics: {duration: 1.5, STEP}
output: {every: 0.5, histories: [{line: fall, at: end_a, name: top}]}
)";

TEST(LinearTable, StepsEndAtTheRows) {
  const std::string path = folder("linear_table");
  const std::vector<double> rows{0, 0.13, 0.37, 1.01}, height{0, 0.02, 0.02, -0.05, 0},
      until{0.13, 0.37, 1.01, 2};
  for (const std::string step : {"step: 0.05", "max_step: 0.1"})
    for (const std::string word : {"linear", "monotone"}) {
      write_case(path + "/case.yaml", kCase, {{"WORD", word}, {"STEP", step}});
      run_on_all({path + "/case.yaml", path + "/case.h5"});
      if (rank_of(MPI_COMM_WORLD) != 0) continue;
      const Results r = read(path + "/case.h5");
      for (size_t i = 1; i < rows.size(); ++i) {
        const bool there = std::any_of(r.step_times.begin(), r.step_times.end(),
                                       [&](double t) { return std::abs(t - rows[i]) < 1e-9; });
        EXPECT_EQ(there, word == "linear") << rows[i] << " " << word << " " << step;
      }
      if (word != "linear") continue;
      const std::vector<double> z = r.column("top", 2);
      ASSERT_EQ(z.size(), r.step_times.size());
      for (size_t i = 0; i < z.size(); ++i) {
        size_t k = 0;
        while (k + 1 < rows.size() && r.step_times[i] > rows[k + 1]) ++k;
        const double share = (r.step_times[i] - rows[k]) / (until[k] - rows[k]);
        EXPECT_NEAR(z[i], height[k] + share * (height[k + 1] - height[k]), 1e-9) << r.step_times[i];
      }
    }
}

}  // namespace
}  // namespace hawser::runs::linear_table
