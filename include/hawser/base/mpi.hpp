// Reductions and gathers over ranks. A GatherPlan exchanges lengths once and values as often as needed.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hawser/base/error.hpp"

namespace hawser {

inline int rank_of(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}
inline int ranks_of(MPI_Comm comm) {
  int size = 1;
  MPI_Comm_size(comm, &size);
  return size;
}

template <class T>
MPI_Datatype mpi_type() {
  if constexpr (std::is_same_v<T, double>) return MPI_DOUBLE;
  if constexpr (std::is_same_v<T, int>) return MPI_INT;
  if constexpr (std::is_same_v<T, char>) return MPI_CHAR;
  static_assert(std::is_same_v<T, double> || std::is_same_v<T, int> || std::is_same_v<T, char> ||
                std::is_same_v<T, long long>);
  return MPI_LONG_LONG;
}

// True if ranks may send a T as its bytes: numbers and Eigen's fixed-size vectors, also in structs, arrays
// and std::optional; no pointers. (std::is_trivially_copyable is too strict: Eigen 3.4 writes copy
// constructors.)
template <class T>
inline constexpr bool is_plain_data = std::is_standard_layout_v<T>&& std::is_trivially_destructible_v<T>;

// The type of T in messages: of a number MPI's own, of other plain data its bytes.
template <class T>
class MessageType {
 public:
  MessageType() {
    static_assert(is_plain_data<T>);
    if constexpr (std::is_arithmetic_v<T>) {
      type_ = mpi_type<T>();
    } else {
      MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type_);
      MPI_Type_commit(&type_);
    }
  }
  ~MessageType() {
    if constexpr (!std::is_arithmetic_v<T>) MPI_Type_free(&type_);
  }
  MessageType(const MessageType&) = delete;
  MessageType& operator=(const MessageType&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

// Puts together what the ranks have by MPI_SUM, MPI_MAX or MPI_MIN, in place: a number, or each of an array.
// Collective.
template <class T>
T& all_reduce(MPI_Comm comm, MPI_Op op, T& values) {
  if constexpr (std::is_arithmetic_v<T>) {
    MPI_Allreduce(MPI_IN_PLACE, &values, 1, mpi_type<T>(), op, comm);
  } else {
    const MPI_Datatype type = mpi_type<std::remove_reference_t<decltype(*std::data(values))>>();
    MPI_Allreduce(MPI_IN_PLACE, std::data(values), static_cast<int>(std::size(values)), type, op, comm);
  }
  return values;
}

// Numbers of several origins that one reduction replaces by their maxima over the ranks.
class RankMax {
 public:
  // The number must outlive reduce().
  void add(double& number) { numbers_.push_back(&number); }
  // Collective; all ranks have added equally many.
  void reduce(MPI_Comm comm) {
    std::vector<double> maxima;
    for (const double* number : numbers_) maxima.push_back(*number);
    all_reduce(comm, MPI_MAX, maxima);
    for (std::size_t i = 0; i < maxima.size(); ++i) *numbers_[i] = maxima[i];
  }

 private:
  std::vector<double*> numbers_;
};

// True if `local` is true on any rank. Collective.
inline bool on_any_rank(MPI_Comm comm, bool local) {
  int yes = local;
  return all_reduce(comm, MPI_MAX, yes) != 0;
}

// Text of the first rank with one; empty: none. Collective.
inline std::string first_text(MPI_Comm comm, std::string text) {
  int first = text.empty() ? ranks_of(comm) : rank_of(comm);
  if (all_reduce(comm, MPI_MIN, first) == ranks_of(comm)) return {};
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, first, comm);
  text.resize(length);
  MPI_Bcast(text.data(), length, MPI_CHAR, first, comm);
  return text;
}

// Runs `work` on each rank. All ranks throw the InputError of the first rank that has one. Collective.
template <class Work>
void on_each_rank(MPI_Comm comm, const Work& work) {
  std::string text;
  try {
    work();
  } catch (const InputError& e) {
    text = e.what();
  }
  text = first_text(comm, std::move(text));
  if (!text.empty()) throw InputError(text);
}

// Runs `work` on rank 0 only. All ranks throw its InputError. Collective.
template <class Work>
void on_root(MPI_Comm comm, const Work& work) {
  on_each_rank(comm, [&] {
    if (rank_of(comm) == 0) work();
  });
}

// Broadcasts the data of the rank with the largest value (the first of equal ones) if that is above
// `threshold`; returns whether it is. T: plain data. Collective.
template <class T>
bool broadcast_largest(MPI_Comm comm, double value, double threshold, T& data) {
  struct {
    double value;
    int rank;
  } largest{value, rank_of(comm)};
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm);
  if (!(largest.value > threshold)) return false;
  MPI_Bcast(&data, sizeof data, MPI_BYTE, largest.rank, comm);
  return true;
}

