// The energy audit in a checkpoint, so that a continued run counts from the original start.
#pragma once

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/audit.hpp"

namespace hawser::record {

// start: energies from which the audit counts.
void save_audit(const Energy& start, const Audit& audit, io::Checkpoint& to);
// True if the checkpoint has all numbers of save_audit; those of an earlier version may not.
bool has_audit(const io::Checkpoint& c);
// Throws std::out_of_range if has_audit is false.
void restore_audit(const io::Checkpoint& from, Energy& start, Audit& audit);

// Sum over all ranks. Collective.
Energy sum_of(MPI_Comm comm, Energy local);

}  // namespace hawser::record
