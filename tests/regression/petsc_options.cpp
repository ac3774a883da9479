// Effect of PETSc options on a run: monitors are allowed; options that change the step control or the solver
// are rejected or have no effect.
#include <petscsys.h>

#include "hawser/base/error.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::petsc_options {
namespace {

const char* const kChain = R"(hawser: 1
title: A chain that swings
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 50, EA: 1e8, bending: false}
lines:
  chain:
    sections: [{type: chain, length: 60, elements: 12}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [45, 0, 10]}
statics: {enabled: true}
dynamics: {duration: 0.2}
output: {every: 0.1}
contact: {between_lines: false}
)";

// Sets an option during its lifetime.
struct Option {
  std::string key;
  Option(const std::string& k, const std::string& value) : key(k) {
    PetscOptionsSetValue(nullptr, key.c_str(), value.c_str());
  }
  ~Option() { PetscOptionsClearValue(nullptr, key.c_str()); }
};

int lines_of(const std::string& file) {
  std::ifstream in(file);
  int n = 0;
  for (std::string line; std::getline(in, line);) ++n;
  return n;
}

TEST(PetscOptions, AnotherJudgeOfStepsIsRefused) {
  const std::string path = folder("petsc-judge");
  const std::string input = path + "/case.yaml";
  write_case(input, kChain);
  for (const auto& [key, value] : {std::pair("-dynamics_ts_adapt_type", "none"),
                                   {"-dynamics_ts_type", "beuler"},
                                   {"-dynamics_snes_type", "ksponly"}}) {
    const Option option(key, value);
    try {
      run::RunOptions run;
      run.case_path = input;
      run.output = path + "/out.h5";
      run.quiet = true;
      run::run(MPI_COMM_WORLD, run);
      FAIL() << key;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(key), std::string::npos) << e.what();
    }
  }
}

// PETSc's monitors show iterations of statics and attempted steps; another line search for statics has no
// effect.
TEST(PetscOptions, MonitorsShowStaticsAndSteps) {
  const std::string path = folder("petsc-monitors");
  const std::string input = path + "/case.yaml";
  write_case(input, kChain);
  run_on_all({input, path + "/plain.h5"});
  {
    const Option statics("-statics_snes_monitor", "ascii:" + path + "/statics.txt");
    const Option search("-statics_snes_linesearch_type", "bt");
    const Option steps("-dynamics_ts_monitor", "ascii:" + path + "/steps.txt");
    run_on_all({input, path + "/shown.h5"});
  }
  const Results plain = read(path + "/plain.h5");
  const Results shown = read(path + "/shown.h5");
  EXPECT_EQ(plain.fields.at("position"), shown.fields.at("position"));
  EXPECT_GE(lines_of(path + "/statics.txt"), 5);
  EXPECT_GE(lines_of(path + "/steps.txt"), static_cast<int>(plain.step_times.size()));
}

}  // namespace
}  // namespace hawser::runs::petsc_options
