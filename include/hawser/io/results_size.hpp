// Estimated size of a results file.
#pragma once

#include "hawser/io/results.hpp"

namespace hawser::io {

// Rows after a complete run, and size of its checkpoints.
struct ExpectedRows {
  double outputs = 1, steps = 1;
  double checkpoint = 0;  // numbers per checkpoint; 0: none
};

// Bytes of the HDF5 file. Clashes and contact points, whose number is not predictable, are excluded.
struct ResultsSize {
  double fields = 0, histories = 0, checkpoints = 0, meshes = 0, other = 0;
  double contact_point = 0;  // of each point of contact at an output, which `total` does not contain
  double total() const { return fields + histories + checkpoints + meshes + other; }
};
ResultsSize results_size(const ResultContents& contents, const ExpectedRows& rows);

// Numbers in a checkpoint, as counted by ResultsFile::write_checkpoint, for a run on one rank.
double checkpoint_numbers(const Checkpoint& checkpoint);

}  // namespace hawser::io
