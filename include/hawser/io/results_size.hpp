// How large a results file will be, without making it.
#pragma once

#include "hawser/io/results.hpp"

namespace hawser::io {

// How many rows a finished run leaves, and what its checkpoints hold.
struct ExpectedRows {
  double outputs = 1, steps = 1;
  double checkpoint = 0;  // numbers in a checkpoint; 0: there is none
};

// Bytes of the HDF5 file. Clashes and points of contact, which nobody knows before, are not in it.
struct ResultsSize {
  double fields = 0, histories = 0, checkpoints = 0, meshes = 0, rest = 0;
  double total() const { return fields + histories + checkpoints + meshes + rest; }
};
ResultsSize results_size(const ResultContents& contents, const ExpectedRows& rows);

// Numbers in a checkpoint, as ResultsFile::write_checkpoint counts them, of a run on one rank.
double checkpoint_numbers(const Checkpoint& checkpoint);

}  // namespace hawser::io
