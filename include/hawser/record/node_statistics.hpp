// Minimum, maximum, their times, mean and standard deviation of node fields over every step of a run.
#pragma once

#include <cstddef>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"

namespace hawser::record {

// Between two steps a value is taken to vary linearly: mean and variance are those of that curve, so that
// steps of any length count by their length. Where a value is NaN there is none: that time does not count.
class NodeStatistics {
 public:
  // Those of `fields` that have statistics, of so many owned nodes, over all that comes at `from` [s]
  // or later.
  NodeStatistics(const std::vector<io::ResultField>& fields, std::size_t nodes, double from);

  const std::vector<io::ResultField>& fields() const { return fields_; }
  // An accepted step: values of all fields of the constructor, by field, nodes x components.
  void add(double time, const std::vector<std::vector<double>>& values);
  // Of a field of fields(): nodes x components x io::kStatistics numbers; NaN where none
  // has counted yet.
  std::vector<double> table(std::size_t field) const;

  void save(io::Checkpoint& to) const;
  // A file of an older version has none: they count from its time on.
  void restore(const io::Checkpoint& from);

 private:
  struct Sums {
    double least, least_time, most, most_time, mean;
    double squares;  // integral of the squared difference from the mean, s times the unit squared
    double last;     // value at the latest step; NaN: it had none
    double covered;  // s, how long it had one
  };
  std::vector<io::ResultField> fields_;
  std::vector<std::size_t> place_;  // of each, among all fields
  std::vector<std::vector<Sums>> sums_;
  double from_;
  bool begun_ = false;
  double latest_ = 0;  // s
};

}  // namespace hawser::record
