// Newton's iteration across kinks of the energy.
//
// If a line rests at a concave edge between two facets, the force across it jumps, and a root may lie on the
// jump. Newton's iteration then oscillates across it, each time by the jump over the stiffness K, and the
// residual r remains as large as the jump. Usually each node has kinks of its own. Where a step d ends in a
// residual that opposes it at a node (r.d > 0), the force has increased there by more than the tangent
// predicts. The secant of that increment,
//
//   S += r r' / (r.d)
//
// (the symmetric correction of rank one, Nocedal & Wright 2006, Numerical Optimization, eq. 6.24, for the
// block of each node; r is the residual of the model K + S), stops the next step near the kink. Each time a
// step crosses the same kink again, S about doubles and d halves. At a kink of the energy S grows without
// bound as d vanishes, and the jump j = S d of the force remains. The node is in equilibrium if
//
//   0 is in { r - s j : 0 <= s <= 1 },
//
// that is, if zero is in Clarke's generalised gradient (Clarke 1983, Optimization and Nonsmooth Analysis,
// section 1.2). A smooth force has no second unpredicted increment: its secant is its stiffness. See
// docs/theory/relaxation.md, "Kinks".
#pragma once

#include <petscmat.h>

#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

class KinkStiffness {
 public:
  // Begins an iteration of Newton's method. Secants begin as soon as it cycles, or if it stagnates after
  // `patience` iterations.
  void clear(int patience = 0);
  // u: the increment of this iteration (owned blocks of 3), r: the residual there, relative: its size over
  // its scale. Once the iteration stagnates or cycles the secants are updated. Returns whether it does; the
  // next tangent then needs add_to(). Call it after each iteration, the first included. The same on all
  // ranks.
  bool observe(const double* u, Vec r, double relative);
  bool active() const { return active_; }
  // Iterations before it stagnated or the cycle began, at least 1.
  int smooth_iterations() const { return smooth_; }
  // Adds S to the assembled tangent. Collective.
  void add_to(const System& system, Mat J) const;
  // Norms of r without the jumps at nodes that lie within 1e-7 `length` of their kink. length: of the longest
  // element, m. Collective.
  ResidualNorms norms_without_jumps(const System& system, Vec r, double length) const;

 private:
  struct Block {
    Mat3 S = Mat3::Zero();     // N/m
    Vec3 jump = Vec3::Zero();  // N, across the last step over the kink, to the side where the node is
    double distance = 0;       // m, most from the kink
    int rises = 0;
  };
  // Number of residuals that the iteration repeats, 0 if it does not.
  int cycle() const;

  std::vector<Block> blocks_;
  std::vector<double> last_;       // increment of the iteration before
  std::vector<double> residuals_;  // relative, of all iterations
  int patience_ = 0, stale_ = 0, smooth_ = 0;
  bool active_ = false;
};

}  // namespace hawser
