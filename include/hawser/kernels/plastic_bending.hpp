// Bending with history: elastic-perfectly plastic springs in parallel (Iwan 1967, J. Appl. Mech. 34), each
// with its own plastic curvature vector; equivalent to nested yield circles (Besseling 1958, J. Appl. Mech.
// 25). The moment follows a given curve in first loading and twice that curve in reversal (Masing).
// docs/theory/plastic-bending.md.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace hawser {

// Moment [N m] and its tangent [N m²] by the curvature vector (about 2 and 3); recoverable energy, J/m.
struct BendingMoment {
  double energy = 0, m[2] = {}, K[2][2] = {};
};

class PlasticBending {
 public:
  using Row = std::pair<double, double>;  // 1/m, N m

  // Polyline from zero through the rows, with increasing curvatures and moments and decreasing slopes;
  // continued with the last slope. Throws std::invalid_argument with the number of the row (from 1).
  explicit PlasticBending(std::span<const Row> rows);

  double initial() const { return initial_; }            // N m², of the first row
  double last() const { return springs_.back().yield; }  // 1/m, of the last row
  // Length of the history of a point: plastic curvature of each spring about 2 and 3, 1/m.
  size_t memory() const { return 2 * springs_.size(); }

  // Moment at a curvature for the history `set`; null: never bent. Exact tangent of the backward Euler step.
  BendingMoment at(double c2, double c3, const double* set) const;
  // Updates the history to this curvature. Returns the energy dissipated, J/m.
  double bend(double c2, double c3, double* set) const;
  // Curvature without moment after elastic unloading, 1/m.
  std::pair<double, double> residual(const double* set) const;

 private:
  struct Spring {
    double stiffness, yield;  // N m², 1/m
  };
  std::vector<Spring> springs_;
  double initial_ = 0, hardening_ = 0;  // N m²
};

// Rows of the Ramberg-Osgood curve, kappa/kappa_y = M/M_y + A (M/M_y)^B with kappa_y = M_y/EI (as used for
// pipelay), from zero to the curvature `last`, placed so that the relative error of the polyline in the
// moment is nearly uniform.
std::vector<PlasticBending::Row> ramberg_osgood(double EI, double yield_moment, double A, double B,
                                                double last, int rows);

}  // namespace hawser
