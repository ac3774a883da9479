// A force over a deformation, given as a table: tension over strain, bending moment over curvature, the force
// of a damper over its speed. Elastic, without hysteresis.
#pragma once

#include <span>

#include "hawser/kernels/monotone_cubic.hpp"

namespace hawser {

// Strain beyond the rows of a table, or of a constant EA, up to which a line is believed: rubber doubles its
// length, but not at a constant EA; of what is given by that, nylon ropes stretch most, by 0.4 or so before
// they break.
constexpr double kStrainBeyondRows = 0.5;

// A rising cubic through the rows and the origin; straight beyond the rows.
class ResponseCurve {
 public:
  using Row = MonotoneCubic::Row;  // strain [-], N; or 1/m, N m

  // Both columns increasing from row to row; a row at zero has zero force, and one is put in if none is
  // there. `odd`: no negative rows are given, what is negative is as what is positive (curvature). Otherwise,
  // without negative rows, it is straight below zero. std::invalid_argument with the number of the row (from
  // 1).
  ResponseCurve(std::span<const Row> rows, bool odd);

  struct Value {
    double force = 0, slope = 0, energy = 0;  // and its derivative by the strain and its integral from zero
  };
  Value at(double strain) const;

  double first() const { return curve_.rows().front().first; }  // of the rows, with that at zero
  double last() const { return curve_.rows().back().first; }
  double initial() const { return initial_; }  // slope at zero

 private:
  MonotoneCubic curve_;
  double initial_ = 0, integral_ = 0;  // at zero
};

}  // namespace hawser
