// `hawser modes`: natural frequencies and mode shapes of a case about its static equilibrium.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace hawser::run {

struct ModesOptions {
  std::string case_path;
  std::string output;                // results file; empty: <case>-modes.h5 beside the case file
  std::string options_text;          // PETSc options, for the record
  std::vector<std::string> changes;  // changes of the case, KEY=VALUE each
  int count = 10;
  bool added_mass = true;  // added mass of the water
  bool quiet = false;
};

// Prints the table of modes and writes them as outputs of a results file: output 0 is the equilibrium, output
// k, at "time" k, the shape of mode k. Returns the exit code. Throws InputError and SolveError. Collective.
int modes(MPI_Comm comm, const ModesOptions& options);

}  // namespace hawser::run
