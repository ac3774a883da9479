// What a run will about cost, from what its parts cost on this machine.
#pragma once

#include <string>

#include "hawser/app/simulation.hpp"

namespace hawser::app {

struct CostParts {
  double residual = 0;  // CPU s: of one residual
  double flow = 0;      // of what the first residual of a step takes longer: the flow of waves
  double tangent = 0;   // of one tangent with its factorisation and solution
  bool statics = false;
  bool meshes = false;            // that lines touch
  double duration = 0, step = 0;  // s, simulated; duration 0: no dynamics
};
// CPU s. Steps, and what each needs, by the mean of the cases that come with the program.
double expected_cost(const CostParts& parts);

// Measures residual and tangent at the start shape; a fraction of a second, or a few evaluations. The state
// stays as it is. Collective.
CostParts measured_parts(Simulation& sim);

// "expected cost: about 12 CPU s, if steps are of about 0.06 s"
std::string cost_sentence(const CostParts& parts);

// Bytes: the most that this process has had in memory so far.
double peak_memory();
// "expected memory: about 0.9 GB", from peak_memory() when the files were read and after measured_parts(). A
// run keeps beside what was measured its accepted states, the matrix of the other stage and rows of results,
// as much again.
std::string memory_sentence(double read, double measured);

}  // namespace hawser::app
