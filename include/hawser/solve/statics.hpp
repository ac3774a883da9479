// Static equilibrium from a start shape that may be far from it.
//
// Newton on the potential energy with a Levenberg shift and an energy line search: far away the tangent drops
// compression (so it is positive and the step goes downhill), near the solution it is exact and the last
// iterations are quadratic. The configuration is re-based every iteration, so rotations of any size are met
// by small increments. At the end the inertia of the tangent tells a stable equilibrium from a false one
// (a straight line of compressed elements, say), which is left and the search goes on.
#pragma once

#include <functional>

#include "hawser/solve/linear_solver.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// Whether lines come to rest by dynamic relaxation (relaxation.hpp) before Newton's iteration. `first`:
// unless it fails. Newton's descent of a line that falls takes a way that rounding chooses, the damped fall
// does not.
enum class RelaxationUse { when_newton_fails, first, always, never };

struct StaticsReport {
  int iterations = 0;
  int relaxation_steps = 0;      // of dynamic relaxation before; their iterations are counted too
  int escapes = 0;               // false equilibria left
  int negative_eigenvalues = 0;  // of the final tangent; -1: not known
  ResidualNorms norms;
};

struct StaticsSettings {
  double tolerance = 1e-8;  // of the residual, against the size of its contributions
  int max_iterations = 500;
  bool near = false;  // `state` is near an equilibrium: no start with a soft line
  RelaxationUse relaxation = RelaxationUse::when_newton_fails;  // not with `near`
  int relaxation_steps = 5000;                                  // at most
  // Friction of contact acts on the way: by relaxation alone, which commits the terms step by step.
  bool friction = false;
  // Called with the state of the search before every iteration or step of relaxation; on all ranks.
  std::function<void(const StaticsReport&)> progress;
};

// Moves `state` (positions and rotations; rates are zeroed) to equilibrium at state.time and commits the
// terms there. Throws SolveError naming line, arc length and what is out of balance.
StaticsReport solve_statics(System& system, const StaticsSettings& settings, State& state);

}  // namespace hawser
