// Static condensation of a tangent onto the unknowns of bodies: their stiffness while everything else remains
// in equilibrium. The columns are solutions with the tangent in which the bodies are held.
#pragma once

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

  // Sets v to the unit vector of the k-th of these rows.
  void set_unit(Vec v, Eigen::Index k) const;
  // Sets these rows of v to zero.
  void clear(Vec v) const;
  // These rows of v, on all ranks.
  Eigen::VectorXd values(Vec v) const;
  // These rows and columns of A.
  Eigen::MatrixXd block(const System& system, Mat A) const;
  // Sets these rows and columns of A to those of the unit matrix.
  void hold(Mat A) const;

 private:
  bool owns(Eigen::Index k) const { return rows_[k] >= first_ && rows_[k] < end_; }
  std::vector<int> rows_;
  PetscInt first_ = 0;
  PetscInt end_ = 0;
};

// Stiffness K of the bodies' unknowns b with all others, l, in equilibrium:
//   J_ll x = -J_lb e, K e = J_bb e + J_bl x.
// held: solver with the tangent of held bodies, with the ties of the system. nullopt on all ranks: it is
// singular. Collective.
std::optional<Eigen::MatrixXd> condensed(const BodyRows& bodies, const System& system, Mat J, KSP held);

}  // namespace hawser
