// What is in a results file of an earlier run, before it is continued. Inside io only.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/results_build.hpp"

namespace hawser::io {

// How far the file at `path` got. Serial. Throws InputError when it is no results file.
struct ResultProgress {
  ResultCount count;
  std::vector<double> output_times, step_times;  // s, of the rows that count
  ResultRoom room;                               // of the checkpoint slots; outputs and steps are left 0
  std::vector<long long> clashes;                // that had ended, at each output
  std::vector<long long> contacts;               // points so far, at each output
};
ResultProgress read_progress(const std::string& path);

// Of such times, in the dataset `name`, the rows up to the time `last` [s]. What a power cut has lost at the
// end counts as later. Throws InputError when rows that should stay come after one that is not in its place.
long long rows_until(const std::string& path, const std::string& name, const std::vector<double>& times,
                     double last);

}  // namespace hawser::io
