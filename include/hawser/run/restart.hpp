// Conversion of a run's state to a checkpoint and back.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/recorder.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

io::Checkpoint make_checkpoint(Simulation& simulation, record::Recorder& recorder, const Events& events);
// Numbers in a checkpoint of a run that has not begun, without contact and events.
double planned_numbers(Simulation& simulation, record::Recorder& recorder);

// This rank's share of the newest checkpoint in the results file `path`. Throws InputError if there is none
// or its lines or volumes differ from those of the simulation. Collective.
io::Checkpoint read_restart(const std::string& path, Simulation& simulation);

// Note if the run in that file had other changes of its case (KEY=VALUE of --set); on rank 0. Collective.
std::vector<std::string> compare_changes(MPI_Comm comm, const std::string& path,
                                         const std::vector<std::string>& changes);

// Throws InputError that names the term if terms store other quantities than the checkpoint has.
void check_records(const io::Checkpoint& checkpoint, const System& system, const std::string& path);

// Restores dynamics and terms from a checkpoint, on any number of ranks. Collective.
void restore(const io::Checkpoint& checkpoint, Simulation& simulation);

}  // namespace hawser::run
