// The rank that owns each node, by runs of consecutive nodes.
#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <vector>

#include "hawser/math/last_not_after.hpp"

namespace hawser {

class NodeRanks {
 public:
  struct Run {
    int first = 0, rank = 0;  // first node
    bool operator==(const Run&) const = default;
  };

  NodeRanks() = default;
  // One rank for each node.
  NodeRanks(const std::vector<int>& of_nodes) {
    for (const int rank : of_nodes) append(1, rank);
  }
  // Nodes of one rank.
  static NodeRanks all_of(int nodes, int rank = 0) {
    NodeRanks out;
    out.append(nodes, rank);
    return out;
  }
  // Adds nodes after those that have a rank.
  void append(int nodes, int rank) {
    if (nodes > 0 && (runs_.empty() || runs_.back().rank != rank)) runs_.push_back({nodes_, rank});
    nodes_ += nodes;
  }

  int size() const { return nodes_; }
  std::span<const Run> runs() const { return runs_; }
  // First node after a run.
  int end(size_t run) const { return run + 1 < runs_.size() ? runs_[run + 1].first : nodes_; }
  size_t run_of(int node) const {
    return static_cast<size_t>(last_not_after(runs_, node, &Run::first) - runs_.begin());
  }
  template <std::integral Index>
  int operator[](Index node) const {
    return runs_[run_of(static_cast<int>(node))].rank;
  }
  // True if one rank owns all these nodes, of which there is at least one.
  bool whole(int first, int nodes) const { return first + nodes <= end(run_of(first)); }
  std::vector<int> of_nodes() const {
    std::vector<int> out(static_cast<size_t>(nodes_));
    for (size_t r = 0; r < runs_.size(); ++r)
      std::fill(out.begin() + runs_[r].first, out.begin() + end(r), runs_[r].rank);
    return out;
  }
  bool operator==(const NodeRanks&) const = default;

 private:
  std::vector<Run> runs_;
  int nodes_ = 0;
};

}  // namespace hawser
