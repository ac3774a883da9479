// The clash report in a results file: a table of the clashes that have ended, which only grows, and two
// tables of those still going on, which outputs fill in turn. The row `outputs/clashes` of an output says how
// many rows of both count, so that the counter of outputs is the counter of these as well.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"

namespace hawser::io {

// A pair in contact from the first accepted step that finds it so to the last one. Indices into the lines and
// volumes of the contents; -1: none. Arc lengths [m] on `line` and `other_line` are those that touched at any
// time.
struct ClashRow {
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  double start = 0, end = 0;                                         // s
  double from = 0, to = 0, other_from = 0, other_to = 0;             // m
  double peak_force = 0, peak_time = 0, peak_from = 0, peak_to = 0;  // N, s, m: where it touched at the peak
  double impulse = 0;                                                // N s, of the sizes of the normal forces
  double peak_energy = 0, penetration = 0;                           // J, m
};

// What an output adds; those of rank 0 count.
struct ClashTables {
  std::vector<ClashRow> ended;  // since the last output
  std::vector<ClashRow> open;   // now
};

// What outputs so far have put into a file: how many that ended, and those that went on at the last one. That
// of rank 0 counts.
struct ReportedClashes {
  long long ended = 0;
  std::vector<ClashRow> open;
};

// Rows the tables have room for.
struct ClashRoom {
  long long ended = 64, open = 64;
  bool operator==(const ClashRoom&) const = default;
};

// In file and memory.
h5::Id clash_type();
inline constexpr const char *kClashesEnded = "clashes/ended", *kClashesOpen = "clashes/open",
                            *kClashCounts = "outputs/clashes";

// What a results file holds at its last output. Serial.
ClashTables read_clashes(const std::string& path);

// --- Inside io.

// The datasets, all but the counts; `volumes`: their names. Serial, as the next two.
void make_clash_tables(hid_t file, const ClashRoom& room, const std::vector<std::string>& volumes);
// `ended` rows of what is in `from`, and the open ones of both tables as far as there is room.
void copy_clash_tables(hid_t from, hid_t to, long long ended);
// After the `kept` rows, with the counts of the last output (row `output`, -1: none).
void write_last_clashes(hid_t file, const ClashTables& last, long long kept, long long output);

}  // namespace hawser::io
