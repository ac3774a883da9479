// Rows of the summary and warnings of all ranks on rank 0, and the summary as text.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/recording.hpp"

namespace hawser::record {

// On rank 0 the rows and warnings of all ranks, rank by rank; on the others none. Collective.
void gather_on_first(MPI_Comm comm, std::vector<io::SummaryRow>& rows, std::vector<Warning>& warnings);

// The summary as printed at the end of a run.
std::string summary_table(const std::vector<io::SummaryRow>& rows);

}  // namespace hawser::record
