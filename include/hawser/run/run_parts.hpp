// Common parts of the commands that write results: description of the run, statics with messages, and
// progress while reading a case.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/run/progress.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::run {

class Events;

// On rank 0; empty on others, which do not write it.
io::RunInfo run_info(MPI_Comm comm, const model::Case& c, const std::string& petsc_options);
// Repairs and choices, equal ones of several volumes together.
std::vector<std::string> all_notes(const model::Case& c, const std::vector<LoadedVolume>& volumes,
                                   const std::vector<std::string>& choices);
// The case with section lengths that meet the targets of its lines (run/targets.hpp), with notes printed;
// without targets the case itself. restart: results of a continued run, which give the lengths. on_iteration:
// called at every iteration of the search; an exception from it ends the search. Collective.
model::Case with_targets_met(MPI_Comm comm, model::Case c, const std::vector<LoadedVolume>& volumes,
                             Progress& progress, const std::string& restart = "",
                             const std::function<void()>& on_iteration = {});
// Statics of the case with its stages, progress and notes on the equilibrium; returns the report of the last
// stage. on_equilibrium: called with the index of each stage after its equilibrium. Collective; throws as
// Simulation::solve_statics.
StaticsReport solve_static_stages(
    Simulation& sim, Events& events, Progress& progress,
    const std::function<void(size_t)>& on_equilibrium = [](size_t) {});
// Frees the text of a case and reduces its tree to without_values(), once the run no longer reads them.
void forget_file(model::Case& c);
// MPI libraries make malloc retain freed memory, which can be gigabytes.
void release_freed_memory();
io::ReadProgress read_progress(Progress& progress);  // which must live as long

}  // namespace hawser::run
