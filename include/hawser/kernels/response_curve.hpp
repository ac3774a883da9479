// Force by deformation from a table: tension by strain, bending moment by curvature, damper force by speed.
// Elastic, without hysteresis.
#pragma once

#include <span>

#include "hawser/kernels/monotone_cubic.hpp"

namespace hawser {

// Strain beyond the rows of a table, or with a constant EA, up to which results are considered valid. Rubber
// doubles its length, but not at a constant EA; of materials with constant EA nylon ropes stretch most, by
// about 0.4 at break.
constexpr double kStrainBeyondRows = 0.5;

// Increasing cubic through the rows and the origin; linear beyond the rows.
class ResponseCurve {
 public:
  using Row = MonotoneCubic::Row;  // strain [-], N; or 1/m, N m

  // Both columns increase from row to row; a row at zero must have zero force and is added if missing. odd:
  // only positive rows, continued as an odd function (curvature). If not odd and without negative rows, the
  // curve is linear below zero. Throws std::invalid_argument with the number of the row (from 1).
  ResponseCurve(std::span<const Row> rows, bool odd);

  struct Value {
    double force = 0, slope = 0, energy = 0;  // force, its derivative by strain, its integral from zero
  };
  Value at(double strain) const;

  double first() const { return curve_.rows().front().first; }  // of the rows including that at zero
  double last() const { return curve_.rows().back().first; }
  double initial() const { return initial_; }  // slope at zero

 private:
  MonotoneCubic curve_;
  double initial_ = 0, integral_ = 0;  // at zero
};

}  // namespace hawser
