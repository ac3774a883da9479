// The commands `hawser run` and `hawser check`.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace hawser::run {

struct RunOptions {
  std::string case_path;
  std::string output;                // results file that replaces the case's
  std::string restart;               // results file whose newest checkpoint is continued
  std::string options_text;          // PETSc options, for the record
  std::vector<std::string> changes;  // changes of the case, KEY=VALUE each (io/case_changes.hpp)
  double stop_at = 0;                // s, end of the run before the case's; 0: the case's duration
  bool quiet = false;
};

// Runs a case and returns the exit code. Throws InputError and SolveError. Collective.
int run(MPI_Comm comm, const RunOptions& options);

// Reads and checks a case and prints its summary with the partition for `ranks` (0: those of comm). trial:
// also runs its beginning for some seconds, without output, for the expected cost or the reason of a failure.
// verbose: prints minor choices as well.
int check_case(MPI_Comm comm, const std::string& case_path, int ranks, bool trial = true,
               const std::vector<std::string>& changes = {}, bool verbose = false);

// Prints only the case as read (io/case_json.hpp). Throws InputError. Collective.
int print_case(MPI_Comm comm, const std::string& case_path, const std::vector<std::string>& changes);

}  // namespace hawser::run
