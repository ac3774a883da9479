// Static condensation of a tangent onto the unknowns of bodies: their stiffness while everything else remains
// in equilibrium. The columns are solutions with the tangent in which the bodies are held.
#pragma once

#include <petscksp.h>

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "hawser/system/system.hpp"

namespace hawser {

// Rows of the six unknowns of bodies in the global vectors, the same on all ranks. Constructor and functions
// that take vectors or matrices are collective.
class BodyRows {
 public:
  // nodes: local numbers of the bodies' nodes that this rank owns.
  BodyRows(const System& system, std::span<const int> nodes);
  Eigen::Index count() const { return std::ssize(rows_); }

  // Sets these rows of v to x, and all others to zero.
  void set(Vec v, const Eigen::VectorXd& x) const;
  // Sets these rows of v to zero.
  void clear(Vec v) const;
  // These rows of v, on all ranks.
  Eigen::VectorXd values(Vec v) const;
  // These rows and columns of A.
  Eigen::MatrixXd block(const System& system, Mat A) const;
  // Adds a matrix to these rows and columns of A, in which its nonzero entries have a place.
  void add(const Eigen::MatrixXd& values, Mat A) const;
  // Sets these rows and columns of A to those of the unit matrix.
  void hold(Mat A) const;

 private:
  bool owns(Eigen::Index k) const { return rows_[k] >= first_ && rows_[k] < end_; }
  std::vector<int> rows_;
  PetscInt first_ = 0;
  PetscInt end_ = 0;
};

// Most unknowns of bodies for which dense eigenvalues, of cubic cost, take no longer than statics.
inline constexpr Eigen::Index kMostDense = 300;

// Rows of the unknowns of all bodies. Collective.
BodyRows rows_of_bodies(const System& system);

// The two functions below are collective. held: solver with the tangent of held bodies, with the ties of the
// system. If that is singular, they return false or nullopt on all ranks.

// Sets `motion` to the motion e of the bodies' unknowns b with all others, x, in equilibrium: J_ll x = -J_lb
// e.
bool move_in_equilibrium(const BodyRows& bodies, const System& system, Mat J, KSP held,
                         const Eigen::VectorXd& e, Vec motion);

// Stiffness K of these unknowns with all others in equilibrium: K e = J_bb e + J_bl x.
std::optional<Eigen::MatrixXd> condensed(const BodyRows& bodies, const System& system, Mat J, KSP held);

}  // namespace hawser
