// What `hawser run` and `hawser check` do with a case file.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace hawser::run {

struct RunOptions {
  std::string case_path;
  std::string output;                // results file instead of the case's
  std::string restart;               // results file whose newest checkpoint to go on from
  std::string options_text;          // PETSc options, for the record
  std::vector<std::string> changes;  // of the case, KEY=VALUE each (io/case_changes.hpp)
  double stop_at = 0;                // s, end the run early; 0: the case's duration
  bool quiet = false;
};

// Exit code. Throws InputError and SolveError. Collective.
int run(MPI_Comm comm, const RunOptions& options);

// Reads and checks, prints the summary with the partition for `ranks` (0: those of comm). trial: and runs the
// beginning of the case for some seconds, writing nothing, for the expected cost or the reason why it stops.
// verbose: also what was chosen that rarely matters.
int check_case(MPI_Comm comm, const std::string& case_path, int ranks, bool trial = true,
               const std::vector<std::string>& changes = {}, bool verbose = false);

// Prints a case as it was read (io/case_json.hpp), and nothing else. Throws InputError. Collective.
int print_case(MPI_Comm comm, const std::string& case_path, const std::vector<std::string>& changes);

}  // namespace hawser::run
