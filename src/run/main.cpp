// hawser: PETSc and MPI for the life of the program, the command line, exit codes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <petsclog.h>
#include <petscsys.h>
#include <petscviewer.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/base/singleton.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/run/command_line.hpp"
#include "hawser/run/post.hpp"
#include "hawser/run/usage.hpp"

namespace {

// MPI and PETSc for the life of the program. PETSc's errors come back as codes, not as tracebacks.
struct Petsc {
  int rank = 0;
  Petsc(int argc, char** argv) {
    hawser::start_singleton();
    PetscInitialize(&argc, &argv, nullptr, nullptr);
    // Each Jacobian and each solve looks for options such as -snes_compare_explicit and -ksp_view_mat, about
    // 5 us a step of a small model. Without options there is nothing to find.
    char* options = nullptr;
    if (PetscOptionsGetAll(nullptr, &options) == 0 && std::string(options).empty())
      PetscOptionsPushGetViewerOff(PETSC_TRUE);
    PetscFree(options);
    PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
    PetscPopSignalHandler();
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  }
  // Ranks wait for each other before they end: mpirun kills the others when one ends with an error, and rank
  // 0 may still have messages.
  ~Petsc() {
    // Removes an unused part that -log_view would show as "Unknown".
    PetscStageLog log = nullptr;
    if (PetscLogGetStageLog(&log) == 0)
      for (int s = 0; s < log->numStages; ++s)
        if (!log->stageInfo[s].used) PetscLogStageSetVisible(s, PETSC_FALSE);
    PetscFinalize();
  }
};

// PETSc options that nothing has used, in their given order; some options are used only after the end of the
// run.
std::vector<std::string> unused(const std::vector<char*>& given) {
  PetscInt n = 0;
  char **names = nullptr, **values = nullptr;
  if (PetscOptionsLeftGet(nullptr, &n, &names, &values)) return {};
  std::vector<std::string> out;
  for (const char* word : given)
    for (PetscInt i = 0; word && i < n; ++i)
      if (std::string(word) == std::string("-") + names[i] && std::string(word) != "-options_left" &&
          std::count(out.begin(), out.end(), word) == 0)
        out.push_back(word);
  PetscOptionsLeftRestore(nullptr, &n, &names, &values);
  return out;
}

void print_internal_error(const char* text) {
  std::fputs(
      fmt::format("hawser: internal error on rank {}: {}\n", hawser::rank_of(PETSC_COMM_WORLD), text).c_str(),
      stderr);
}

// On several ranks an exception that guarded() does not catch is an internal error, perhaps of this rank
// alone. The program ends without unwinding: destructors that close files would wait for the other ranks.
[[noreturn]] void abort_all_ranks() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::exception& e) {
    print_internal_error(e.what());
  } catch (...) {
  }
  std::fflush(nullptr);
  MPI_Abort(PETSC_COMM_WORLD, 1);
  std::_Exit(1);
}

int guarded(const Petsc& petsc, const std::function<int()>& work) {
  int code = 1;
  std::string text;
  try {
    return work();
  } catch (const hawser::InputError& e) {
    code = hawser::kExitInput;
    text = e.what();
  } catch (const hawser::SolveError& e) {
    code = hawser::kExitSolve;
    text = e.what();
  } catch (const hawser::io::WriteError& e) {
    code = hawser::kExitWrite;
    text = e.what();
  }
  if (petsc.rank == 0) std::fputs(fmt::format("hawser: {}\n", text).c_str(), stderr);
  if (code == hawser::kExitWrite) {
    // All ranks are here. At the end of MPI, HDF5 would retry the writes that a full disk refused, and crash.
    std::fflush(nullptr);
    MPI_Barrier(PETSC_COMM_WORLD);
    std::_Exit(code);
  }
  return code;
}

// The words of the command line; words after a single "--" are for PETSc.
struct Words {
  std::vector<char*> program, petsc;  // each with the program's name first and a null pointer last
  std::string petsc_text;
};

Words split(int argc, char** argv) {
  Words out{{}, {argv[0]}, {}};
  bool after = false;
  for (int i = 0; i < argc; ++i) {
    if (!after && std::string(argv[i]) == "--") {
      after = true;
      continue;
    }
    (after ? out.petsc : out.program).push_back(argv[i]);
    if (after) out.petsc_text += (out.petsc_text.empty() ? "" : " ") + std::string(argv[i]);
  }
  out.program.push_back(nullptr);
  out.petsc.push_back(nullptr);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  // A file above the shell's limit (ulimit -f) becomes a write error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  if (argc > 1 && hawser::run::is_post_command(argv[1])) return hawser::run::post(argv + 1);
  Words words = split(argc, argv);
  hawser::run::CommandLine line(words.petsc_text);
  line.cli().failure_message([&](const CLI::App*, const CLI::Error& e) {
    return hawser::run::usage_error(line.cli(), e, {words.program.begin() + 1, words.program.end() - 1});
  });

  // Requests answered by the parser need no MPI, but only one of several ranks answers.
  std::optional<Petsc> petsc;
  const auto begin = [&] { petsc.emplace(static_cast<int>(words.petsc.size()) - 1, words.petsc.data()); };
  if (hawser::launched()) begin();
  const bool prints = !petsc || petsc->rank == 0;
  try {
    line.cli().parse(static_cast<int>(words.program.size()) - 1, words.program.data());
  } catch (const CLI::ParseError& e) {
    std::ostringstream out, wrong;
    const bool failed = line.cli().exit(e, out, wrong) != 0;
    if (prints) {
      std::fputs(out.str().c_str(), stdout);
      std::fputs(wrong.str().c_str(), stderr);
    }
    return failed ? hawser::kExitInput : 0;
  }
  const hawser::run::Command& command = line.command();
  if (command.text) {
    if (prints) std::fputs(command.text().c_str(), stdout);
    return 0;
  }
  if (!petsc) begin();
  const auto work = [&] {
    const int code = command.run(PETSC_COMM_WORLD);
    if (!command.reports_unused_options) return code;
    const auto unused_options = unused(words.petsc);
    if (prints && !line.quiet() && !unused_options.empty())
      fmt::print("\nwarning: this run did not use the PETSc option{} {}\n",
                 unused_options.size() > 1 ? "s" : "", fmt::join(unused_options, ", "));
    return code;
  };
  if (hawser::ranks_of(PETSC_COMM_WORLD) > 1) {
    std::set_terminate(abort_all_ranks);
    return guarded(*petsc, work);
  }
  try {
    return guarded(*petsc, work);
  } catch (const std::exception& e) {
    print_internal_error(e.what());
    return 1;
  }
}
