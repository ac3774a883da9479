// A curve through rows that rises with them.
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace hawser {

// Piecewise cubic through rows (x increasing, y not falling): continuous with its slope, never falling
// between them, no overshoot (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17; slopes by Fritsch & Butland
// 1984). Beyond the rows it goes on straight with the slope there.
class MonotoneCubic {
 public:
  using Row = std::pair<double, double>;  // x, y

  // At least two rows. The slope at the first one is `first`, or else that of a parabola; at an end a
  // parabola's slope is kept between `least` and 3 times the secant's.
  explicit MonotoneCubic(std::vector<Row> rows, std::optional<double> first = {}, double least = 0);

  struct Value {
    double y = 0, slope = 0, bend = 0;  // and first two derivatives by x
    double integral = 0;                // of y from the first row on
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
