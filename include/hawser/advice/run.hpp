// Messages about a run: start, progress and end; and the result of `hawser check`.
#pragma once

#include <cstddef>
#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Restart of a case without dynamics.
std::string restart_needs_dynamics(const model::Case& c);
std::string model_size(size_t nodes, int ranks, int cut_elements);
// One of several ranks has all nodes, because whole lines are not cut.
std::string one_rank_has_all();
std::string continuing_from(const std::string& file, double time);  // s
// The run would end at `end`, at or before the checkpoint at `time`; both s.
std::string ends_before_checkpoint(double time, double end);
std::string nothing_left();

std::string stage_of_statics(const std::string& stage);
// relaxation_steps: 0 if not used. imbalance: residual relative to the applied forces.
std::string statics_progress(int iterations, int relaxation_steps, double imbalance);
std::string statics_done(int iterations, int relaxation_steps, bool without_friction);
// value: text from length_tried().
std::string length_trial(int trial, const std::string& value);
std::string preparing_mesh(const std::string& file);

// Energies [J], changes since the start; `percent`: of `error`, the unexplained energy, relative to `size`,
// the work done.
struct EnergyOfRun {
  double brought_in = 0, kinetic = 0, strain = 0, friction = 0, damping = 0, unresolved = 0;
  double error = 0, percent = 0, size = 0;
};
std::string energy_of_run(const EnergyOfRun& e);
std::string stopped_by_signal(double time, double end, const std::string& results);  // s

// For a PETSc option (-dynamics_<option>) that the time integration fixes.
std::string petsc_option_is_fixed(const std::string& option, const std::string& value);

// For `hawser check`. spent: CPU s of its trial.
std::string lengths_not_found_in_trial(double spent);
std::string case_is_valid(bool starts_outside);

}  // namespace hawser::advice
