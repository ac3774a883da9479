// Command line of hawser.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <petsclog.h>
#include <petscsys.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/base/gather.hpp"
#include "hawser/base/singleton.hpp"
#include "hawser/io/line_library.hpp"
#include "hawser/io/write_error.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/run/driver.hpp"
#include "hawser/run/modes.hpp"
#include "hawser/run/post.hpp"
#include "hawser/run/radiation.hpp"
#include "hawser/run/stiffness.hpp"
#include "hawser/run/usage.hpp"
#include "hawser/run/version.hpp"

namespace {

using hawser::run::RunOptions;

// MPI and PETSc for the life of the program; PETSc returns error codes without tracebacks.
struct Petsc {
  int rank = 0;
  Petsc(int argc, char** argv) {
    hawser::start_singleton();
    PetscInitialize(&argc, &argv, nullptr, nullptr);
    PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
    PetscPopSignalHandler();
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  }
  // Ranks wait for each other before they end: mpirun kills the rest when one ends with an error, and rank 0
  // may have messages left.
  ~Petsc() {
    // Removes an unused stage that -log_view would show as "Unknown".
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
  } catch (const std::exception& e) {
    // An internal error, perhaps only on this rank; the others must not wait for it.
    std::fputs(fmt::format("hawser: internal error on rank {}: {}\n", petsc.rank, e.what()).c_str(), stderr);
    const int size = hawser::ranks_of(PETSC_COMM_WORLD);
    if (size > 1) MPI_Abort(PETSC_COMM_WORLD, 1);
    return 1;
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

// Three or six comma-separated numbers; missing ones are 0. Throws InputError for other text.
hawser::run::Offset numbers_of(const char* option, const std::string& text, size_t most) {
  hawser::run::Offset out{};
  size_t n = 0;
  const char* at = text.c_str();
  for (bool more = true; more && n < most; ++n) {
    char* end = nullptr;
    out[n] = std::strtod(at, &end);
    if (end == at || !std::isfinite(out[n])) break;
    more = *end == ',';
    at = more ? end + 1 : end;
  }
  if (*at || (n != 3 && n != 6))
    throw hawser::InputError(fmt::format("{} {}: give {} with commas between", option,
                                         hawser::model::quote(text),
                                         most == 3 ? "three numbers" : "three or six numbers"));
  return out;
}

void read_places(const std::vector<std::string>& point, const std::vector<std::string>& offsets,
                 double direction, hawser::run::StiffnessOptions& to) {
  constexpr double kDegree = M_PI / 180;
  if (!point.empty()) to.at = hawser::Vec3(numbers_of("--at", point.front(), 3).data());
  for (const std::string& text : offsets) {
    hawser::run::Offset offset = numbers_of("--offset", text, 6);
    for (size_t k = 3; k < 6; ++k) offset[k] *= kDegree;
    to.offsets.push_back(offset);
  }
  to.direction = direction * kDegree;
}

// Commands, options and arguments of the command line.
struct CommandLine {
  CLI::App cli{"hawser: nonlinear statics and dynamics of the lines of the sea, and their contact."};
  CLI::App *run_command = nullptr, *modes_command = nullptr, *stiffness_command = nullptr,
           *schema_command = nullptr, *library_command = nullptr;
  RunOptions run;
  hawser::run::ModesOptions modes;
  hawser::run::StiffnessOptions stiffness;
  std::vector<std::string> point, offsets;  // comma-separated numbers
  double direction = 0;                     // deg
  std::vector<std::string> changes;
  bool in_vacuum = false;
  std::string check_path, radiation;
  int ranks = 0;
  bool quick = false, verbose = false, json = false, markdown = false;

  CommandLine();
  CommandLine(const CommandLine&) = delete;
};

CommandLine::CommandLine() {
  cli.set_version_flag("--version", std::string("hawser ") + hawser::run::kVersion);
  cli.require_subcommand(1);
  cli.footer(
      "Run on several ranks with: mpirun -n 4 hawser run case.yaml\n"
      "Exit codes: 0 done, 2 the input is wrong, 3 the solver failed, 4 the run has ended but its energy "
      "does not add up, 130 stopped by a signal, 1 anything else.");

  run_command = cli.add_subcommand("run", "Run a case: statics, then dynamics; results go to an HDF5 file.");
  run_command->add_option("case", run.case_path, "Case file (YAML; `hawser schema` prints its keys)")
      ->required();
  run_command->add_option("-o,--output", run.output, "Results file instead of the one the case names (.h5)");
  run_command->add_option("--restart", run.restart,
                          "Go on from the newest checkpoint of this results file; when it is the case's own "
                          "results file, the run is continued in it");
  run_command
      ->add_option("--stop-at", run.stop_at, "End at this simulated time, s, if the case would go on longer")
      ->check(hawser::run::positive("time above 0, in s"));
  run_command->add_flag("-q,--quiet", run.quiet, "Say nothing but errors");
  const auto add_set = [&](CLI::App* command) {
    command
        ->add_option("--set", changes,
                     "Change a key of the case: lines.riser.sections[0].length=120; repeatable")
        ->option_text("KEY=VALUE")
        ->allow_extra_args(false);
  };
  add_set(run_command);
  run_command->footer(
      "PETSc options follow a lone --, with the prefixes statics_ and dynamics_:\n"
      "  hawser run case.yaml -- -dynamics_snes_monitor -log_view\n"
      "While it runs, results up to the last output can be opened in ParaView; Ctrl-C ends it cleanly.");

  modes_command = cli.add_subcommand(
      "modes", "Natural frequencies and shapes about the static equilibrium, as outputs of a results file.");
  modes_command->add_option("case", modes.case_path, "Case file")->required();
  modes_command->add_option("-n,--number", modes.count, "How many, from the lowest frequency on")
      ->check(hawser::run::whole_number(1, 10000))
      ->capture_default_str();
  modes_command->add_option("-o,--output", modes.output, "Results file (default: <case>-modes.h5)");
  modes_command->add_flag("--without-added-mass", in_vacuum, "Without the added mass of the water");
  modes_command->add_flag("-q,--quiet", modes.quiet, "Say nothing but errors");
  add_set(modes_command);

  stiffness_command = cli.add_subcommand(
      "stiffness",
      "Stiffness of the lines on a body at rest; force and tension over offsets, as a CSV file.");
  stiffness_command->add_option("case", stiffness.case_path, "Case file")->required();
  stiffness_command->add_option("--body", stiffness.body, "Of several bodies that lines are tied to");
  stiffness_command
      ->add_option("--at", point, "Point of the body that all is about, m, its frame (default 0,0,0)")
      ->option_text("X,Y,Z")
      ->expected(1);
  stiffness_command
      ->add_option("--offset", offsets,
                   "Also away from rest by this, m, and rotation vector, deg, axes of space; repeatable")
      ->option_text("X,Y,Z[,RX,RY,RZ]")
      ->allow_extra_args(false);
  CLI::Option* to =
      stiffness_command->add_option("--to", stiffness.to, "Also in steps up to an offset of this, m")
          ->check(hawser::run::positive("offset above 0, in m"));
  stiffness_command->add_option("--direction", direction, "Of --to, deg, anticlockwise from +x")
      ->needs(to)
      ->capture_default_str();
  stiffness_command->add_option("--steps", stiffness.steps, "Of --to")
      ->needs(to)
      ->check(hawser::run::whole_number(1, 10000))
      ->capture_default_str();
  stiffness_command->add_option("-o,--output", stiffness.output, "CSV file (default: <case>-stiffness.csv)");
  stiffness_command->add_flag("-q,--quiet", stiffness.quiet, "Say nothing but errors");
  add_set(stiffness_command);

  CLI::App* check_command =
      cli.add_subcommand("check", "Read and check a case, print what is in it, try how its run begins.");
  check_command->add_option("case", check_path, "Case file")->required();
  check_command
      ->add_option("-n,--ranks", ranks, "Show the partition for this many ranks; else for those it runs on")
      ->check(hawser::run::whole_number(1, 1 << 20));
  check_command->add_flag("--quick", quick, "Without the trial run that tells the cost");
  check_command->add_flag("--json", json,
                          "Print the case as it was read, with all defaults, as JSON, and nothing else");
  check_command->add_flag("--verbose", verbose, "Also print what was chosen that rarely matters");
  check_command
      ->add_option("--radiation", radiation,
                   "Also write K(t), A, B and Ogilvie's check of floating bodies to this CSV file")
      ->excludes("--json");
  add_set(check_command);

  schema_command = cli.add_subcommand("schema", "Print the schema of case files.");
  schema_command->add_flag("--json", json, "As JSON Schema, for editors");
  schema_command->add_flag("--markdown", markdown, "As the key tables of the user guide (default)");

  library_command = cli.add_subcommand("library", "Print the line types library, as in the user guide.");
  for (const auto& command : hawser::run::kPostCommands) cli.add_subcommand(command.name, command.what);
}

}  // namespace

int main(int argc, char** argv) {
  // A file above the shell's limit (ulimit -f) becomes a write error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  if (argc > 1 && hawser::run::is_post_command(argv[1])) return hawser::run::post(argv + 1);
  // Arguments after a lone "--" are for PETSc.
  std::vector<char*> mine, for_petsc{argv[0]};
  std::string options;
  bool after = false;
  for (int i = 0; i < argc; ++i) {
    if (!after && std::string(argv[i]) == "--") {
      after = true;
      continue;
    }
    (after ? for_petsc : mine).push_back(argv[i]);
    if (after) options += (options.empty() ? "" : " ") + std::string(argv[i]);
  }
  mine.push_back(nullptr);
  for_petsc.push_back(nullptr);

  CommandLine line;
  line.cli.failure_message([&](const CLI::App*, const CLI::Error& e) {
    return hawser::run::usage_error(line.cli, e, {mine.begin() + 1, mine.end() - 1});
  });

  // Requests answered by the parser need no MPI, but only one of several ranks answers.
  std::optional<Petsc> petsc;
  const auto begin = [&] { petsc.emplace(static_cast<int>(for_petsc.size()) - 1, for_petsc.data()); };
  if (hawser::launched()) begin();
  const bool prints = !petsc || petsc->rank == 0;
  try {
    line.cli.parse(static_cast<int>(mine.size()) - 1, mine.data());
  } catch (const CLI::ParseError& e) {
    std::ostringstream out, wrong;
    const bool failed = line.cli.exit(e, out, wrong) != 0;
    if (prints) {
      std::fputs(out.str().c_str(), stdout);
      std::fputs(wrong.str().c_str(), stderr);
    }
    return failed ? hawser::kExitInput : 0;
  }
  if (*line.schema_command) {
    if (prints)
      std::fputs((line.json ? hawser::model::schema_json() : hawser::model::schema_markdown()).c_str(),
                 stdout);
    return 0;
  }
  if (*line.library_command) {
    if (prints) std::fputs(hawser::io::line_library_markdown().c_str(), stdout);
    return 0;
  }
  line.run.options_text = line.modes.options_text = options;
  line.run.changes = line.modes.changes = line.stiffness.changes = line.changes;
  line.modes.added_mass = !line.in_vacuum;
  if (!petsc) begin();
  return guarded(*petsc, [&] {
    if (*line.stiffness_command) {
      read_places(line.point, line.offsets, line.direction, line.stiffness);
      return hawser::run::stiffness(PETSC_COMM_WORLD, line.stiffness);
    }
    if (!line.radiation.empty())
      hawser::run::write_radiation(PETSC_COMM_WORLD, line.check_path, line.changes, line.radiation);
    if (!*line.run_command && !*line.modes_command)
      return line.json ? hawser::run::print_case(PETSC_COMM_WORLD, line.check_path, line.changes)
                       : hawser::run::check_case(PETSC_COMM_WORLD, line.check_path, line.ranks, !line.quick,
                                                 line.changes, line.verbose);
    const int code = *line.run_command ? hawser::run::run(PETSC_COMM_WORLD, line.run)
                                       : hawser::run::modes(PETSC_COMM_WORLD, line.modes);
    const auto left = unused(for_petsc);
    if (prints && !line.run.quiet && !line.modes.quiet && !left.empty())
      fmt::print("\nwarning: nothing in this run has used the PETSc option{} {}\n",
                 left.size() > 1 ? "s" : "", fmt::join(left, ", "));
    return code;
  });
}
