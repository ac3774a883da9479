// Packing of a checkpoint into one array of numbers with an index and a checksum.
#include "hawser/io/checkpoint.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "hawser/base/mpi.hpp"

namespace hawser::io {

namespace {

// Finaliser of MurmurHash3, 64 bits: every input bit affects every output bit.
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
    out << "term " << term << '\n';
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
  // All ranks have the same hash if and only if the largest hash and the largest complement match.
  std::uint64_t extremes[3] = {hash, ~hash, valid ? 0u : 1u};
  MPI_Allreduce(MPI_IN_PLACE, extremes, 3, MPI_UINT64_T, MPI_MAX, comm);
  if (extremes[0] != ~extremes[1]) throw std::logic_error("checkpoint: names differ between ranks");
  if (extremes[2]) throw std::logic_error("checkpoint: values do not belong to the owned nodes");
}

// Parts in which each rank passes the records of its nodes, equally many on all ranks: few, because terms
// scan all their records for each.
int checkpoint_parts(int nodes_total) {
  constexpr int kMost = 16, kFewestNodes = 500;
  return std::min(kMost, nodes_total / kFewestNodes + 1);
}

// Part k: nodes of other ranks that it includes have no records on this rank.
NodeRange nodes_of_part(const std::vector<int>& owned, int k, int parts) {
  constexpr int kLast = std::numeric_limits<int>::max();
  const auto begin = [&](int i) {
    if (i == 0) return 0;
    const size_t at = owned.size() * static_cast<size_t>(i) / static_cast<size_t>(parts);
    return at < owned.size() ? owned[at] : kLast;
  };
  return {begin(k), begin(k + 1)};
}

// Numbers of a record in the array.
long long length_of(const CheckpointRecord& r) {
  return kCheckpointRecordHead + static_cast<long long>(r.values.size());
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

// True if the kind of the record exists and the length is a multiple of its entries.
bool fits(const TermCheckpoint& kept, const CheckpointRecord& r) {
  if (r.kind < 0 || static_cast<size_t>(r.kind) >= kept.kinds.size()) return false;
  size_t size = 0;
  for (const CheckpointQuantity& q : kept.kinds[r.kind].quantities) size += static_cast<size_t>(q.components);
  return size > 0 && r.values.size() % size == 0;
}

// Layout of the array: time, scalars, node fields (node after node), then for each term the number of doubles
// of its records, the records by node (node, kind, key, length, values) and, if there are any, for each node
// the offset of its records, so that a rank need not read the records of other nodes.
CheckpointRoom checkpoint_room(MPI_Comm comm, const Checkpoint& c, int nodes_total,
                               const std::vector<int>& owned) {
  bool valid = true;
  for (const auto& [name, field] : c.nodes)
    valid =
        valid && (field.make || field.values.size() == owned.size() * static_cast<size_t>(field.components));
  CheckpointRoom room;
  std::vector<long long> of_term;
  for (const auto& [name, kept] : c.records) {
    long long& size = of_term.emplace_back(0);
    std::vector<int>& lengths = room.lengths.emplace_back(owned.size(), 0);
    const auto count_records = [&, &kept = kept](const std::vector<CheckpointRecord>& records) {
      for (const auto& r : records) {
        const auto at = std::ranges::lower_bound(owned, r.node);
        valid = valid && at != owned.end() && *at == r.node && fits(kept, r);
        if (!valid) return;
        lengths[static_cast<size_t>(at - owned.begin())] += static_cast<int>(length_of(r));
        size += length_of(r);
      }
    };
    count_records(kept.records);
    const int parts = checkpoint_parts(nodes_total);
    for (int k = 0; kept.make && k < parts; ++k) count_records(kept.make(nodes_of_part(owned, k, parts)));
  }
  room.index = describe(c, nodes_total);
  agree(comm, valid, room.index);
  all_reduce(comm, MPI_SUM, of_term);
  room.size = 1 + std::ssize(c.scalars);
  for (const long long size : of_term) room.size += 1 + size + (size > 0 ? nodes_total : 0);
  for (const auto& [name, field] : c.nodes)
    room.size += nodes_total * static_cast<long long>(field.components);
  return room;
}

namespace {

// Passes the array of a checkpoint in pieces, and sums it up. Each function is collective.
class CheckpointWriter {
 public:
  CheckpointWriter(MPI_Comm comm, int nodes_total, const std::vector<int>& owned, const PutNumbers& put)
      : comm_(comm), nodes_total_(nodes_total), owned_(owned), put_(put) {}

  void put_scalars(const Checkpoint& c) {
    std::vector<double> values{c.time};
    for (const auto& [name, value] : c.scalars) values.push_back(value);
    put_from_root(0, values);
    at_ = std::ssize(values);
  }

  void put_field(const std::string& name, CheckpointField& field) {
    if (field.make) field.values = field.make();
    if (field.values.size() != owned_.size() * static_cast<size_t>(field.components))
      throw std::logic_error("checkpoint: " + name + " has the wrong size");
    put_by_node(field.values, field.components);
  }

  // The number of doubles of the records comes before them.
  void put_records(TermCheckpoint& kept, const std::vector<int>& lengths) {
    const long long head = at_++;
    std::vector<double> begins(lengths.begin(), lengths.end());
    const long long all = lengths_to_begins(begins);
    put_from_root(head, {static_cast<double>(all)});
    if (all == 0) return;
    const int parts = checkpoint_parts(nodes_total_);
    for (int k = 0; k < parts; ++k) {
      const NodeRange range = nodes_of_part(owned_, k, parts);
      if (kept.make) kept.records = kept.make(range);
      put_records_of(range, kept.records, begins);
    }
    at_ += all;
    put_by_node(begins, 1);
  }

  unsigned long long checksum() const {
    unsigned long long sum = sum_;
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, comm_);
    return sum;
  }

 private:
  // Replaces the lengths of the records of nodes by their offsets among those of all ranks; returns the sum
  // over all ranks. Ranks exchange a sum for each run of consecutive nodes.
  long long lengths_to_begins(std::vector<double>& of_nodes) const {
    struct RunOfNodes {
      long long first = 0, length = 0;
    };
    std::vector<RunOfNodes> runs;
    const std::vector<RowRun> owned_runs = runs_of(owned_);
    size_t n = 0;
    for (const RowRun& run : owned_runs) {
      RunOfNodes& out = runs.emplace_back(RunOfNodes{run.first, 0});
      for (const size_t end = n + static_cast<size_t>(run.count); n < end; ++n) {
        const auto length = static_cast<long long>(of_nodes[n]);
        of_nodes[n] = static_cast<double>(out.length);
        out.length += length;
      }
    }
    std::vector<RunOfNodes> all = gather_all(comm_, runs);
    std::ranges::sort(all, {}, &RunOfNodes::first);
    long long sum = 0;
    for (RunOfNodes& run : all) run.length = std::exchange(sum, sum + run.length);  // from here on its offset
    n = 0;
    for (const RowRun& run : owned_runs) {
      const auto begin =
          static_cast<double>(std::ranges::lower_bound(all, run.first, {}, &RunOfNodes::first)->length);
      for (const size_t end = n + static_cast<size_t>(run.count); n < end; ++n) of_nodes[n] += begin;
    }
    return sum;
  }

  // Records of a range of nodes, by node, kind and key. begins: offset of the first record of each owned
  // node.
  void put_records_of(NodeRange range, const std::vector<CheckpointRecord>& records,
                      const std::vector<double>& begins) {
    const std::vector<const CheckpointRecord*> sorted = sorted_records(range, records);
    long long size = 0;
    for (const CheckpointRecord* r : sorted) size += length_of(*r);
    std::vector<double> values;
    values.reserve(static_cast<size_t>(size));
    std::vector<RowRun> runs;
    int node = -1;
    long long to = 0;
    for (const CheckpointRecord* r : sorted) {
      if (r->node != node) {
        node = r->node;
        to = at_ + static_cast<long long>(begins[place_of(node)]);
      }
      const long long length = length_of(*r);
      if (runs.empty() || runs.back().first + runs.back().count != to) runs.push_back({to, 0});
      runs.back().count += length;
      to += length;
      values.insert(values.end(), {static_cast<double>(r->node), static_cast<double>(r->kind),
                                   static_cast<double>(r->key), static_cast<double>(r->values.size())});
      values.insert(values.end(), r->values.begin(), r->values.end());
    }
    put_piece(runs, values);
  }

  size_t place_of(int owned_node) const {
    return static_cast<size_t>(std::ranges::lower_bound(owned_, owned_node) - owned_.begin());
  }

  static std::vector<const CheckpointRecord*> sorted_records(NodeRange range,
                                                             const std::vector<CheckpointRecord>& records) {
    std::vector<const CheckpointRecord*> sorted;
    for (const CheckpointRecord& r : records)
      if (range.has(r.node)) sorted.push_back(&r);
    std::ranges::stable_sort(sorted, {}, [](const CheckpointRecord* r) { return checkpoint_place(*r); });
    return sorted;
  }

  void put_by_node(const std::vector<double>& values, int components) {
    std::vector<RowRun> runs = runs_of(owned_);
    for (RowRun& run : runs) {
      run.first = at_ + run.first * components;
      run.count *= components;
    }
    put_piece(runs, values);
    at_ += nodes_total_ * static_cast<long long>(components);
  }

  void put_from_root(long long first, const std::vector<double>& values) {
    if (rank_of(comm_) == 0)
      put_piece({{first, std::ssize(values)}}, values);
    else
      put_piece({}, {});
  }

  void put_piece(const std::vector<RowRun>& runs, const std::vector<double>& values) {
    const double* from = values.data();
    for (const RowRun& run : runs) {
      sum_ += checkpoint_sum(run.first, from, run.count);
      from += run.count;
    }
    put_(runs, values);
  }

  MPI_Comm comm_;
  int nodes_total_;
  const std::vector<int>& owned_;
  const PutNumbers& put_;
  long long at_ = 0;  // offset of what comes next in the array
  unsigned long long sum_ = 0;
};

}  // namespace

unsigned long long write_checkpoint_array(MPI_Comm comm, Checkpoint c, const CheckpointRoom& room,
                                          int nodes_total, const std::vector<int>& owned,
                                          const PutNumbers& put) {
  CheckpointWriter writer(comm, nodes_total, owned, put);
  writer.put_scalars(c);
  for (auto& [name, field] : c.nodes) {
    writer.put_field(name, field);
    field = {};
  }
  auto lengths = room.lengths.begin();
  for (auto& [name, kept] : c.records) {
    writer.put_records(kept, *lengths++);
    kept = {};
  }
  return writer.checksum();
}

}  // namespace hawser::io
