// Checkpoints: the complete state for a bitwise identical continuation on any number of ranks.
#pragma once

#include <mpi.h>

#include <cstdint>
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
  // Alternative to `values` when writing: called only when they are due, so that never all are in memory. Its
  // sources must not change until then.
  std::function<std::vector<double>()> make = {};
};

// Stored state of a force term; the kinds are the same on all ranks.
struct TermCheckpoint {
  std::vector<CheckpointKind> kinds;
  std::vector<CheckpointRecord> records;  // of this rank's owned nodes
  // As CheckpointField::make, for a range of nodes.
  std::function<std::vector<CheckpointRecord>(NodeRange)> make = {};
};

// Names (map keys) are the same on all ranks and contain no line breaks; a rank without records of a term has
// an empty list.
struct Checkpoint {
  double time = 0;                                // s
  long long sequence = 0;                         // its number in the file it was read from
  std::map<std::string, double> scalars;          // same on all ranks
  std::map<std::string, CheckpointField> nodes;   // this rank's owned nodes
  std::map<std::string, TermCheckpoint> records;  // by term
};

// Newest complete checkpoint in the results file `path`, restricted to the nodes of this rank (`owned`:
// ascending node numbers in file order; together the ranks own 0 .. nodes_total-1 once). Doubles are restored
// bit for bit; records are sorted by node, kind and key. Each rank reads its own part of the file, and for
// the checksum an equal share. Collective. Throws InputError on all ranks if there is no checkpoint, a rank
// cannot read the file, or the mesh has another size.
Checkpoint read_checkpoint(MPI_Comm comm, const std::string& path, int nodes_total,
                           const std::vector<int>& owned);

// --- What results.cpp stores: the checkpoint as one array of doubles with a text that says what is where.

constexpr int kCheckpointRecordHead = 4;  // numbers of a record before its values

// Groups of a results file that hold checkpoints in turn: that with this sequence number, and all, each with
// the datasets header, index and values.
inline std::string checkpoint_slot(long long sequence) {
  return sequence % 2 ? "checkpoint/1" : "checkpoint/0";
}
inline constexpr long long kCheckpointSlots = 2;

// Header of a slot, written last, which makes its checkpoint the newest: four numbers of the file.
struct CheckpointHeader {
  std::uint64_t sequence = 0;  // 0: the slot is empty
  std::uint64_t size = 0;      // numbers of the array
  std::uint64_t text = 0;      // characters of the index
  std::uint64_t sum = 0;       // of the array and the index
};

struct CheckpointRoom {
  std::string index;   // same on all ranks
  long long size = 0;  // doubles in the whole array, same on all ranks
  // By term, doubles of the records of each of this rank's nodes.
  std::vector<std::vector<int>> lengths;
};

// Collective. Throws std::logic_error when names differ between ranks or a record's node is not owned.
CheckpointRoom checkpoint_room(MPI_Comm comm, const Checkpoint& checkpoint, int nodes_total,
                               const std::vector<int>& owned);

// Passes the array in pieces to `put`, equally many on every rank: the row runs of this rank, ascending, and
// their numbers. room: that of the checkpoint. Parts of the checkpoint are released when passed. Returns the
// checksum of the whole array, the same on all ranks. Collective.
using PutNumbers = std::function<void(const std::vector<RowRun>& runs, const std::vector<double>& values)>;
unsigned long long write_checkpoint_array(MPI_Comm comm, Checkpoint checkpoint, const CheckpointRoom& room,
                                          int nodes_total, const std::vector<int>& owned,
                                          const PutNumbers& put);
// Inverse: requests from `get` the numbers of the array of length `size` that belong to the nodes `owned` or
// to all ranks. Serial. Throws InputError if they are no checkpoint of `nodes_total` nodes.
using GetNumbers = std::function<std::vector<double>(const RowRun& run)>;
Checkpoint unpack_checkpoint(const std::string& index, long long size, int nodes_total,
                             const std::vector<int>& owned, const GetNumbers& get);

// Checksum independent of the distribution: sum over i of mix(first + i, bits of values[i]).
unsigned long long checkpoint_sum(long long first, const double* values, long long count);
unsigned long long checkpoint_sum(const std::string& index, long long sequence, long long size);

}  // namespace hawser::io
