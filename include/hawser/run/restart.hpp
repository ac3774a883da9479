// A run's state to a checkpoint and back.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/recorder.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

io::Checkpoint make_checkpoint(Simulation& simulation, record::Recorder& recorder, const Events& events);
// How many numbers one holds of a run that has not begun: without contact and events.
double planned_numbers(Simulation& simulation, record::Recorder& recorder);

// The newest checkpoint of the results file `path`, this rank's share. Throws InputError when there is none
// or its lines or volumes are not those of the simulation. Collective.
io::Checkpoint read_restart(const std::string& path, Simulation& simulation);

// A note if the run of that file was made with other changes of its case than these (KEY=VALUE of --set); on
// rank 0. Collective.
std::vector<std::string> compare_changes(MPI_Comm comm, const std::string& path,
                                         const std::vector<std::string>& changes);

// Throws InputError, naming the term, where terms keep other quantities than the checkpoint holds.
void check_records(const io::Checkpoint& checkpoint, const System& system, const std::string& path);

// Puts dynamics and terms where the checkpoint was taken, on whatever ranks there are now. Collective.
void restore(const io::Checkpoint& checkpoint, Simulation& simulation);

}  // namespace hawser::run
