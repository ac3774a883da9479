// Contact of lines with lines as a case asks for it.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser::run {

// Pairs of lines (indices, the smaller first) that never feel each other, sorted.
std::vector<std::pair<int, int>> excluded_pairs(const model::Case& c);

// Null where no two lines, nor a line and itself, may touch. What was chosen goes to `details`, a sentence
// each.
std::unique_ptr<LinePairs> make_line_pairs(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                           std::vector<std::string>& details);

// Says how far from places that they share lines do not touch, where that is farther than along one line;
// empty: nowhere.
std::string shared_places_note(const SharedPlaces& places, const Mesh& mesh);

}  // namespace hawser::run
