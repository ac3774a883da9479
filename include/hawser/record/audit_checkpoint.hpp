// The energy audit in a checkpoint, so that a continued run counts from the original start.
#pragma once

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/audit.hpp"

namespace hawser::record {

// start: energies from which the audit counts.
void save_audit(const Energy& start, const Audit& audit, io::Checkpoint& to);
// Numbers that an older file lacks are 0.
void restore_audit(const io::Checkpoint& from, Energy& start, Audit& audit);

// Sum over all ranks. Collective.
Energy sum_of(MPI_Comm comm, Energy local);

}  // namespace hawser::record
