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

struct CheckOptions {
  std::string case_path{};
  int ranks = 0;                       // of the partition that is printed; 0: those of the communicator
  bool trial = true;                   // run the beginning of the case for some seconds
  std::vector<std::string> changes{};  // of the case, KEY=VALUE each
  bool verbose = false;                // also print what was chosen that rarely matters
  std::string radiation{};             // CSV file for the table of write_radiation(); empty: none
};

// Reads and checks, prints the summary with the partition. The trial writes nothing; it is for the expected
// cost or the reason why the case stops. Exit code. Throws InputError, SolveError and WriteError. Collective.
int check_case(MPI_Comm comm, const CheckOptions& options);

// Prints a case as it was read (io/case_json.hpp), and nothing else. Throws InputError. Collective.
int print_case(MPI_Comm comm, const std::string& case_path, const std::vector<std::string>& changes);

}  // namespace hawser::run
