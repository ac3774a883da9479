// Generalized-alpha on R³ x SO(3), with equilibrium at the end of the step.
// Arnold & Brüls (2007), "Convergence of the generalized-alpha scheme for constrained mechanical systems",
// Multibody System Dynamics 18; rotations as in Brüls & Cardona (2010), J. Comput. Nonlinear Dynam. 5.
#pragma once

#include <vector>

#include "hawser/base/runs.hpp"
#include "hawser/math/alpha_coefficients.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/assembler.hpp"
#include "hawser/system/tied_nodes.hpp"

namespace hawser {

// A committed state with the algorithmic accelerations of the scheme.
struct AlphaState {
  State s;
  // Algorithmic accelerations, m/s², rad/s² (material), and of the directors, 1/s²; the last two are empty
  // where no node rotates.
  std::vector<Vec3> ax, aw;
  std::vector<Mat3> ad;
};

// True if any node of the whole mesh rotates. If none does, states in time have no directors. The same on all
// ranks.
bool has_directors(const LocalMesh& mesh);

// delta²: the scheme holds the energy delta²/2 h² A.M A in its algorithmic accelerations.
double alpha_stored(const AlphaCoefficients& c);

// Sets the algorithmic accelerations from a state whose accelerations are in equilibrium.
void alpha_start(const LocalMesh& mesh, AlphaState& state);

// Trial state at the end of a step h from `from`, for an increment u (3 * local blocks, ghosts included).
// Configurations come from the retraction, velocities and accelerations from the scheme, and prescribed
// components from the motion that they are tied to. It also sets StepMean. The accelerations of the directors
// are those for which the scheme's formulas reproduce the rates R hat(w) exactly.
void alpha_trial(const LocalMesh& mesh, const TiedNodes& tied, const AlphaCoefficients& c, double h,
                 const AlphaState& from, const std::vector<double>& u, AlphaState& trial);

// Increment for an unchanged algorithmic acceleration.
void alpha_predict(const LocalMesh& mesh, const TiedNodes& tied, double h, const AlphaState& from,
                   std::vector<double>& u);

// State of the forces that enter as their mean S over a step (theory, "Cables"): the algorithmic forces Q,
// whose accelerations are part of A, and the forces F at the end of the step, which true accelerations
// balance. N, 3 * local blocks, valid for owned blocks.
struct MeanForces {
  std::vector<double> q, f;
};
StepMean alpha_mean(const AlphaCoefficients& c);
// `history` is the part of F at the end of a step that does not depend on S: F = StepMean::weight * S +
// history.
void alpha_mean_history(const AlphaCoefficients& c, const MeanForces& from, std::vector<double>& history);
// Advances Q and F over a step with the mean forces S.
void alpha_mean_advance(const AlphaCoefficients& c, const std::vector<double>& S, MeanForces& forces);

// Weights of K, C and M in the step's tangent.
Weights alpha_weights(const AlphaCoefficients& c, double h);

// A value at a node of the mesh, in the layout of MPI_DOUBLE_INT for MPI_MAXLOC.
struct NodeValue {
  double value = 0;
  int node = 0;
};

// Largest rotation in a step [rad] among this rank's nodes. From half a turn on, the orientation at the end
// does not determine the increment: another rotation leads there as well, with other rates.
NodeValue alpha_turn(const LocalMesh& mesh, const std::vector<double>& u);

// Local error of position, m, at this rank's nodes: |1/6 - beta| h² |change of acceleration|
// (Zienkiewicz & Xie 1991, eq. 17), times the `error_weight` of the node's line (1 where there is none).
double alpha_error(const LocalMesh& mesh, const AlphaCoefficients& c, double h, const AlphaState& from,
                   const AlphaState& to, const Runs<double>& error_weight);

}  // namespace hawser
