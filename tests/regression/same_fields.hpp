// Whether two runs have the same fields, within a fraction of each field's range.
#pragma once

#include "regression/runs.hpp"

namespace hawser::runs {

// Range of the values that are not NaN.
inline double range(const std::vector<double>& a) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const double x : a) {
    least = std::fmin(least, x);
    most = std::fmax(most, x);
  }
  return std::max(most - least, 0.0);
}

// Expects equal output times, and every field equal within `share` of its range. Returns the largest
// difference over the range.
inline double expect_same_fields(const Results& a, const Results& b, double share) {
  EXPECT_EQ(a.output_times, b.output_times);
  EXPECT_EQ(a.fields.size(), b.fields.size());
  double most = 0;
  for (const auto& [name, values] : a.fields) {
    const auto there = b.fields.find(name);
    const double apart = there == b.fields.end() ? HUGE_VAL : largest_difference(values, there->second);
    EXPECT_LE(apart, share * range(values)) << name;
    if (apart > 0) most = std::max(most, apart / std::max(range(values), 1e-300));
  }
  return most;
}

}  // namespace hawser::runs
