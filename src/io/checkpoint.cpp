// How a checkpoint is packed into one array of numbers with an index, unpacked on any number of ranks,
// secured by a checksum, and read from the newer valid one of its two slots.
#include "hawser/io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "hawser/base/error.hpp"
#include "hawser/base/gather.hpp"
#include "hawser/io/hdf5.hpp"

namespace hawser::io {

namespace {

// Finaliser of MurmurHash3, 64 bits: every bit of the input reaches every bit of the output.
std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 33;
  h *= 0xff51afd7ed558ccdULL;
  h ^= h >> 33;
  h *= 0xc4ceb9fe1a85ec53ULL;
  return h ^ (h >> 33);
}

std::string describe(const Checkpoint& c, int nodes_total) {
  std::ostringstream out;
  out << "mesh " << nodes_total << '\n';
  for (const auto& [name, value] : c.scalars) out << "scalar " << name << '\n';
  for (const auto& [name, field] : c.nodes) out << "nodes " << field.components << ' ' << name << '\n';
  for (const auto& [term, kept] : c.records) {
    out << "history " << term << '\n';
    for (const CheckpointKind& k : kept.kinds) {
      out << "kind " << k.name << '\n';
      for (const CheckpointQuantity& q : k.quantities)
        out << "quantity " << q.components << ' ' << q.name << '\t' << q.unit << '\n';
    }
  }
  return out.str();
}

void agree(MPI_Comm comm, bool valid, const std::string& names) {
  std::uint64_t hash = checkpoint_sum(names, 0, 0);
  // If the largest hash and the largest complement belong to one value, all ranks have it.
  std::uint64_t most[3] = {hash, ~hash, valid ? 0u : 1u};
  MPI_Allreduce(MPI_IN_PLACE, most, 3, MPI_UINT64_T, MPI_MAX, comm);
  if (most[0] != ~most[1]) throw std::logic_error("checkpoint: names differ between ranks");
  if (most[2]) throw std::logic_error("checkpoint: values do not belong to the owned nodes");
}

constexpr double kMostKinds = 100;  // of records of a term
constexpr int kRecordHead = 4;      // numbers of a record before its values

// How many nodes' records are passed on at a time: an even part of them, so that terms which look through
// all that they keep for each part do so a limited number of times.
int nodes_at_a_time(int nodes_total) {
  constexpr int kParts = 16, kFewest = 500;
  return std::max(kFewest, nodes_total / kParts + 1);
}

struct Slot {
  std::string index;
  std::vector<double> values;
  long long sequence = -1;
};

// A slot that was being written when the run died has the wrong checksum.
bool read_slot(hid_t file, const std::string& name, Slot& slot) {
  if (!h5::exists(file, name)) return false;
  std::uint64_t header[4] = {};
  const h5::Id head = h5::open_dataset(file, name + "/header");
  h5::check(H5Dread(head, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, header), "checkpoint");
  const h5::Id index = h5::open_dataset(file, name + "/index");
  const h5::Id values = h5::open_dataset(file, name + "/values");
  const hsize_t size = header[1], length = header[2], zero = 0;
  if (header[0] == 0 || size > h5::shape_of(values)[0] || length > h5::shape_of(index)[0]) return false;
  slot.sequence = static_cast<long long>(header[0]);
  slot.index.resize(length);
  slot.values.resize(size);
  const auto read = [&](hid_t set, hid_t type, hsize_t n, void* to) {
    const h5::Id space = h5::own(H5Dget_space(set), H5Sclose, "checkpoint");
    const h5::Id memory = h5::own(H5Screate_simple(1, &n, nullptr), H5Sclose, "checkpoint");
    h5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &zero, nullptr, &n, nullptr), "checkpoint");
    h5::check(H5Dread(set, type, memory, space, H5P_DEFAULT, to), "checkpoint");
  };
  if (length) read(index, H5T_NATIVE_CHAR, length, slot.index.data());
  if (size) read(values, H5T_NATIVE_DOUBLE, size, slot.values.data());
  const auto n = static_cast<long long>(size);
  return header[3] == checkpoint_sum(slot.index, slot.sequence, n) + checkpoint_sum(0, slot.values.data(), n);
}

std::string read_newest(const std::string& path, Slot& best) {
  try {
    const h5::Id file = h5::open_read(path);
    for (const char* name : {"checkpoint/0", "checkpoint/1"}) {
      Slot slot;
      if (read_slot(file, name, slot) && slot.sequence > best.sequence) best = std::move(slot);
    }
  } catch (const std::exception& e) {
    return e.what();
  }
  return best.sequence < 0 ? path + " holds no complete checkpoint to restart from" : "";
}

