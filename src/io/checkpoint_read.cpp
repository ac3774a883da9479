// Reading of a checkpoint: the newer valid one of two slots; each rank takes the data of its own nodes.
#include <array>
#include <cstdint>
#include <optional>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/checkpoint.hpp"
#include "hawser/io/hdf5.hpp"

namespace hawser::io {

namespace {

// Runs `work` on each rank. All ranks throw the error of the first failing rank, which any damage to the file
// may cause, as an InputError. Collective.
template <class Work>
void on_each(MPI_Comm comm, const Work& work) {
  on_each_rank(comm, [&] {
    try {
      work();
    } catch (const std::exception& e) {
      throw InputError(e.what());
    }
  });
}

struct Slot {
  std::string index;
  long long sequence = 0;  // 0: empty
  long long size = 0;      // of the array
  std::uint64_t sum = 0;   // of the array and the index
};

// Header and index of a slot.
Slot read_slot(hid_t file, const std::string& place) {
  Slot slot;
  if (!h5::exists(file, place + "/header")) return slot;
  CheckpointHeader header;
  h5::read_part(h5::open_dataset(file, place + "/header"), H5T_NATIVE_UINT64, 0, 4, &header);
  const h5::Id index = h5::open_dataset(file, place + "/index");
  if (header.size > h5::shape_of(h5::open_dataset(file, place + "/values")).at(0) ||
      header.text > h5::shape_of(index).at(0))
    return slot;
  slot = {std::string(header.text, '\0'), static_cast<long long>(header.sequence),
          static_cast<long long>(header.size), header.sum};
  h5::read_part(index, H5T_NATIVE_CHAR, 0, header.text, slot.index.data());
  // A sequence number is valid only in its own slot.
  if (slot.sequence < 0 || checkpoint_slot(slot.sequence) != place) slot.sequence = 0;
  return slot;
}

void broadcast(MPI_Comm comm, Slot& slot) {
  long long numbers[] = {slot.sequence, slot.size, static_cast<long long>(slot.sum), std::ssize(slot.index)};
  MPI_Bcast(numbers, 4, MPI_LONG_LONG, 0, comm);
  slot.sequence = numbers[0];
  slot.size = numbers[1];
  slot.sum = static_cast<std::uint64_t>(numbers[2]);
  slot.index.resize(static_cast<size_t>(numbers[3]));
  MPI_Bcast(slot.index.data(), static_cast<int>(slot.index.size()), MPI_CHAR, 0, comm);
}

// True if the checksum matches; it does not for a slot that was being written when the run died. Each rank
// sums an equal share of the array. Collective.
bool complete(MPI_Comm comm, hid_t file, const Slot& slot) {
  constexpr long long kPiece = 1 << 17;  // numbers in memory at a time
  const long long ranks = ranks_of(comm);
  const long long rank = rank_of(comm);
  const long long part_of_rank = (slot.size + ranks - 1) / ranks;
  const long long end = std::min(slot.size, (rank + 1) * part_of_rank);
  std::uint64_t sum = 0;
  on_each(comm, [&] {
    for (long long at = rank * part_of_rank; at < end; at += kPiece) {
      const long long count = std::min(kPiece, end - at);
      const std::vector<double> values = h5::read_part(file, checkpoint_slot(slot.sequence) + "/values",
                                                       static_cast<hsize_t>(at), static_cast<hsize_t>(count));
      sum += checkpoint_sum(at, values.data(), count);
    }
  });
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, comm);
  return slot.sum == checkpoint_sum(slot.index, slot.sequence, slot.size) + sum;
}

// Newest complete checkpoint of the open file. Collective.
std::optional<Slot> newest(MPI_Comm comm, hid_t file) {
  std::array<Slot, 2> slots;
  on_each(comm, [&] {
    if (rank_of(comm) == 0)
      slots = {read_slot(file, checkpoint_slot(0)), read_slot(file, checkpoint_slot(1))};
  });
  if (slots[0].sequence < slots[1].sequence) std::swap(slots[0], slots[1]);
  for (Slot& slot : slots) {
    broadcast(comm, slot);
    if (slot.sequence > 0 && complete(comm, file, slot)) return std::move(slot);
  }
  return std::nullopt;
}

// Contents of the array according to the index.
struct Contents {
  std::vector<std::string> scalars, fields, terms;  // names, in the order of the array
  Checkpoint checkpoint;                            // without values
};

InputError wrong_mesh() { return InputError("the checkpoint belongs to another mesh"); }
InputError damaged(double number) { return InputError("the checkpoint is damaged: it counts {:g}", number); }

Contents contents_of(const std::string& index, int nodes_total) {
  Contents c;
  TermCheckpoint* kept = nullptr;  // the last one named
  std::istringstream lines(index);
  for (std::string kind, name; lines >> kind;) {
    int components = 0;
    if (kind == "mesh") {
      if (!(lines >> components) || components != nodes_total) throw wrong_mesh();
      continue;
    }
    if (kind == "nodes" || kind == "quantity") lines >> components;
    lines.get();
    std::getline(lines, name);
    if (kind == "scalar") {
      c.scalars.push_back(name);
    } else if (kind == "nodes") {
      c.fields.push_back(name);
      c.checkpoint.nodes[name].components = components;
    } else if (kind == "records" || kind == "history") {
      throw InputError("an earlier version of hawser wrote it");
    } else if (kind == "term") {
      c.terms.push_back(name);
      kept = &c.checkpoint.records[name];
    } else if (kind == "kind" && kept) {
      kept->kinds.push_back({name, {}});
    } else if (kind == "quantity" && kept && !kept->kinds.empty()) {
      const size_t tab = std::min(name.find('\t'), name.size());
      kept->kinds.back().quantities.push_back(
          {name.substr(0, tab), components, name.substr(std::min(tab + 1, name.size()))});
    }
  }
  return c;
}

// A number of the array as an integer between 0 and `limit`.
long long count_of(double number, long long limit) {
  if (!(number >= 0 && number <= static_cast<double>(limit))) throw damaged(number);
  return static_cast<long long>(number);
}

// Appends the records in `values`, which belong to the nodes `of`.
void add_records(const std::vector<double>& values, NodeRange range, std::vector<CheckpointRecord>& list) {
  constexpr long long kMostKinds = 100;  // kinds of records per term
  size_t at = 0;
  const auto next = [&] { return at < values.size() ? values[at++] : throw damaged(0); };
  while (at < values.size()) {
    CheckpointRecord r;
    const double node = next();
    r.node = static_cast<int>(count_of(node, range.end - 1));
    if (!range.has(r.node)) throw damaged(node);
    r.kind = static_cast<int>(count_of(next(), kMostKinds));
    r.key = static_cast<int>(next());
    r.values.resize(static_cast<size_t>(count_of(next(), std::ssize(values))));
    for (double& v : r.values) v = next();
    list.push_back(std::move(r));
  }
}

}  // namespace

