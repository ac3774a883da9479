// What a checkpoint stores of a term's committed history: numbers with names and units, so that a record of
// another version with another layout is detected and not misread.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct CheckpointQuantity {
  std::string name;
  int components = 1;
  std::string unit;
  bool operator==(const CheckpointQuantity&) const = default;
};

// The contents of all records of a kind.
struct CheckpointKind {
  std::string name;
  std::vector<CheckpointQuantity> quantities;
  bool operator==(const CheckpointKind&) const = default;
};

// A piece of a term's committed history that belongs to a node.
struct CheckpointRecord {
  int node = 0;                // mesh node (file order)
  int key = 0;                 // distinguishes the term's records of a node (for example by the volume)
  std::vector<double> values;  // the quantities of its kind, for one entry or for several in sequence
  int kind = 0;                // index into the term's kinds
};

// A checkpoint has the records of a term in ascending order of this place.
inline std::tuple<int, int, int> checkpoint_place(const CheckpointRecord& r) {
  return {r.node, r.kind, r.key};
}

// Nodes of the mesh from `first` to before `end`.
struct NodeRange {
  int first = 0;
  int end = std::numeric_limits<int>::max();
  bool has(int node) const { return node >= first && node < end; }
};

// A type declares its quantities once, in the function
//   template <class Self, class Each> static void quantities(Self& self, Each&& each) {
//     each("slip", "m", self.slip), each("touches", "", self.touches);
//   }
// They are numbers, flags, vectors and arrays of two numbers. The functions below derive from it.

template <class T>
CheckpointKind checkpoint_kind(std::string name) {
  CheckpointKind kind{std::move(name), {}};
  T one{};
  T::quantities(one, [&kind](const char* quantity, const char* unit, const auto& value) {
    using V = std::remove_cvref_t<decltype(value)>;
    int components = 1;
    if constexpr (!std::is_arithmetic_v<V>) components = static_cast<int>(std::size(value));
    kind.quantities.push_back({quantity, components, unit});
  });
  return kind;
}

// Adds an entry to the values of a record.
template <class T>
void put(const T& entry, std::vector<double>& values) {
  T::quantities(entry, [&values](const char*, const char*, const auto& value) {
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
      values.push_back(static_cast<double>(value));
    else
      values.insert(values.end(), std::begin(value), std::end(value));
  });
}

template <class T>
CheckpointRecord record_of(int node, int key, const T& entry, int kind = 0) {
  CheckpointRecord r{node, key, {}, kind};
  put(entry, r.values);
  return r;
}

// The entries of a record. Throws std::invalid_argument if its length is no multiple of an entry's.
template <class T>
std::vector<T> entries(const CheckpointRecord& record) {
  std::vector<T> all;
  std::size_t at = 0;
  const auto next = [&] {
    if (at == record.values.size()) throw std::invalid_argument("a record of the checkpoint is truncated");
    return record.values[at++];
  };
  while (at < record.values.size())
    T::quantities(all.emplace_back(), [&next](const char*, const char*, auto& value) {
      using V = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_same_v<V, bool>)
        value = next() != 0;
      else if constexpr (std::is_arithmetic_v<V>)
        value = static_cast<V>(next());
      else
        for (double& c : value) c = next();
    });
  return all;
}

// The only entry of a record. Throws std::invalid_argument if there is not exactly one.
template <class T>
T entry(const CheckpointRecord& record) {
  std::vector<T> all = entries<T>(record);
  if (all.size() != 1) throw std::invalid_argument("a record of the checkpoint has the wrong size");
  return all.front();
}

// The record of a node with this key and kind among records in the order of a checkpoint; null if there is
// none.
inline const CheckpointRecord* find_record(const std::vector<CheckpointRecord>& records, int node,
                                           int key = 0, int kind = 0) {
  const std::tuple place{node, kind, key};
  const auto at = std::ranges::lower_bound(records, place, {}, checkpoint_place);
  return at != records.end() && checkpoint_place(*at) == place ? &*at : nullptr;
}

// The only entry of that record. Throws as entry() does.
template <class T>
std::optional<T> find_entry(const std::vector<CheckpointRecord>& records, int node, int key = 0,
                            int kind = 0) {
  const CheckpointRecord* r = find_record(records, node, key, kind);
  return r ? std::optional(entry<T>(*r)) : std::nullopt;
}

// Work as the only quantity, for terms without a type of their own.
struct WorkDone {
  double work = 0;  // J
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("work", "J", self.work);
  }
};

}  // namespace hawser