template <class T>
void broadcast(MPI_Comm comm, T& data, MPI_Datatype type) {
  unsigned long long n = data.size();
  MPI_Bcast(&n, 1, MPI_UNSIGNED_LONG_LONG, 0, comm);
  data.resize(n);
  for (unsigned long long at = 0; at < n; at += 1u << 28)
    MPI_Bcast(data.data() + at, static_cast<int>(std::min<unsigned long long>(n - at, 1u << 28)), type, 0,
              comm);
}

}  // namespace

unsigned long long checkpoint_sum(long long first, const double* values, long long count) {
  std::uint64_t sum = 0;
  for (long long i = 0; i < count; ++i)
    sum += mix(mix(static_cast<std::uint64_t>(first + i) + 1) ^ std::bit_cast<std::uint64_t>(values[i]));
  return sum;
}

unsigned long long checkpoint_sum(const std::string& index, long long sequence, long long size) {
  std::uint64_t sum =
      mix(static_cast<std::uint64_t>(sequence) * 3 + 1) + mix(static_cast<std::uint64_t>(size) * 5 + 2);
  for (const char c : index) sum = mix(sum ^ static_cast<unsigned char>(c));
  return sum;
}

// Whether a record has a kind that there is, and the length of whole entries of it.
bool fits(const TermCheckpoint& kept, const CheckpointRecord& r) {
  if (r.kind < 0 || static_cast<size_t>(r.kind) >= kept.kinds.size()) return false;
  size_t size = 0;
  for (const CheckpointQuantity& q : kept.kinds[r.kind].quantities) size += static_cast<size_t>(q.components);
  return size > 0 && r.values.size() % size == 0;
}

// The array: time, scalars, node fields (node after node), then for each term the number of doubles of
// its records and the records by node: node, kind, key, length, values.
CheckpointRoom checkpoint_room(MPI_Comm comm, const Checkpoint& c, int nodes_total,
                               const std::vector<int>& owned) {
  bool valid = true;
  for (const auto& [name, field] : c.nodes)
    valid =
        valid && (field.make || field.values.size() == owned.size() * static_cast<size_t>(field.components));
  CheckpointRoom room;
  for (const auto& [name, kept] : c.records) {
    const auto look = [&, &kept = kept](const std::vector<CheckpointRecord>& records) {
      for (const auto& r : records) {
        valid = valid && std::binary_search(owned.begin(), owned.end(), r.node) && fits(kept, r);
        room.size += kRecordHead + static_cast<long long>(r.values.size());
      }
    };
    look(kept.records);
    const int some = nodes_at_a_time(nodes_total);
    for (int n = 0; kept.make && n < nodes_total; n += some) look(kept.make({n, n + some}));
  }
  room.index = describe(c, nodes_total);
  agree(comm, valid, room.index);
  all_reduce(comm, MPI_SUM, room.size);
  room.size += 1 + std::ssize(c.scalars) + std::ssize(c.records);
  for (const auto& [name, field] : c.nodes)
    room.size += nodes_total * static_cast<long long>(field.components);
  return room;
}

