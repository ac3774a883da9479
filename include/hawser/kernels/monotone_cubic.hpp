// A monotone curve through rows.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace hawser {

// Piecewise cubic through rows (x increasing, y not decreasing), continuously differentiable and monotone,
// without overshoot (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17; slopes by Fritsch & Butland 1984).
// Linear beyond the rows.
class MonotoneCubic {
 public:
  using Row = std::pair<double, double>;  // x, y

  // At least two rows. The slope at the first row is `first`, or by default that of a parabola; a parabola's
  // slope at an end is limited to between `min_ratio` and 3 times the secant's.
  explicit MonotoneCubic(std::vector<Row> rows, std::optional<double> first = {}, double min_ratio = 0);

  struct Value {
    double y = 0, slope = 0, bend = 0;  // y and its first two derivatives by x
    double integral = 0;                // of y from the first row
  };
  Value at(double x) const;

  double largest_slope() const { return largest_slope_; }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
  std::vector<double> slope_, integral_;  // at the rows
  double largest_slope_ = 0;
};

}  // namespace hawser
