// Bending with memory: elastic-perfectly plastic springs in parallel (Iwan 1967, J. Appl. Mech. 34), each
// with its own plastic curvature vector; as many nested yield circles (Besseling 1958, J. Appl. Mech. 25).
// The moment follows a given curve when bent for the first time, twice that curve when bent back (Masing),
// and remembers. docs/theory/plastic-bending.md.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace hawser {

// Moment and its tangent by the curvature vector (about 2 and 3), N m and N m²; recoverable energy, J/m.
struct BendingMoment {
  double energy = 0, m[2] = {}, K[2][2] = {};
};

class PlasticBending {
 public:
  using Row = std::pair<double, double>;  // 1/m, N m

  // Broken line from zero through the rows: curvatures and moments rise, slopes fall. It goes on with the
  // last slope. std::invalid_argument with the number of the row (from 1) where they do not.
  explicit PlasticBending(std::span<const Row> rows);

  double initial() const { return initial_; }            // N m², of the first row
  double last() const { return springs_.back().yield; }  // 1/m, of the last row
  // Numbers that one place of a line remembers: the plastic curvature of each spring about 2 and 3, 1/m.
  size_t memory() const { return 2 * springs_.size(); }

  // At a curvature, from what is remembered; null: never bent before. Exact tangent of the backward Euler
  // step.
  BendingMoment at(double c2, double c3, const double* set) const;
  // Makes the memory that of a place that has been bent there. What was dissipated, J/m.
  double bend(double c2, double c3, double* set) const;
  // Curvature at which a place has no moment when it springs back elastically, 1/m.
  std::pair<double, double> residual(const double* set) const;

 private:
  struct Spring {
    double stiffness, yield;  // N m², 1/m
  };
  std::vector<Spring> springs_;
  double initial_ = 0, hardening_ = 0;  // N m²
};

// Rows of Ramberg and Osgood's curve, kappa/kappa_y = M/M_y + A (M/M_y)^B with kappa_y = M_y/EI (as used of
// pipes that are laid), from zero to the curvature `last`: so placed that the broken line through them is
// nowhere much farther from it than elsewhere, as a share of the moment.
std::vector<PlasticBending::Row> ramberg_osgood(double EI, double yield_moment, double A, double B,
                                                double last, int rows);

}  // namespace hawser