unsigned long long put_checkpoint(MPI_Comm comm, Checkpoint c, int nodes_total, const std::vector<int>& owned,
                                  const PutNumbers& put) {
  const int rank = rank_of(comm);
  unsigned long long sum = 0;
  const auto piece = [&](const std::vector<RowRun>& runs, const std::vector<double>& values) {
    const double* from = values.data();
    for (const RowRun& run : runs) {
      sum += checkpoint_sum(run.first, from, run.count);
      from += run.count;
    }
    put(runs, values);
  };
  std::vector<double> values{c.time};
  for (const auto& [name, value] : c.scalars) values.push_back(value);
  long long at = std::ssize(values);
  if (rank == 0)
    piece({{0, at}}, values);
  else
    piece({}, {});

  for (auto& [name, field] : c.nodes) {
    std::vector<RowRun> runs = runs_of(owned);
    for (RowRun& run : runs) {
      run.first = at + run.first * field.components;
      run.count *= field.components;
    }
    if (field.make) field.values = field.make();
    if (field.values.size() != owned.size() * static_cast<size_t>(field.components))
      throw std::logic_error("checkpoint: " + name + " has the wrong size");
    piece(runs, field.values);
    at += nodes_total * static_cast<long long>(field.components);
    field = {};
  }

  for (auto& [name, kept] : c.records) {
    const long long head = at++;
    const int some = nodes_at_a_time(nodes_total);
    for (NodeRange of{0, some}; of.first < nodes_total; of = {of.end, of.end + some}) {
      if (kept.make) kept.records = kept.make(of);
      std::vector<const CheckpointRecord*> sorted;
      for (const auto& r : kept.records)
        if (of.has(r.node)) sorted.push_back(&r);
      std::stable_sort(sorted.begin(), sorted.end(),
                       [](const CheckpointRecord* a, const CheckpointRecord* b) {
                         return std::tie(a->node, a->kind, a->key) < std::tie(b->node, b->kind, b->key);
                       });
      std::vector<long long> start(static_cast<size_t>(some) + 1,
                                   0);  // of each node's records; then their end
      for (const auto* r : sorted) start[r->node - of.first + 1] += kRecordHead + std::ssize(r->values);
      all_reduce(comm, MPI_SUM, start);
      for (size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
      std::vector<RowRun> runs;
      values.clear();
      for (const CheckpointRecord* r : sorted) {
        long long& to = start[r->node - of.first];
        const long long length = kRecordHead + std::ssize(r->values);
        if (runs.empty() || runs.back().first + runs.back().count != at + to) runs.push_back({at + to, 0});
        runs.back().count += length;
        to += length;
        values.insert(values.end(), {static_cast<double>(r->node), static_cast<double>(r->kind),
                                     static_cast<double>(r->key), static_cast<double>(r->values.size())});
        values.insert(values.end(), r->values.begin(), r->values.end());
      }
      if (start.back() > 0) piece(runs, values);
      at += start.back();
    }
    if (rank == 0)
      piece({{head, 1}}, {static_cast<double>(at - head - 1)});
    else
      piece({}, {});
    kept = {};
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, comm);
  return sum;
}

Checkpoint unpack_checkpoint(const std::string& index, const std::vector<double>& values, int nodes_total,
                             const std::vector<int>& owned) {
  const auto wrong = [] { return InputError("the checkpoint belongs to another mesh"); };
  size_t at = 0;
  const auto next = [&] { return at < values.size() ? values[at++] : throw wrong(); };
  const auto count = [&](double most) {
    const double n = next();
    if (!(n >= 0 && n <= most)) throw InputError("the checkpoint is damaged: it counts {:g}", n);
    return static_cast<size_t>(n);
  };
  Checkpoint c;
  c.time = next();
  TermCheckpoint* kept = nullptr;  // the last one named
  std::istringstream lines(index);
  for (std::string kind, name; lines >> kind;) {
    int components = 0;
    if (kind == "mesh") {
      if (!(lines >> components) || components != nodes_total) throw wrong();
      continue;
    }
    if (kind == "nodes" || kind == "quantity") lines >> components;
    lines.get();
    std::getline(lines, name);
    if (kind == "scalar") {
      c.scalars[name] = next();
    } else if (kind == "nodes") {
      const auto nc = static_cast<size_t>(components), n = nc * static_cast<size_t>(nodes_total);
      if (at + n > values.size()) throw wrong();
      auto& field = c.nodes[name];
      field.components = components;
      for (const int node : owned)
        for (size_t k = 0; k < nc; ++k)
          field.values.push_back(values[at + static_cast<size_t>(node) * nc + k]);
      at += n;
    } else if (kind == "records") {
      throw InputError("an earlier version of hawser wrote it");
    } else if (kind == "kind" && kept) {
      kept->kinds.push_back({name, {}});
    } else if (kind == "quantity" && kept && !kept->kinds.empty()) {
      const size_t tab = std::min(name.find('\t'), name.size());
      kept->kinds.back().quantities.push_back(
          {name.substr(0, tab), components, name.substr(std::min(tab + 1, name.size()))});
    } else if (kind == "history") {
      kept = &c.records[name];
      auto& list = kept->records;
      const size_t length = count(static_cast<double>(values.size()));
      const size_t end = at + length;
      while (at < end) {
        CheckpointRecord r;
        r.node = static_cast<int>(count(nodes_total - 1));
        r.kind = static_cast<int>(count(kMostKinds));
        r.key = static_cast<int>(next());
        r.values.resize(count(static_cast<double>(values.size())));
        for (double& v : r.values) v = next();
        if (std::binary_search(owned.begin(), owned.end(), r.node)) list.push_back(std::move(r));
      }
    }
  }
  if (at != values.size()) throw wrong();
  return c;
}

long long checkpoint_sequence(const std::string& path) {
  Slot newest;
  read_newest(path, newest);
  return std::max(newest.sequence, 0LL);
}

Checkpoint read_checkpoint(MPI_Comm comm, const std::string& path, int nodes_total,
                           const std::vector<int>& owned) {
  const int rank = rank_of(comm);
  Slot slot;
  std::string error;
  if (rank == 0) error = read_newest(path, slot);
  broadcast(comm, error, MPI_CHAR);
  if (!error.empty()) throw InputError(error);
  broadcast(comm, slot.index, MPI_CHAR);
  broadcast(comm, slot.values, MPI_DOUBLE);
  try {
    return unpack_checkpoint(slot.index, slot.values, nodes_total, owned);
  } catch (const InputError& e) {
    throw InputError("cannot go on from " + path + ": " + e.what());
  }
}

}  // namespace hawser::io
