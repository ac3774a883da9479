// Commands, their options, and what each of them calls.
#include "hawser/run/command_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "hawser/base/error.hpp"
#include "hawser/io/line_library.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/run/post.hpp"
#include "hawser/run/usage.hpp"
#include "hawser/run/version.hpp"

namespace hawser::run {
namespace {

// Three or six numbers separated by commas; missing ones are 0. InputError for anything else.
Offset numbers_of(const char* option, const std::string& text, size_t max_count) {
  Offset out{};
  size_t n = 0;
  const char* at = text.c_str();
  for (bool more = true; more && n < max_count; ++n) {
    char* end = nullptr;
    out[n] = std::strtod(at, &end);
    if (end == at || !std::isfinite(out[n])) break;
    more = *end == ',';
    at = more ? end + 1 : end;
  }
  if (*at || (n != 3 && n != 6))
    throw InputError(fmt::format("{} {}: give {} separated by commas", option, model::quote(text),
                                 max_count == 3 ? "three numbers" : "three or six numbers"));
  return out;
}

// Numbers separated by commas; InputError for anything else.
std::vector<double> list_of(const char* option, const std::string& text) {
  std::vector<double> out;
  const char* at = text.c_str();
  for (bool more = true; more;) {
    char* end = nullptr;
    out.push_back(std::strtod(at, &end));
    more = *end == ',';
    if (end == at || !std::isfinite(out.back()) || (*end && !more))
      throw InputError(fmt::format("{} {}: give numbers separated by commas", option, model::quote(text)));
    at = end + 1;
  }
  return out;
}

// Each argument has the text of an option, or nothing if it was not given.
void read_waves(const std::vector<std::string>& periods, const std::vector<std::string>& directions,
                const std::vector<std::string>& point, ResponsesOptions& to) {
  if (!point.empty()) to.at = Vec3(numbers_of("--at", point.front(), 3).data());
  for (const std::string& text : periods) to.periods = list_of("--periods", text);
  for (const double period : to.periods)
    if (!(period > 0)) throw InputError(fmt::format("--periods {:g}: give periods above 0, in s", period));
  for (const std::string& text : directions) to.directions = list_of("--directions", text);
  for (double& direction : to.directions) {
    if (std::abs(direction) > 360)
      throw InputError(fmt::format("--directions {:g}: give directions from -360 to 360, in deg", direction));
    direction *= kDegree;
  }
}

void read_places(const std::vector<std::string>& point, const std::vector<std::string>& offsets,
                 double direction, StiffnessOptions& to) {
  if (!point.empty()) to.at = Vec3(numbers_of("--at", point.front(), 3).data());
  for (const std::string& text : offsets) {
    Offset offset = numbers_of("--offset", text, 6);
    for (size_t k = 3; k < 6; ++k) offset[k] *= kDegree;
    to.offsets.push_back(offset);
  }
  to.direction = direction * kDegree;
}

void add_changes(CLI::App* command, std::vector<std::string>& to) {
  command->add_option("--set", to, "Change a key of the case: lines.riser.sections[0].length=120; repeatable")
      ->option_text("KEY=VALUE")
      ->allow_extra_args(false);
}

}  // namespace

CommandLine::CommandLine(const std::string& petsc_options) {
  run_.options_text = modes_.options_text = petsc_options;
  cli_.set_version_flag("--version", std::string("hawser ") + kVersion);
  cli_.require_subcommand(1);
  cli_.footer(
      "Run on several ranks with: mpirun -n 4 hawser run case.yaml\n"
      "Exit codes: 0 done, 2 input error, 3 the solver failed, 4 the run has ended but its energy "
      "balance is not closed, 130 stopped by a signal, 1 any other error.");

  add_run();
  add_modes();
  add_stiffness();
  add_responses();
  add_check();
  add_printed();
  for (const auto& command : kPostCommands) cli_.add_subcommand(command.name, command.help);
}

const Command& CommandLine::command() const {
  for (const Command& c : commands_)
    if (c.app->parsed()) return c;
  throw std::logic_error("the command line has no command");
}

void CommandLine::add_run() {
  CLI::App* command =
      cli_.add_subcommand("run", "Run a case: statics, then dynamics; results go to an HDF5 file.");
  command->add_option("case", run_.case_path, "Case file (YAML; `hawser schema` prints its keys)")
      ->required();
  command->add_option("-o,--output", run_.output,
                      "Results file (.h5), in place of the one named in the case");
  command->add_option("--restart", run_.restart,
                      "Continue from the newest checkpoint of this results file; if it is the case's own "
                      "results file, the run is appended to it");
  command
      ->add_option("--stop-at", run_.stop_at,
                   "End at this simulated time, s, if it is before the end of the case")
      ->check(positive("time above 0, in s"));
  command->add_flag("-q,--quiet", run_.quiet, "Print errors only");
  add_changes(command, run_.changes);
  command->footer(
      "PETSc options follow a lone --, with the prefixes statics_ and dynamics_:\n"
      "  hawser run case.yaml -- -dynamics_snes_monitor -log_view\n"
      "While it runs, results up to the last output can be opened in ParaView; Ctrl-C ends it cleanly.");
  const auto work = [this](MPI_Comm comm) { return hawser::run::run(comm, run_); };
  commands_.push_back({command, nullptr, work, true});
}

void CommandLine::add_modes() {
  CLI::App* command = cli_.add_subcommand(
      "modes",
      "Natural frequencies and mode shapes about the static equilibrium, as outputs of a results file.");
  command->add_option("case", modes_.case_path, "Case file")->required();
  command->add_option("-n,--number", modes_.count, "Number of modes, from the lowest frequency on")
      ->check(whole_number(1, 10000))
      ->capture_default_str();
  command->add_option("-o,--output", modes_.output, "Results file (default: <case>-modes.h5)");
  command->add_flag("--without-added-mass", in_vacuum_, "Without the added mass of the water");
  command->add_flag("-q,--quiet", modes_.quiet, "Print errors only");
  add_changes(command, modes_.changes);
  const auto work = [this](MPI_Comm comm) {
    modes_.added_mass = !in_vacuum_;
    return modes(comm, modes_);
  };
  commands_.push_back({command, nullptr, work, true});
}

void CommandLine::add_stiffness() {
  CLI::App* command = cli_.add_subcommand(
      "stiffness",
      "Stiffness of the lines at a body in equilibrium; forces and tensions against offsets, as a CSV file.");
  command->add_option("case", stiffness_.case_path, "Case file")->required();
  command->add_option("--body", stiffness_.body, "Body to use, if lines are attached to several");
  command
      ->add_option(
          "--at", point_,
          "Point of the body to which force, moment and stiffness refer, m, in its frame (default 0,0,0)")
      ->option_text("X,Y,Z")
      ->expected(1);
  command
      ->add_option(
          "--offset", offsets_,
          "Additional offset from rest, m, and rotation vector, deg, in axes fixed in space; repeatable")
      ->option_text("X,Y,Z[,RX,RY,RZ]")
      ->allow_extra_args(false);
  CLI::Option* to =
      command->add_option("--to", stiffness_.to, "Additional offsets in equal steps up to this one, m")
          ->check(positive("offset above 0, in m"));
  command->add_option("--direction", direction_, "Direction of --to, deg, anticlockwise from +x")
      ->needs(to)
      ->capture_default_str();
  command->add_option("--steps", stiffness_.steps, "Number of steps up to --to")
      ->needs(to)
      ->check(whole_number(1, 10000))
      ->capture_default_str();
  command->add_option("-o,--output", stiffness_.output, "CSV file (default: <case>-stiffness.csv)");
  command->add_flag("-q,--quiet", stiffness_.quiet, "Print errors only");
  add_changes(command, stiffness_.changes);
  const auto work = [this](MPI_Comm comm) {
    read_places(point_, offsets_, direction_, stiffness_);
    return stiffness(comm, stiffness_);
  };
  commands_.push_back({command, nullptr, work});
}

void CommandLine::add_responses() {
  CLI::App* command = cli_.add_subcommand(
      "responses",
      "Responses of moored floating bodies to waves in the frequency domain, about the static equilibrium.");
  command->add_option("case", responses_.case_path, "Case file")->required();
  command
      ->add_option("--periods", periods_, "Wave periods, s (default: those of the wave forces in the files)")
      ->option_text("T1,T2,...")
      ->expected(1);
  command
      ->add_option("--directions", directions_,
                   "Directions in which waves go, deg, anticlockwise from +x (default: those of the files)")
      ->option_text("D1,D2,...")
      ->expected(1);
  command->add_option("--body", responses_.body, "Floating body to report (default: each)");
  command
      ->add_option("--at", point_,
                   "Point of the body whose motion is reported, m, in its frame (default 0,0,0)")
      ->option_text("X,Y,Z")
      ->expected(1);
  command->add_option(
      "-o,--output", responses_.output,
      "CSV file (default: <case>-responses.csv); with several bodies one each, NAME-BODY.csv");
  command->add_flag("-q,--quiet", responses_.quiet, "Print errors only");
  add_changes(command, responses_.changes);
  const auto work = [this](MPI_Comm comm) {
    read_waves(periods_, directions_, point_, responses_);
    return responses(comm, responses_);
  };
  commands_.push_back({command, nullptr, work, true});
}

void CommandLine::add_check() {
  CLI::App* command =
      cli_.add_subcommand("check", "Read and check a case, print a summary, and try its first steps.");
  command->add_option("case", check_.case_path, "Case file")->required();
  command
      ->add_option("-n,--ranks", check_.ranks,
                   "Show the partition for this many ranks (default: the ranks of this command)")
      ->check(whole_number(1, 1 << 20));
  command->add_flag("--quick", quick_, "Skip the trial run that estimates the cost");
  command->add_flag("--json", json_, "Print only the case as read, with all defaults, as JSON");
  command->add_flag("--verbose", check_.verbose, "Also print notes about minor automatic choices");
  command
      ->add_option("--radiation", check_.radiation,
                   "Also write K(t), A, B and Ogilvie's check of floating bodies to this CSV file")
      ->excludes("--json");
  add_changes(command, check_.changes);
  const auto work = [this](MPI_Comm comm) {
    if (json_) return print_case(comm, check_.case_path, check_.changes);
    check_.trial = !quick_;
    return check_case(comm, check_);
  };
  commands_.push_back({command, nullptr, work});
}

// Commands that print a text and need no case.
void CommandLine::add_printed() {
  CLI::App* schema = cli_.add_subcommand("schema", "Print the schema of case files.");
  schema->add_flag("--json", json_, "As JSON Schema, for editors");
  schema->add_flag("--markdown", markdown_, "As the key tables of the user guide (default)");
  commands_.push_back({schema, [this] { return json_ ? model::schema_json() : model::schema_markdown(); }});
  CLI::App* library = cli_.add_subcommand("library", "Print the line types library, as in the user guide.");
  commands_.push_back({library, io::line_library_markdown});
}

}  // namespace hawser::run
