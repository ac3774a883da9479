// Data by line, of the lines with nodes on this rank or of a list of lines.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "hawser/base/mpi.hpp"
#include "hawser/mesh/local_mesh.hpp"

namespace hawser {

template <class T>
class PerLine {
 public:
  PerLine() = default;
  explicit PerLine(const LocalMesh& mesh, const T& first = {}) {
    LineOwners lines = line_owners(mesh);
    lines_ = std::move(lines.local);
    cut_ = std::move(lines.cut);
    values_.assign(lines_.size(), first);
  }
  // lines: ascending.
  explicit PerLine(std::vector<int> lines, const T& first = {})
      : lines_(std::move(lines)), values_(lines_.size(), first) {}

  // Ascending.
  std::span<const int> lines() const { return lines_; }
  // In the order of lines().
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }
  bool has(int line) const { return std::binary_search(lines_.begin(), lines_.end(), line); }
  // Of a line of lines().
  T& operator[](int line) { return values_[place(line)]; }
  const T& operator[](int line) const { return values_[place(line)]; }
  // Index of a line of lines().
  std::size_t place(int line) const {  // the lines of a rank are mostly consecutive
    const auto near = static_cast<std::size_t>(line - lines_.front());
    if (near < lines_.size() && lines_[near] == line) return near;
    return static_cast<std::size_t>(std::lower_bound(lines_.begin(), lines_.end(), line) - lines_.begin());
  }
  // Gives the ranks that share a line the data of the one with the largest value; that of T() is the
  // smallest. Collective.
  template <class Value>
  void take_largest(MPI_Comm comm, const Value& value) {
    if (cut_.empty()) return;
    std::vector<T> shared;
    for (const int l : cut_) shared.push_back(has(l) ? (*this)[l] : T());
    largest_of_ranks(comm, shared, value);
    for (std::size_t i = 0; i < cut_.size(); ++i)
      if (has(cut_[i])) (*this)[cut_[i]] = shared[i];
  }

 private:
  std::vector<int> lines_, cut_;
  std::vector<T> values_;
};

}  // namespace hawser
