// Search for section lengths with which the static equilibrium meets the `target` of lines: tension or angle
// at an end, touchdown point, laid length.
#pragma once

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/case.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/solve/statics.hpp"

namespace hawser::run {

bool has_targets(const model::Case& c);

struct MetTargets {
  model::Case model;                   // with the lengths found
  std::vector<std::string> sentences;  // one sentence per target
};

// Each trial solves statics; each line with a target has its own bracketed search (math/root_search.hpp). All
// lengths change together while the lines do not interact, else cyclically one by one. Tolerances: 1e-7 of
// the tension, 1e-7 rad, 1e-7 of the line's length. The case needs its `tree`. progress: statics of a trial;
// tried: receives the result of a trial in a sentence. Throws InputError with the range found if a target
// cannot be met, SolveError if several do not converge together. Collective.
MetTargets meet_targets(MPI_Comm comm, const model::Case& c, const std::vector<LoadedVolume>& volumes,
                        const std::function<void(const StaticsReport&)>& progress = {},
                        const std::function<void(const std::string&)>& tried = {});

// The case with the lengths from the results file of an earlier run, for a restart. If the file does not fit,
// the case is unchanged and the restart reports the mismatch.
MetTargets with_lengths_of(const model::Case& c, const std::string& results, MPI_Comm comm);

}  // namespace hawser::run