// For each of several items, the data of the rank with its largest value, on all ranks; of equal values those
// of the smallest order. T: plain data. Collective: one reduction for all items.
template <class T, class Value>
void largest_of_ranks(MPI_Comm comm, std::vector<T>& data, const Value& value, int order) {
  if (ranks_of(comm) == 1) return;
  struct Ranked {
    double value;
    int order;
    T data;
  };
  const auto put_larger = [](void* in, void* inout, int* n, MPI_Datatype*) {
    const Ranked* a = static_cast<const Ranked*>(in);
    Ranked* b = static_cast<Ranked*>(inout);
    for (int i = 0; i < *n; ++i)
      if (a[i].value > b[i].value || (a[i].value == b[i].value && a[i].order < b[i].order)) b[i] = a[i];
  };
  std::vector<Ranked> all;
  for (const T& item : data) all.push_back({value(item), order, item});
  MPI_Op larger = MPI_OP_NULL;
  MPI_Op_create(put_larger, 1, &larger);
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MessageType<Ranked>(), larger, comm);
  MPI_Op_free(&larger);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = all[i].data;
}
template <class T, class Value>
void largest_of_ranks(MPI_Comm comm, std::vector<T>& data, const Value& value) {
  largest_of_ranks(comm, data, value, rank_of(comm));
}

class GatherPlan {
 public:
  // local_count: number of values of this rank. Collective.
  GatherPlan(MPI_Comm comm, int local_count) : comm_(comm), local_count_(local_count) {
    count_.resize(ranks_of(comm));
    start_.resize(count_.size() + 1, 0);
    MPI_Allgather(&local_count, 1, MPI_INT, count_.data(), 1, MPI_INT, comm);
    std::inclusive_scan(count_.begin(), count_.end(), start_.begin() + 1);
  }

  std::size_t all() const { return static_cast<std::size_t>(start_.back()); }
  // Offset of each rank's values; the last entry is all().
  const std::vector<int>& starts() const { return start_; }

  // local: local_count values of this rank; out gets all(), rank by rank. T: plain data. Collective.
  template <class T>
  void gather(const T* local, std::vector<T>& out) const {
    const MessageType<T> type;
    out.resize(all());
    MPI_Allgatherv(local, local_count_, type, out.data(), count_.data(), start_.data(), type, comm_);
  }
  // The same on rank 0 only; empty on the others.
  template <class T>
  void gather_on_first(const T* local, std::vector<T>& out) const {
    const MessageType<T> type;
    out.resize(rank_of(comm_) == 0 ? all() : 0);
    MPI_Gatherv(local, local_count_, type, out.data(), count_.data(), start_.data(), type, 0, comm_);
  }

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
  int local_count_ = 0;
  std::vector<int> count_, start_;
};

// Items of all ranks, in the order of the ranks. T: plain data. Collective.
template <class T>
std::vector<T> gather_all(MPI_Comm comm, const std::vector<T>& local) {
  std::vector<T> out;
  GatherPlan(comm, static_cast<int>(local.size())).gather(local.data(), out);
  return out;
}

}  // namespace hawser