Checkpoint unpack_checkpoint(const std::string& index, long long size, int nodes_total,
                             const std::vector<int>& owned, const GetNumbers& get) {
  auto [scalars, fields, terms, c] = contents_of(index, nodes_total);
  const auto part = [&](long long first, long long count) {
    if (first + count > size) throw wrong_mesh();
    return get({first, count});
  };
  const std::vector<RowRun> runs = runs_of(owned);
  long long at = 0;
  const std::vector<double> numbers = part(at, 1 + std::ssize(scalars));
  at += std::ssize(numbers);
  c.time = numbers[0];
  for (size_t i = 0; i < scalars.size(); ++i) c.scalars[scalars[i]] = numbers[i + 1];

  for (const std::string& name : fields) {
    CheckpointField& field = c.nodes[name];
    const long long components = field.components;
    for (const RowRun& run : runs) {
      const std::vector<double> rows = part(at + run.first * components, run.count * components);
      field.values.insert(field.values.end(), rows.begin(), rows.end());
    }
    at += nodes_total * components;
  }

  for (const std::string& name : terms) {
    const long long length = count_of(part(at++, 1)[0], size);
    const long long records = at;          // offset of the records
    const long long begins = at + length;  // offset of the nodes' offsets
    at = begins + (length > 0 ? nodes_total : 0);
    for (const RowRun& run : runs) {
      if (length == 0) break;
      const bool last = run.first + run.count == nodes_total;  // its records extend to the end
      const std::vector<double> starts = part(begins + run.first, run.count + (last ? 0 : 1));
      const long long end = last ? length : count_of(starts.back(), length);
      const long long first = count_of(starts[0], end);
      const NodeRange nodes{static_cast<int>(run.first), static_cast<int>(run.first + run.count)};
      add_records(part(records + first, end - first), nodes, c.records[name].records);
    }
  }
  if (at != size) throw wrong_mesh();
  return std::move(c);
}

Checkpoint read_checkpoint(MPI_Comm comm, const std::string& path, int nodes_total,
                           const std::vector<int>& owned) {
  h5::Id file;
  on_each(comm, [&] { file = h5::open_parts(path); });
  const std::optional<Slot> slot = newest(comm, file);
  if (!slot) throw InputError(path + " holds no complete checkpoint to restart from");
  Checkpoint checkpoint;
  try {
    on_each(comm, [&] {
      const h5::Id values = h5::open_dataset(file, checkpoint_slot(slot->sequence) + "/values");
      checkpoint = unpack_checkpoint(slot->index, slot->size, nodes_total, owned, [&](const RowRun& run) {
        std::vector<double> part(static_cast<size_t>(run.count));
        h5::read_part(values, H5T_NATIVE_DOUBLE, static_cast<hsize_t>(run.first),
                      static_cast<hsize_t>(run.count), part.data());
        return part;
      });
    });
  } catch (const InputError& e) {
    throw InputError("cannot continue from " + path + ": " + e.what());
  }
  checkpoint.sequence = slot->sequence;
  return checkpoint;
}

}  // namespace hawser::io
