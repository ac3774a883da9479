// Dynamic relaxation: slack and floating lines come to rest by a damped motion in a pseudo-time.
//
// Every node has the same fictitious mass, and the motion restarts from rest whenever its kinetic energy has
// passed a peak ("kinetic damping": Cundall 1976; Barnes 1999, Int. J. Space Structures 14). Steps are
// implicit (backward Euler, solved by Newton's method with the exact tangent), so the axial stiffness does
// not limit them. They become longer while Newton's method needs few iterations, and approach the Newton
// steps of statics. See docs/theory/relaxation.md.
#pragma once

#include <functional>
#include <optional>

#include "hawser/advice/step_findings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

struct RelaxationReport {
  int steps = 0;       // accepted steps
  int rejected = 0;    // steps tried again with a larger mass
  int iterations = 0;  // Newton iterations
  ResidualNorms norms;
  // Largest residual of lines that no longer move although it is above the tolerance; with friction only.
  std::optional<advice::Imbalance> remaining;
};

// The motion has not come to rest within the steps allowed. Further starts would use as many again, so that
// the search without friction ends.
struct RelaxationStepsUsed : SolveError {
  using SolveError::SolveError;
};

struct RelaxationSettings {
  double tolerance = 1e-4;  // of the residual, relative to its contributions
  int max_steps = model::Statics().relaxation_steps;
  // > 0: first displaces the start shape asymmetrically by this many hundredths of its length
  int pushed = 0;
  // Friction acts against the path of the lines. Therefore no momentum is carried from step to step, as in a
  // viscous fluid, and the terms are committed after each step.
  bool friction = false;
  std::function<void(const RelaxationReport&)> progress;  // called before every step, on all ranks
};

// Moves `state` (positions and rotations) near an equilibrium at state.time, from which Newton's iteration
// can complete the search. Terms are evaluated as in statics, and committed only with `friction`, with which
// a small residual may remain. Collective. Throws SolveError naming line, arc length and imbalance if the
// motion does not come to rest, among them RelaxationStepsUsed unless a body slides or falls without end, and
// StiffnessRaised (static_trial.hpp) if contact was too soft during the search.
RelaxationReport relax(System& system, const RelaxationSettings& settings, State& state);

}  // namespace hawser
