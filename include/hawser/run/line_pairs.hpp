// Setup of contact between lines.
#pragma once

#include <mpi.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/advice/statics.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser::run {

// Sorted pairs of lines (indices, the smaller first) without contact with each other.
std::vector<std::pair<int, int>> excluded_pairs(const model::Case& c);

// Null if no two lines, and no line and itself, may touch. details: receives choices, one sentence each.
std::unique_ptr<LinePairs> make_line_pairs(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                           std::vector<std::string>& details);

// Note on the distance from shared places within which lines have no contact, if longer than for a single
// line; empty: none.
std::string shared_places_note(const SharedPlaces& places, const Mesh& mesh);

// The two lines, if any, whose contact with each other carries more than the largest tension of one of them,
// as that of two hooked slings. evaluated: the state evaluated last without derivatives. Collective.
std::optional<advice::HookedLines> hooked_lines(const System& system, const Kinematics& evaluated);

}  // namespace hawser::run
