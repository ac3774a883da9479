// Minimum, maximum, their times, mean and standard deviation of node fields over all steps of a run.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"

namespace hawser::record {

// Values vary linearly between steps; mean and variance are those of that curve, so steps are weighted by
// their length. Intervals with NaN are excluded.
class NodeStatistics {
 public:
  // For those of `fields` with statistics, on `nodes` owned nodes, from time `from` [s] on.
  NodeStatistics(const std::vector<io::ResultField>& fields, std::size_t nodes, double from);

  const std::vector<io::ResultField>& fields() const { return fields_; }
  // Adds an accepted step: values of all fields of the constructor, by field, nodes x components.
  void add(double time, const std::vector<std::vector<double>>& values);
  // Table of a field of fields(): nodes x components x io::kStatistics numbers; NaN without data.
  std::vector<double> table(std::size_t field) const;

  void save(io::Checkpoint& to) const;
  // Statistics of fields that the run of the checkpoint did not have start at its time; so do those of all
  // fields if one of them is missing.
  void restore(const io::Checkpoint& from);

 private:
  struct Sums {
    double lowest, lowest_time, highest, highest_time, mean;
    double squares;  // integral of squared deviation from the mean, s times unit squared
    double last;     // value at the latest step; NaN: none
    double covered;  // s, total duration with values
  };
  // The numbers of Sums by their names in a checkpoint.
  static constexpr std::pair<const char*, double Sums::*> kNumbers[] = {
      {"lowest", &Sums::lowest},   {"lowest time", &Sums::lowest_time},
      {"highest", &Sums::highest}, {"highest time", &Sums::highest_time},
      {"mean", &Sums::mean},       {"squares", &Sums::squares},
      {"last", &Sums::last},       {"covered", &Sums::covered}};
  std::vector<io::ResultField> fields_;
  std::vector<std::size_t> place_;  // index of each among all fields
  std::vector<std::vector<Sums>> sums_;
  double from_;
  bool begun_ = false;
  double latest_ = 0;  // s
};

}  // namespace hawser::record
