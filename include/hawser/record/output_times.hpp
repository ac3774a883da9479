// Times at which a step must end.
#pragma once

#include <algorithm>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::record {

// Next multiple of `every` after t, without accumulated rounding.
double next_multiple(double t, double every);
// Tolerance [s] within which times equal t.
inline double time_tolerance(double t) { return 1e-9 * std::max(1.0, t); }

// Times of outputs, checkpoints, events and velocity jumps of prescribed bodies.
class OutputTimes {
 public:
  explicit OutputTimes(const model::Case& c);
  double next(double t) const;  // s, after t

  // s, interval of outputs, of checkpoints. Without an interval checkpoints are written with outputs, as far
  // as they take at most 2 % of the computing time.
  double every = 0, checkpoint_every = 0;

 private:
  std::vector<double> jumps_;
};

}  // namespace hawser::record
