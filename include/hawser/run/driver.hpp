// The commands `hawser run` and `hawser check`.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace hawser::run {

struct RunOptions {
  std::string case_path{};
  std::string output;                // results file that replaces the case's
  std::string restart;               // results file whose newest checkpoint is continued
  std::string options_text;          // PETSc options, for the record
  std::vector<std::string> changes;  // changes of the case, KEY=VALUE each (io/case_changes.hpp)
  double stop_at = 0;                // s, end of the run before the case's; 0: the case's duration
  bool quiet = false;
};

// Runs a case and returns the exit code. Throws InputError and SolveError. Collective.
int run(MPI_Comm comm, const RunOptions& options);

struct CheckOptions {
  std::string case_path{};
  int ranks = 0;                       // of the partition that is printed; 0: those of the communicator
  bool trial = true;                   // trial run of the start of the case for some seconds
  std::vector<std::string> changes{};  // of the case, KEY=VALUE each
  bool verbose = false;                // also print choices of minor importance
  std::string radiation{};             // CSV file for the table of write_radiation(); empty: none
};

// Reads and checks, prints the summary with the partition. The trial writes nothing; it is for the expected
// cost or the reason why the case stops. Exit code. Throws InputError, SolveError and WriteError. Collective.
int check_case(MPI_Comm comm, const CheckOptions& options);

// Prints only the case as read (io/case_json.hpp). Throws InputError. Collective.
int print_case(MPI_Comm comm, const std::string& case_path, const std::vector<std::string>& changes);

}  // namespace hawser::run
