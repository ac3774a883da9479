// Lines, waves and capacity of a case for its results file.
#pragma once

#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/io/results_size.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser::record {

Runs<int> nodes_of_lines(const Mesh& mesh);
std::vector<io::ResultLineLabels> result_line_labels(const model::Case& c, const Mesh& mesh);
// The waves of a case; a Stokes' wave as the linear one of its height.
io::ResultWaves result_waves(const model::Case& c);

// Typical automatic step as a fraction of the longest step.
inline constexpr double kAutomaticSteps = 0.5;

// Expected rows of the finished run. steps: number of steps; 0: unknown, estimated by kAutomaticSteps.
// checkpoint: numbers per checkpoint; 0: none.
io::ExpectedRows expected_rows(const model::Case& c, double steps = 0, double checkpoint = 0);

}  // namespace hawser::record
