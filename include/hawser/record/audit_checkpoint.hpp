// The energy audit in a checkpoint, so that a run that goes on adds up from its own start.
#pragma once

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/audit.hpp"

namespace hawser::record {

// start: the energies from which the audit counts.
void save_audit(const Energy& start, const Audit& audit, io::Checkpoint& to);
// What an older file lacks is 0.
void restore_audit(const io::Checkpoint& from, Energy& start, Audit& audit);

// Over all ranks. Collective.
Energy sum_of(MPI_Comm comm, Energy share);

}  // namespace hawser::record
