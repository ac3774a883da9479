// Clash report in a results file: a growing table of ended clashes, and two tables of ongoing ones, which
// outputs fill alternately. Row i of `outputs/clashes` has the numbers of rows of both at output i, so that
// the counter of outputs validates them as well.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"

namespace hawser::io {

// A pair in contact from the first to the last accepted step with contact. Indices into the lines and volumes
// of the contents; -1: none. Arc lengths [m] on `line` and `other_line` span all contact points over time.
struct ClashRow {
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  double start = 0, end = 0;                                         // s
  double from = 0, to = 0, other_from = 0, other_to = 0;             // m
  double peak_force = 0, peak_time = 0, peak_from = 0, peak_to = 0;  // N, s, m: contact range at the peak
  double impulse = 0;                       // N s, of the magnitude of the normal force
  double peak_energy = 0, penetration = 0;  // J, m

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("line", "", self.line);
    each("other_line", "", self.other_line);
    each("volume", "", self.volume);
    each("other_volume", "", self.other_volume);
    each("start", "s", self.start);
    each("end", "s", self.end);
    each("arc_from", "m", self.from);
    each("arc_to", "m", self.to);
    each("other_arc_from", "m", self.other_from);
    each("other_arc_to", "m", self.other_to);
    each("peak_force", "N", self.peak_force);
    each("peak_time", "s", self.peak_time);
    each("peak_arc_from", "m", self.peak_from);
    each("peak_arc_to", "m", self.peak_to);
    each("impulse", "N s", self.impulse);
    each("peak_energy", "J", self.peak_energy);
    each("penetration", "m", self.penetration);
  }
};

// Clashes of an output; those of rank 0 are written.
struct ClashTables {
  std::vector<ClashRow> ended;  // since the previous output
  std::vector<ClashRow> open;   // ongoing
};

// Clashes in a file after its last output: number of ended ones, and the ongoing ones. Valid on rank 0.
struct ReportedClashes {
  long long ended = 0;
  std::vector<ClashRow> open;
};

// Capacity of the tables, rows.
struct ClashRoom {
  long long ended = 64, open = 64;
  bool operator==(const ClashRoom&) const = default;
};

// HDF5 type of a row, in file and memory.
h5::Id clash_type();
inline constexpr const char *kClashesEnded = "clashes/ended", *kClashesOpen = "clashes/open",
                            *kClashCounts = "outputs/clashes";

// Clashes in a results file at its last output. Serial.
ClashTables read_clashes(const std::string& path);

// --- Internal to io.

// Creates the datasets except the counts; `volumes`: names. Serial, as the next two functions.
void make_clash_tables(hid_t file, const ClashRoom& room, const std::vector<std::string>& volumes);
// Copies the first `ended` rows, and the ongoing clashes of both tables up to the capacity.
void copy_clash_tables(hid_t from, hid_t to, long long ended);
// Writes after the `kept` rows, with the counts of the last output (row `output`, -1: none).
void write_last_clashes(hid_t file, const ClashTables& last, long long kept, long long output);

}  // namespace hawser::io
