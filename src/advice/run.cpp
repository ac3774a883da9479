// Messages about a run.
#include "hawser/advice/run.hpp"

#include <fmt/format.h>

#include "hawser/base/count_of.hpp"

namespace hawser::advice {
namespace {

std::string after_relaxation(int steps) {
  return steps > 0 ? ", " + count_of(steps, "step") + " of dynamic relaxation" : "";
}

}  // namespace

std::string restart_needs_dynamics(const model::Case& c) {
  return c.path +
         ": dynamics: required key is missing: only a run with 'dynamics' can continue from a checkpoint";
}

std::string model_size(size_t nodes, int ranks, int cut_elements) {
  const std::string size = count_of(static_cast<long long>(nodes), "node") + " on " + count_of(ranks, "rank");
  return ranks == 1 ? size : size + ", " + count_of(cut_elements, "cut element");
}

std::string one_rank_has_all() {
  return "one rank has all nodes, since a line that may touch itself is not divided among ranks: more ranks "
         "do not make the run faster; set 'contact: {between_lines: {self: false}}' to allow division";
}

std::string continuing_from(const std::string& file, double time) {
  return fmt::format("continuing from t = {:.6g} s of {}", time, file);
}

std::string ends_before_checkpoint(double time, double end) {
  return fmt::format(
      "its checkpoint is at t = {:.6g} s and the run ends at {:.6g} s, by 'dynamics.duration' or --stop-at: "
      "nothing is left to compute",
      time, end);
}

std::string nothing_left() { return "the checkpoint is at the end of the case; nothing is left to compute"; }

std::string stage_of_statics(const std::string& stage) { return fmt::format("stage {} of statics", stage); }

std::string statics_progress(int iterations, int relaxation_steps, double imbalance) {
  return fmt::format("statics: {}{}, relative residual {:.1e}", count_of(iterations, "iteration"),
                     after_relaxation(relaxation_steps), imbalance);
}

std::string statics_done(int iterations, int relaxation_steps, bool without_friction) {
  return fmt::format("statics: {}{}{}", count_of(iterations, "iteration"), after_relaxation(relaxation_steps),
                     without_friction ? ", without friction of contact" : "");
}

std::string length_trial(int trial, const std::string& value) {
  return fmt::format("statics {} of the search for lengths: {}", trial, value);
}

std::string preparing_mesh(const std::string& file) { return fmt::format("preparing the mesh {}", file); }

std::string energy_of_run(const EnergyOfRun& e) {
  return fmt::format(
      "energy: input {:.6g} J: kinetic {:.6g}, strain {:.6g}, friction {:.6g}, damping {:.6g}, unresolved "
      "{:.3g} J; balance error {:.3g} J ({:.3g} % of the work done, {:.3g} J)",
      e.brought_in, e.kinetic, e.strain, e.friction, e.damping, e.unresolved, e.error, e.percent, e.size);
}

std::string stopped_by_signal(double time, double end, const std::string& results) {
  return fmt::format(
      "stopped by a signal at t = {:.6g} of {:.6g} s: the histories end at that time; --restart {} continues",
      time, end, results);
}

std::string petsc_option_is_fixed(const std::string& option, const std::string& value) {
  return fmt::format("the option -dynamics_{} can only be '{}'", option, value);
}

std::string lengths_not_found_in_trial(double spent) {
  return fmt::format(
      "note: in {:g} CPU s the search has not found line lengths that meet the targets of the case; the "
      "check ends here and does not check the start shapes; a run continues the search, faster from lengths "
      "near the solution",
      spent);
}

std::string case_is_valid(bool starts_outside) {
  if (starts_outside) return "the case is valid";
  return "the case is valid if statics moves the lines out of the volumes in which they start; otherwise the "
         "run stops";
}

}  // namespace hawser::advice
