// `hawser responses`: linear responses of the moored bodies to waves about the static equilibrium.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::run {

struct ResponsesOptions {
  std::string case_path;
  std::string output;                // CSV file; empty: <case>-responses.csv beside the case file
  std::vector<std::string> changes;  // changes of the case, KEY=VALUE each
  std::string body;                  // empty: all floating bodies
  Vec3 at = Vec3::Zero();            // m, point of each body, in its frame
  // s, and rad from +x, where waves go to; empty: those of the wave forces of the first body that has them.
  std::vector<double> periods, directions;
  bool quiet = false;
};

// Prints a table of amplitudes and phase lags of each body and writes it, with the columns of `hawser rao`.
// Returns the exit code. Throws InputError and SolveError. Collective.
int responses(MPI_Comm comm, const ResponsesOptions& options);

}  // namespace hawser::run
