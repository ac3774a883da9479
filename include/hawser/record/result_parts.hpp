// The lines, the waves and the room for rows of a case in the form that the results file has them.
#pragma once

#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/io/results_size.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser::record {

// with_arcs: as the rank that writes them needs it.
std::vector<io::ResultLine> result_lines(const model::Case& c, const Mesh& mesh, bool with_arcs = true);
// The waves of a case; a Stokes' wave as the linear one of its height.
io::ResultWaves result_waves(const model::Case& c);

// Automatic steps are about this share of the longest one.
inline constexpr double kAutomaticSteps = 0.5;

// What the finished run will have in its results file. steps: how many there will be; 0: not known, which
// takes automatic ones by kAutomaticSteps. checkpoint: numbers in one; 0: none.
io::ExpectedRows expected_rows(const model::Case& c, double steps = 0, double checkpoint = 0);

}  // namespace hawser::record
