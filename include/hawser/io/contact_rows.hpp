// Points of contact in a results file: three tables with a row a point, those of an output after those of the
// output before. The row of an output in `outputs/contact_points` says how many rows it and all before it
// have, so that the counter of outputs is the counter of these as well.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/io/results_rows.hpp"
#include "hawser/math/types.hpp"

namespace hawser::io {

struct ResultContents;

// Where something touches, and the force there. Indices into the lines and volumes of the contents; -1: none.
struct ContactRow {
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  Vec3 position = Vec3::Zero();  // m, space axes
  Vec3 force = Vec3::Zero();     // N, space axes; on `line`, without one on `volume`
};
using ContactRows = std::vector<ContactRow>;

inline constexpr const char *kContactCounts = "outputs/contact_points",
                            *kContactPairs = "contact_points/pair",
                            *kContactPositions = "contact_points/position",
                            *kContactForces = "contact_points/force";

// --- Inside io.

// Where this rank's points of some outputs stand: those of an output follow each other by ranks. Collective,
// once for all these outputs. before: rows of earlier outputs.
struct ContactPlaces {
  std::vector<RowRun> runs;
  std::vector<long long> counts;  // by output: rows of it and of all before it, of all ranks
  long long last = 0;             // the last of them
  bool any = false;               // has some rank a point
};
ContactPlaces contact_places(MPI_Comm comm, const std::vector<ContactRows>& outputs, long long before);

// Writes these points there, and the counts from the row `output` on. Collective.
void write_contacts(SharedFile& file, long long output, const std::vector<ContactRows>& outputs,
                    const ContactPlaces& at);

// Rows for which a new file has room: a point a node at each output. Room that is left costs nothing.
long long contact_room(const ResultContents& contents);

}  // namespace hawser::io
