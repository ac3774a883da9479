// Tables of contact points in a results file, one row for each point, in the order of the outputs. Each row
// of `outputs/contact_points` holds the number of points of that output and all earlier ones, so the counter
// of outputs also counts complete points.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/io/results_rows.hpp"
#include "hawser/math/types.hpp"

namespace hawser::io {

struct ResultContents;

// A contact point. Indices of lines and volumes in ResultContents; -1: none.
struct ContactRow {
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  Vec3 position = Vec3::Zero();  // m, space axes
  Vec3 force = Vec3::Zero();     // N, space axes; acts on `line`, or on `volume` if line is -1
};
using ContactRows = std::vector<ContactRow>;

inline constexpr int kContactNumbers = 10;  // in a ContactRow

inline constexpr const char* kContactCounts = "outputs/contact_points";
inline constexpr const char* kContactPairs = "contact_points/pair";
inline constexpr const char* kContactPositions = "contact_points/position";
inline constexpr const char* kContactForces = "contact_points/force";

// --- Inside io.

// Rows of this rank's points of several outputs; the points of an output are in the order of the ranks.
struct ContactPlaces {
  std::vector<RowRun> runs;
  std::vector<long long> counts;  // by output: rows of this output and all earlier ones, over all ranks
  long long last = 0;             // last entry of `counts`
  bool any = false;               // true if any rank has a point
};
// before: number of rows of earlier outputs. Collective: one call for all these outputs.
ContactPlaces contact_places(MPI_Comm comm, const std::vector<ContactRows>& outputs, long long before);

// Writes the points to the rows `at` and the counts to the rows from `output` on. Collective.
void write_contacts(SharedFile& file, long long output, const std::vector<ContactRows>& outputs,
                    const ContactPlaces& at);

// Rows reserved in a new file: one point for each node and output. Unused rows take no space on disk.
long long contact_room(const ResultContents& contents);

}  // namespace hawser::io
