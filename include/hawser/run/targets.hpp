// Lengths of sections sought so that the static equilibrium meets the `target` of lines: a tension or an
// angle at an end, a touchdown point, a laid length.
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
  model::Case model;               // with the lengths that were found
  std::vector<std::string> found;  // a sentence a target
};

// Statics at every trial; each line with a target has a bracketed search of its own (math/root_search.hpp).
// All move at once as long as they do not pull at each other, else one after the other, round and round. Met
// to 1e-7 of the tension, 1e-7 rad, 1e-7 of the line's length. The case needs its `tree`. progress: how far
// statics of a trial is; tried: what a trial has found, in a sentence. InputError with the range that was
// found where a target cannot be met, SolveError where several do not settle together. Collective.
MetTargets meet_targets(MPI_Comm comm, const model::Case& c, const std::vector<LoadedVolume>& volumes,
                        const std::function<void(const StaticsReport&)>& progress = {},
                        const std::function<void(const std::string&)>& tried = {});

// The case with the lengths that a run of it has found, from its results file; for a restart. Where that file
// does not fit the case it stays as it is, and the restart will say so.
MetTargets with_lengths_of(const model::Case& c, const std::string& results, MPI_Comm comm);

}  // namespace hawser::run
