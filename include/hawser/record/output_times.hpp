// The times at which a run ends a step whatever its length.
#pragma once

#include <algorithm>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::record {

// Multiples of `every` after t, as numbers that do not drift.
double next_multiple(double t, double every);
// s: times no further from t are the same.
inline double time_tolerance(double t) { return 1e-9 * std::max(1.0, t); }

// Outputs, checkpoints, events, and jumps in the velocity of prescribed bodies.
class OutputTimes {
 public:
  explicit OutputTimes(const model::Case& c);
  double next(double t) const;  // s, after t

  double every = 0, checkpoint_every = 0;  // s, between outputs, between checkpoints; 0: with the outputs

 private:
  std::vector<double> jumps_;
};

}  // namespace hawser::record
