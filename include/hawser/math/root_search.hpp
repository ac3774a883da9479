// Root of a function of one variable whose values are expensive and may not exist: the search requests the
// next value, and the caller adds it.
#pragma once

#include <utility>
#include <vector>

namespace hawser {

// First outward from the start, or from the nearest point with a value, in growing steps until the sign
// changes; then within the bracket by inverse quadratic interpolation or bisection (Chandrupatla 1997,
// Advances in Engineering Software 28, 145-149).
class RootSearch {
 public:
  // start and the limits low < start < high; step: size of the first step, with the sign of the direction in
  // which the function is expected to increase.
  RootSearch(double start, double step, double low, double high);

  double next() const { return next_; }
  void add(double value);  // value of the function at next()
  void fail();             // there is no value at next()

  bool bracketed() const { return bracketed_; }
  // True if there is no change of sign between the limits, or between points with values.
  bool exhausted() const { return exhausted_; }
  // Width of the bracket.
  double width() const;
  // All values added: (place, value), sorted by place.
  const std::vector<std::pair<double, double>>& values() const { return values_; }

 private:
  void begin(double value);
  void extend_range();
  void outward();
  void between();
  struct Direction {  // search in one direction from the start
    double step = 0, limit = 0, x = 0, f = 0;
    double tried = 0;  // size of the step in the search for a first value
    int failures = 0;
    bool ended = false;
  };
  Direction direction_[2];
  int side_ = 0, count_ = 0, failures_at_start_ = 0;  // failures_at_start_: before the first value
  bool bracketed_ = false, exhausted_ = false;
  double next_ = 0;
  double x_[3] = {}, f_[3] = {};  // bracket: newest point, other side, previous point
  double fraction_ = 0.5;         // fraction of the distance from x_[0] to x_[1]
  int failures_ = 0;
  std::vector<std::pair<double, double>> values_;
};

}  // namespace hawser
