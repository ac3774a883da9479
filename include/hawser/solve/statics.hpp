// Static equilibrium from a start shape that may be far from it.
//
// Newton's method on the potential energy with a Levenberg shift and an energy line search. Far from the
// solution the tangent excludes compression, so that it is positive and the step reduces the energy. Near the
// solution it is exact, and the last iterations converge quadratically. The configuration is re-based in
// every iteration, so that rotations of any size are reached by small increments. At the end the inertia of
// the tangent distinguishes a stable equilibrium from an unstable one (for example a straight line of
// compressed elements). The search leaves an unstable one and continues. docs/theory/statics.md: the order of
// all methods.
#pragma once

#include <functional>
#include <optional>

#include "hawser/advice/step_findings.hpp"
#include "hawser/model/case.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// Use of dynamic relaxation (relaxation.hpp) before Newton's iteration. `first`: relaxation first, Newton's
// descent only if it fails. The path of Newton's descent of a falling line depends on rounding, that of the
// damped fall does not.
enum class RelaxationUse { when_newton_fails, first, always, never };

struct StaticsReport {
  int iterations = 0;
  int relaxation_steps = 0;      // steps of relaxation before; `iterations` includes its iterations
  int escapes = 0;               // number of unstable equilibria that were left
  int negative_eigenvalues = 0;  // of the final tangent; -1: not known
  ResidualNorms norms;
  std::optional<advice::Imbalance> remaining;  // of lines that rest by friction (RelaxationReport)
};

// Initial values are the defaults of the keys of `statics`.
struct StaticsSettings {
  double tolerance = model::Statics().tolerance;  // of the residual, relative to its contributions
  int max_iterations = model::Statics().max_iterations;
  // `state` is near an equilibrium: the search does not begin with soft lines.
  bool starts_near = false;
  RelaxationUse relaxation = RelaxationUse::when_newton_fails;  // with `starts_near` only `never` acts
  int relaxation_steps = model::Statics().relaxation_steps;     // at most
  // Friction of contact acts along the path: relaxation alone is used, and it commits the terms step by step.
  bool friction = false;
  // Called with the state of the search before every iteration or step of relaxation, on all ranks.
  std::function<void(const StaticsReport&)> progress;
};

// State and histories of the terms at the start of a search, to which it can return.
class StaticsStart {
 public:
  StaticsStart(System& system, const State& state);
  void restore(State& state) const;

 private:
  System& system_;
  State state_;
  std::vector<std::vector<CheckpointRecord>> history_;
};

// Moves `state` (positions and rotations; rates are set to zero) to equilibrium at state.time and commits the
// terms there. Throws SolveError naming line, arc length and imbalance.
StaticsReport find_equilibrium(System& system, const StaticsSettings& settings, State& state);

}  // namespace hawser
