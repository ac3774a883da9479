// Messages about the search for lengths that meet a static target, and about feeders that run out.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// A search for the length of a section, or for the stock of a feeder (whose target is its tension).
struct LengthSearched {
  std::string line;
  const model::LengthTarget& target;
  bool in_feeder = false;
  double given = 0, length = 0, value = 0;  // m, in the case; m, last trial; in the unit of the target
};
// Progress of one trial.
std::string length_tried(const LengthSearched& at);
// Result after `trials` static analyses.
std::string length_solved(const LengthSearched& at, int trials);

// Trials of an unsuccessful search, (length, value), and why statics failed beyond them.
struct LengthsTried {
  using Trial = std::pair<double, double>;
  struct Range {
    Trial first, last, shortest, longest;  // by order of trials, and by value
  };
  std::optional<Range> range;   // none: statics never converged
  std::optional<double> jumps;  // m, length at which the value jumps across the target
  std::string why;
};
std::string length_not_solved(const LengthSearched& at, const LengthsTried& tried);
std::string feeder_not_at_rest(const LengthSearched& at, const LengthsTried& tried);
std::string targets_do_not_settle();
// For a run that continues from one that found the length.
std::string length_of_other_run(const std::string& line, int section, double length);

// time: s.
std::string stock_runs_out(const std::string& feeder, double time);
std::string all_hauled_in(const std::string& feeder, double time, bool up_to_cut);

}  // namespace hawser::advice
