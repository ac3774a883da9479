// State of an earlier run's results file before it is continued. Internal to io.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/results_build.hpp"

namespace hawser::io {

// State of the file at `path`. Serial. Throws InputError if it is no results file.
struct ResultProgress {
  ResultCount count;
  std::vector<double> output_times, step_times;  // s, of the rows that count
  ResultRoom room;                               // of the checkpoint slots; outputs and steps are left 0
  std::vector<long long> clashes;                // that had ended, at each output
  std::vector<long long> contacts;               // points so far, at each output
};
ResultProgress read_progress(const std::string& path);

// Number of rows in dataset `name`, with these times, up to time `last` [s]. Rows lost by a power failure at
// the end count as later. Throws InputError if a row to be kept comes after an invalid one.
long long rows_until(const std::string& path, const std::string& name, const std::vector<double>& times,
                     double last);

// What a run that continues a file takes over from it. Plain data, so that rank 0 can send it.
struct EarlierRows {
  ValidRows kept;
  long long open_clashes = 0;                 // at the last kept output
  long long slot_doubles = 0, slot_text = 0;  // capacity of a checkpoint
};
struct EarlierResults {
  EarlierRows rows;
  std::vector<double> output_times;  // s, of the kept outputs
};
// Those up to `time` [s]; reported: as in ResultsFile::resume(). Serial. Throws as the functions above.
EarlierResults read_earlier(const std::string& path, double time, const ReportedClashes& reported);

}  // namespace hawser::io
