// The class Stations: material at the stations of a feeder, from the length paid out.
#include "hawser/record/stations.hpp"

#include <algorithm>
#include <ranges>
#include <utility>

#include "hawser/base/mpi.hpp"

namespace hawser::record {
Stations::Stations(MPI_Comm comm, const LocalMesh& mesh, const Feeders* feeders,
                   const std::vector<io::ResultField>& fields)
    : comm_(comm), mesh_(mesh), feeders_(feeders) {
  if (!feeders) return;
  for (size_t f = 0; f < fields.size(); ++f) {
    if (!fields[f].at_stations) continue;
    fields_.push_back({.name = fields[f].name + "_at_stations", .unit = fields[f].unit, .statistics = true});
    place_.push_back(f);
  }
  values_.assign(fields_.size(), std::vector<double>(static_cast<size_t>(mesh.owned), std::nan("")));
  const LineOwners lines = line_owners(mesh);
  cut_lines_ = lines.cut;
  for (const Feeder& f : feeders->all()) {
    if (!std::ranges::binary_search(lines.local, f.line) || arcs_.contains(f.line)) continue;
    const LineSpan& span = mesh.mesh->lines[f.line];
    std::vector<double>& arcs = arcs_[f.line];
    for (int i = 0; i < span.nodes; ++i) arcs.push_back(mesh.mesh->node(span.first_node + i).arc);
  }
}

const std::vector<std::vector<double>>& Stations::at(const std::vector<std::vector<double>>& values) {
  if (!feeders_) return values_;
  int line = -1;
  for (const Feeder& f : feeders_->all())  // end A before end B
    if (std::exchange(line, f.line) != f.line) fill(f, values);
  return values_;
}

void Stations::fill(const Feeder& f, const std::vector<std::vector<double>>& values) {
  const LineSpan& span = mesh_.mesh->lines[f.line];
  const size_t nodes = span.nodes;
  // Values of all nodes of the line, in order. If ranks share the line, each gets the values of all of them.
  std::vector<double> along(fields_.size() * nodes, 0);
  for (size_t n = 0; n < static_cast<size_t>(mesh_.owned); ++n)
    if (const int i = mesh_.global[n] - span.first_node; i >= 0 && i < span.nodes)
      for (size_t k = 0; k < place_.size(); ++k)
        along[k * nodes + static_cast<size_t>(i)] = values[place_[k]][n];
  if (std::ranges::binary_search(cut_lines_, f.line)) all_reduce(comm_, MPI_SUM, along);
  const auto arcs = arcs_.find(f.line);
  if (arcs == arcs_.end()) return;

  const auto arc = [&](int i) { return arcs->second[i]; };
  // Free nodes, or an end without feeder.
  int first = 0;
  int last = span.nodes - 1;
  double from = 0;
  double to = span.length;                   // m, arc lengths at the feeders
  for (const Feeder& o : feeders_->all()) {  // both, if the line is fed at both ends
    if (o.line != f.line) continue;
    const int free = o.line_end == LineEnd::B ? span.nodes - 2 - o.feed_point : o.feed_point + 1;
    (o.line_end == LineEnd::B ? last : first) = free;
    (o.line_end == LineEnd::B ? to : from) = arc(free) + (o.line_end == LineEnd::B ? o.length : -o.length);
  }
  for (size_t n = 0; n < static_cast<size_t>(mesh_.owned); ++n) {
    const int i = mesh_.global[n] - span.first_node;
    if (i < 0 || i >= span.nodes) continue;
    const double s =
        f.line_end == LineEnd::B ? to - (span.length - arc(i)) : from + arc(i);  // material at the station
    const auto free = std::views::iota(first, last);
    const int j =
        first + static_cast<int>(std::ranges::partition_point(free, [&](int m) { return arc(m) < s; }) -
                                 free.begin());  // next node
    const double length = j > first ? arc(j) - arc(j - 1) : 0;
    const double weight = length > 0 ? std::clamp((arc(j) - s) / length, 0.0, 1.0) : 0;  // of the node before
    for (size_t k = 0; k < fields_.size(); ++k) {
      const double* v = along.data() + k * nodes + j;
      const bool on_line = s >= from - 1e-9 * span.length && s <= to + 1e-9 * span.length;
      values_[k][n] = !on_line ? std::nan("") : weight > 0 ? weight * v[-1] + (1 - weight) * v[0] : v[0];
    }
  }
}

}  // namespace hawser::record
