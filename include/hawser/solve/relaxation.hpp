// Dynamic relaxation: slack and floating lines come to rest by a damped motion in a pseudo-time.
//
// Every node has the same fictitious mass, and the motion starts anew from rest whenever its kinetic energy
// has passed a peak ("kinetic damping": Cundall 1976; Barnes 1999, Int. J. Space Structures 14). Steps are
// implicit (backward Euler, solved by Newton with the exact tangent), so the stiffness along a line does not
// limit them; they grow while Newton finds them easy, towards Newton's steps of statics. See
// docs/theory/relaxation.md.
#pragma once

#include <functional>

#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

struct RelaxationReport {
  int steps = 0;       // that were taken
  int rejected = 0;    // that were tried again with more mass
  int iterations = 0;  // of Newton
  ResidualNorms norms;
};

struct RelaxationSettings {
  double tolerance = 1e-4;  // of the residual, against the size of its contributions
  int max_steps = 5000;
  int pushed = 0;  // > 0: starts out of the shape's symmetry, by so many hundredths of its length
  // Friction acts against the way of the lines: no motion is carried from step to step, as in a thick fluid,
  // and the terms are committed after each.
  bool friction = false;
  std::function<void(const RelaxationReport&)> progress;  // before every step, on all ranks
};

// Moves `state` (positions and rotations) near an equilibrium at state.time, from where Newton's iteration
// ends it. Terms are asked as in statics; nothing is committed but with `friction`. Collective. Throws
// SolveError naming line, arc length and what is out of balance when it does not come to rest, and
// StiffnessRaised (static_trial.hpp) where contact was too soft on the way.
RelaxationReport relax(System& system, const RelaxationSettings& settings, State& state);

}  // namespace hawser
