// What the commands that write results share: the description of the run, lines and bodies in the form of the
// results file, statics with its messages, and what is printed while a case is read.
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
// What was repaired and chosen, the like of several volumes at once.
std::vector<std::string> all_notes(const model::Case& c, const std::vector<LoadedVolume>& volumes,
                                   const std::vector<std::string>& chosen);
// The case with the lengths that meet the targets of its lines (run/targets.hpp), and notes on
// them; the case itself where there are none. restart: results that a run goes on from, and its lengths with
// it. looked: called at every iteration of the search, which ends with what that throws. Collective.
model::Case with_targets_met(MPI_Comm comm, model::Case c, const std::vector<LoadedVolume>& volumes,
                             Progress& progress, const std::string& restart = "",
                             const std::function<void()>& on_iteration = {});
// Statics of the case with its stages, its progress and notes on the equilibrium; what the
// search of the last one was. rested: called with the stage that has come to rest. Collective; throws as
// Simulation::solve_statics does.
StaticsReport solve_statics(
    Simulation& sim, Events& events, Progress& progress,
    const std::function<void(size_t)>& rested = [](size_t) {});
// Of a case that a run does not read again: its text goes, and its tree but for the lines of messages and
// what a restart compares.
void forget_file(model::Case& c);
// MPI libraries tell malloc to keep what is freed, which can be gigabytes.
void give_back_memory();
io::ReadProgress read_progress(Progress& progress);  // which must live as long

}  // namespace hawser::run
