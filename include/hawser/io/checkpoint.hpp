// What a run needs to go on after a stop, bit for bit, on any number of ranks.
#pragma once

#include <mpi.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hawser/io/results_rows.hpp"
#include "hawser/system/checkpoint_record.hpp"

namespace hawser::io {

struct CheckpointField {
  int components = 1;
  std::vector<double> values;  // owned nodes x components, ascending node number
  // Instead of them in a checkpoint that is to be written: makes them when their turn comes, so that never
  // all of it is in memory. What it makes them of must not change until then.
  std::function<std::vector<double>()> make = {};
};

// What a term keeps, and how; the kinds are the same on all ranks.
struct TermCheckpoint {
  std::vector<CheckpointKind> kinds;
  std::vector<CheckpointRecord> records;  // of this rank's owned nodes
  // As in CheckpointField, of some nodes at a time.
  std::function<std::vector<CheckpointRecord>(NodeRange)> make = {};
};

// Names (map keys) are the same on all ranks; a rank without records of a term gives an empty list.
// Keys hold no line breaks.
struct Checkpoint {
  double time = 0;                                // s
  long long sequence = 0;                         // its number in the file it was read from
  std::map<std::string, double> scalars;          // same on all ranks
  std::map<std::string, CheckpointField> nodes;   // this rank's owned nodes
  std::map<std::string, TermCheckpoint> records;  // by term
};

// The newest complete checkpoint in the results file `path`, cut to the nodes this rank owns
// (`owned`: ascending node numbers in file order; together the ranks own 0 .. nodes_total-1 once).
// Doubles come back bit for bit; records come sorted by node, kind and key. Each rank reads its own part of
// the file, and a share as large as that of any other rank for the checksum. Collective.
// Throws InputError (on all ranks) when there is none, a rank cannot read the file, or the checkpoint belongs
// to a mesh of another size.
Checkpoint read_checkpoint(MPI_Comm comm, const std::string& path, int nodes_total,
                           const std::vector<int>& owned);

// --- What results.cpp stores: the checkpoint as one array of doubles with a text that says what is where.

constexpr int kCheckpointRecordHead = 4;  // numbers of a record before its values

struct CheckpointRoom {
  std::string index;   // same on all ranks
  long long size = 0;  // doubles in the whole array, same on all ranks
};

// Collective. Throws std::logic_error when names differ between ranks or a record's node is not owned.
CheckpointRoom checkpoint_room(MPI_Comm comm, const Checkpoint& checkpoint, int nodes_total,
                               const std::vector<int>& owned);

// Hands the array over piece by piece, as many on every rank: this rank's share of it, ascending, and the
// numbers there. What is passed on of the checkpoint is forgotten, so that it is not in memory twice.
// Returns the checksum of the whole array, the same on all ranks. Collective.
using PutNumbers = std::function<void(const std::vector<RowRun>& runs, const std::vector<double>& values)>;
unsigned long long put_checkpoint(MPI_Comm comm, Checkpoint checkpoint, int nodes_total,
                                  const std::vector<int>& owned, const PutNumbers& put);
// Inverse: asks for those numbers of the array, `size` long, that belong to the nodes `owned` or to all
// ranks. Serial. Throws InputError where they are no checkpoint of `nodes_total` nodes.
using GetNumbers = std::function<std::vector<double>(const RowRun& run)>;
Checkpoint unpack_checkpoint(const std::string& index, long long size, int nodes_total,
                             const std::vector<int>& owned, const GetNumbers& get);

// Checksum that does not depend on who summed what: sum over i of mix(first + i, bits of values[i]).
unsigned long long checkpoint_sum(long long first, const double* values, long long count);
unsigned long long checkpoint_sum(const std::string& index, long long sequence, long long size);

}  // namespace hawser::io
