// Root of a function of one variable of which each value takes long and may not exist: the search says where
// it wants the next value, and the caller adds it.
#pragma once

#include <utility>
#include <vector>

namespace hawser {

// First outward from the start, or from the nearest place that has a value, in growing steps until the sign
// changes, then between both sides by inverse
// quadratic interpolation or bisection (Chandrupatla 1997, Advances in Engineering Software 28, 145-149).
class RootSearch {
 public:
  // The start and the limits low < start < high; the size of the first step, its sign the direction in which
  // the function is expected to grow.
  RootSearch(double start, double step, double low, double high);

  double next() const { return next_; }
  void add(double value);  // of the function at next()
  void fail();             // there is none at next()

  bool bracketed() const { return bracketed_; }
  // No change of sign between the limits, or between where values exist.
  bool exhausted() const { return exhausted_; }
  // How far the two sides of a bracket are apart.
  double width() const;
  // All values that were added: place, value; in the order of places.
  const std::vector<std::pair<double, double>>& values() const { return values_; }

 private:
  void begin(double value);
  void extend_range();
  void outward();
  void between();
  struct Way {  // in one direction from the start
    double step = 0, limit = 0, x = 0, f = 0;
    double tried = 0;  // size of the step with which a first value is looked for
    int failures = 0;
    bool ended = false;
  };
  Way way_[2];
  int going_ = 0, count_ = 0, failures_at_start_ = 0;  // of the start: failures before the first value
  bool bracketed_ = false, exhausted_ = false;
  double next_ = 0;
  double x_[3] = {}, f_[3] = {};  // of the bracket: the newest, the other side, the one before
  double share_ = 0.5;            // of the way from x_[0] to x_[1]
  int failures_ = 0;
  std::vector<std::pair<double, double>> values_;
};

}  // namespace hawser
