// Equilibrium on a kink of the energy.
//
// The normal of a surface of facets turns at their edges, and the contact force of a line that rests on an
// edge jumps. Newton's method and its line search stop there: the energy increases on both sides, and no
// residual is small. The line is in equilibrium if a combination sum l_i r_i, l_i >= 0, sum l_i = 1, of the
// residuals on the sides of the kink vanishes, as zero is then in the generalised gradient of the energy
// (Clarke 1983, Optimization and Nonsmooth Analysis, sections 1.2 and 2.3). Otherwise u = -K^-1 sum l_i r_i,
// with the l that minimise the square of the combination in the norm of K^-1, descends along the kink: it
// minimises u'Ku/2 + max_i r_i'u (Burke, Lewis & Overton 2005, SIAM J. Optim. 15, 751-779).
//
// Serves Newton's descent in statics, whose search along the increment finds one kink at a time. Steps of
// relaxation and of time have no such search, and most nodes have kinks of their own there: see
// kink_stiffness.hpp.
#pragma once

#include <petscksp.h>

#include <Eigen/Core>
#include <vector>

#include "hawser/system/system.hpp"

namespace hawser {

// The l that minimises l'Gl, l >= 0, sum l = 1, for a symmetric, positive semidefinite G of a few rows. All
// sets of nonzero l are tried.
Eigen::VectorXd smallest_combination(const Eigen::MatrixXd& G);

// The sides of the kinks on which a state lies. The state itself is on one of them, with the residual r [N, N
// m]. All functions are collective.
class KinkSides {
 public:
  bool empty() const { return sides_.empty(); }
  void clear() { sides_.clear(); }
  // Adds the side at the distance `from_state` of the state (3 * local blocks, m and rad). The oldest of more
  // than four sides is removed.
  void add(const std::vector<double>& from_state, Vec like);
  // Evaluates the residuals of the sides. `trial` is changed.
  void evaluate(System& system, const State& state, State& trial);
  // Norms of the smallest combination of r and the residuals of the sides.
  ResidualNorms norms(const System& system, Vec r) const;
  // y = K^-1 r on entry, the solution for the combination on return.
  void combine(KSP solver, Vec r, Vec y) const;
  // The largest of the slopes r_i'u of the sides.
  double slope(Vec u) const;

 private:
  struct Side {
    std::vector<double> from_state;
    VecHandle r;
  };
  std::vector<Side> sides_;
};

}  // namespace hawser
