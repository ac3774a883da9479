// The command line of hawser: a table of its commands with their options and what they do.
#pragma once

#include <mpi.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "hawser/run/driver.hpp"
#include "hawser/run/modes.hpp"
#include "hawser/run/responses.hpp"
#include "hawser/run/stiffness.hpp"

namespace hawser::run {

// One of `text` and `run` is empty.
struct Command {
  const CLI::App* app = nullptr;
  std::function<std::string()> text{};  // to print; needs neither case nor MPI
  // Exit code. Throws InputError, SolveError and WriteError. Collective.
  std::function<int(MPI_Comm)> run{};
  bool reports_unused_options = false;  // whether unused PETSc options are reported after the command
};

class CommandLine {
 public:
  // petsc_options: as given, for the record of what runs.
  explicit CommandLine(const std::string& petsc_options);
  CommandLine(const CommandLine&) = delete;

  CLI::App& cli() { return cli_; }
  // The command that was given. Valid after cli() has parsed the command line.
  const Command& command() const;
  bool quiet() const { return run_.quiet || modes_.quiet || stiffness_.quiet || responses_.quiet; }

 private:
  void add_run();
  void add_modes();
  void add_stiffness();
  void add_responses();
  void add_check();
  void add_printed();

  CLI::App cli_{"hawser: nonlinear statics and dynamics of the lines of the sea, and their contact."};
  std::vector<Command> commands_;  // but those of post.hpp
  RunOptions run_;
  ModesOptions modes_;
  bool in_vacuum_ = false;
  StiffnessOptions stiffness_;
  std::vector<std::string> point_, offsets_;  // numbers with commas between
  double direction_ = 0;                      // deg
  ResponsesOptions responses_;
  std::vector<std::string> periods_, directions_;  // numbers with commas between
  CheckOptions check_;
  bool quick_ = false, json_ = false, markdown_ = false;
};

}  // namespace hawser::run
