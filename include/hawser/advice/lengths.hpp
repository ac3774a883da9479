// Sentences about the search for lengths that meet a target at rest, and about feeders that run out.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// A search for the length of a section, or of what is inside a feeder (whose target is its tension).
struct LengthSearched {
  std::string line;
  const model::LengthTarget& target;
  bool in_feeder = false;
  double given = 0, length = 0, value = 0;  // m, of the case; m, tried last; in the unit of the target
};
// Of one trial.
std::string length_tried(const LengthSearched& at);
// The end of the search, after so many statics.
std::string length_found(const LengthSearched& at, int trials);

// What a search without result has tried: (length, value), and why statics failed beyond those.
struct LengthsTried {
  using Trial = std::pair<double, double>;
  struct Range {
    Trial first, last, least, most;  // by order of trial, and by value
  };
  std::optional<Range> range;   // none: no statics was found
  std::optional<double> jumps;  // m, where the value jumps over the target
  std::string why;
};
std::string length_not_found(const LengthSearched& at, const LengthsTried& tried);
std::string feeder_not_at_rest(const LengthSearched& at, const LengthsTried& tried);
std::string targets_do_not_settle();
// Of a run that continues from another one, which has found it.
std::string length_of_other_run(const std::string& line, int section, double length);

// At a time [s].
std::string stock_runs_out(const std::string& feeder, double time);
std::string all_hauled_in(const std::string& feeder, double time, bool up_to_cut);

}  // namespace hawser::advice
