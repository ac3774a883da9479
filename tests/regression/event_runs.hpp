// Shared by the tests of events: a chain that parts, means over its nodes, restarts before and after the
// event.
#pragma once

#include "hawser/base/error.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::events {

inline constexpr double kGravity = 9.80665;

// Mass-weighted mean of a component of a vector field over nodes [from, to] of an output. Nodes have 10 kg;
// the first and last have 5 kg of half an element and `first` or `last` in addition.
inline double mean_of(const Results& r, const std::string& field, size_t output, size_t from, size_t to,
                      size_t c, double first = 0, double last = 0) {
  const auto& x = r.fields.at(field);
  const size_t nodes = x.size() / 3 / r.output_times.size();
  double sum = 0, mass = 0;
  for (size_t n = from; n <= to; ++n) {
    const double m = n == from ? 5 + first : n == to ? 5 + last : 10;
    sum += m * x.at(3 * (nodes * output + n) + c);
    mass += m;
  }
  return sum / mass;
}

inline std::string error_of(const std::string& input, const std::string& file) {
  run::RunOptions o;
  o.case_path = input;
  o.output = file;
  o.quiet = true;
  try {
    run::run(MPI_COMM_WORLD, o);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

inline void expect_same_positions(const Results& whole, const Results& rest, double tolerance) {
  const auto& a = whole.fields.at("position");
  const auto& b = rest.fields.at("position");
  const std::vector<double> last(a.end() - static_cast<long>(b.size() / rest.output_times.size()), a.end());
  const std::vector<double> other(b.end() - static_cast<long>(last.size()), b.end());
  EXPECT_LE(largest_difference(last, other), tolerance);
}

// Compares restarts from before, at and after the event at 0.5 s with one run, and all ranks with one rank.
inline void expect_same_after_restarts(const std::string& path, const std::string& input, double tolerance) {
  run_on_all({input, path + "/whole.h5"});
  run_on_one({input, path + "/one.h5"});
  if (rank_of(MPI_COMM_WORLD) == 0)
    expect_same_positions(read(path + "/whole.h5"), read(path + "/one.h5"), tolerance);
  for (const double stop : {0.25, 0.5, 0.75}) {
    run_on_all({input, path + "/half.h5", "", stop});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) == 0)
      expect_same_positions(read(path + "/whole.h5"), read(path + "/rest.h5"), tolerance);
  }
}

// A chain hangs in air and is cut at mid-length. Nodes 0 to 10 are its lower part, which falls.
inline const char* const kHanging = R"(hawser: 1
title: A chain that parts
environment: {gravity: 9.80665}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false, stiffness_damping: 1e-3}
lines:
  chain:
    sections: [{type: chain, length: 20, elements: 20}]
    end_a: free
    end_b: {anchor: [0, 0, 100]}
dynamics: {duration: 1, max_step: 0.01}
events:
  - {cut: {line: chain, at: 10}, time: 0.5}
output: {every: 0.25}
contact: {between_lines: false}
)";

}  // namespace hawser::runs::events
