// Lengths of the elements of lines, with nodes moved to the objects fixed to a line.
#include "hawser/model/line_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace hawser::model {
namespace {

constexpr double kSamePlace = 1e-9;  // fraction of the smallest distance between moved nodes
constexpr double kApart = 0.1;       // smallest distance between moved nodes, as a fraction of an element

// All elements of a section, without moved nodes.
Progression plain(const Section& s) {
  if (s.elements < 2 || s.grading == 1) return {.elements = s.elements, .length = s.length / s.elements};
  const double q = std::pow(s.grading, 1.0 / (s.elements - 1));
  double sum = 0;
  for (int i = 0; i < s.elements; ++i) sum += std::pow(q, static_cast<double>(i));
  return {.elements = s.elements, .ratio = q, .length = s.length / sum};
}

// New positions [m, from the section's beginning] by node number in the section.
using Moved = std::map<std::size_t, double>;

// `at` [m]: unmoved node positions of the section. Each place moves the nearest interior node; if two places
// need the same node, the nearer place gets it. A place too near to another moved node gets none.
Moved moved_nodes(const std::vector<double>& at, double from, const std::vector<double>& places) {
  struct NodeRequest {
    double place = 0, spacing = 0, shift = 0;
    std::size_t node = 0;
  };
  const std::size_t last = at.size() - 1;
  std::vector<NodeRequest> requests;
  for (const double arc : places) {
    const double place = arc - from;
    const auto after = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), place) - at.begin());
    if (last < 2 || after == 0 || after > last) continue;
    const std::size_t nearest = place - at[after - 1] < at[after] - place ? after - 1 : after;
    const std::size_t node = std::clamp<std::size_t>(nearest, 1, last - 1);
    requests.push_back({place, kApart * (at[after] - at[after - 1]), std::abs(at[node] - place), node});
  }
  std::stable_sort(requests.begin(), requests.end(),
                   [](const NodeRequest& a, const NodeRequest& b) { return a.shift < b.shift; });
  Moved out = {{0, 0}, {last, at[last]}};
  for (const NodeRequest& w : requests) {
    const auto next = out.lower_bound(w.node);
    if (next->first == w.node || next->second - w.place < w.spacing ||
        w.place - std::prev(next)->second < w.spacing)
      continue;
    out.emplace(w.node, w.shift > kSamePlace * w.spacing ? w.place : at[w.node]);
  }
  return out;
}

std::vector<Progression> parts(const Section& s, double from, const std::vector<double>& places) {
  const Progression all = plain(s);
  std::vector<double> at = {0};
  for (int i = 0; i < all.elements; ++i) at.push_back(at.back() + all.element_length(i));
  const Moved moved = moved_nodes(at, from, places);
  std::vector<Progression> out;
  for (auto to = std::next(moved.begin()); to != moved.end(); ++to) {
    const auto& [a, x] = *std::prev(to);
    const auto& [b, y] = *to;
    Progression part = all;
    part.index = static_cast<int>(a);
    part.elements = static_cast<int>(b - a);
    if (x != at[a] || y != at[b]) part.scale = (y - x) / (at[b] - at[a]);
    out.push_back(part);
  }
  return out;
}

}  // namespace

double Progression::element_length(int k) const {
  return (ratio == 1 ? length : std::pow(ratio, static_cast<double>(index + k)) * length) * scale;
}

std::vector<std::vector<double>> fixed_places(const Case& c) {
  std::vector<std::vector<double>> out(c.lines.size());
  for (std::size_t l = 0; l < c.lines.size(); ++l) {
    for (const PointMass& m : c.lines[l].masses) out[l].push_back(m.at);
    for (const PointLoad& p : c.lines[l].point_loads) out[l].push_back(p.at);
  }
  const auto add = [&](const std::string& line, double at) {
    out[static_cast<std::size_t>(c.line_index(line))].push_back(at);
  };
  for (const Link& l : c.links)
    for (const LinkEnd* e : {&l.end_a, &l.end_b})
      if (!e->line.empty()) add(e->line, e->arc);
  for (const Body& b : c.bodies)
    if (b.ride) add(b.ride->line, b.ride->at);
  for (auto& places : out) std::sort(places.begin(), places.end());
  return out;
}

std::vector<std::vector<Progression>> progressions(const Line& line, const std::vector<double>& places) {
  std::vector<std::vector<Progression>> out;
  double from = 0;
  for (const Section& s : line.sections) {
    out.push_back(parts(s, from, places));
    from += s.length;
  }
  return out;
}

std::vector<std::vector<double>> element_lengths(const Line& line, const std::vector<double>& places) {
  std::vector<std::vector<double>> out;
  for (const std::vector<Progression>& section : progressions(line, places)) {
    std::vector<double>& lengths = out.emplace_back();
    for (const Progression& part : section)
      for (int k = 0; k < part.elements; ++k) lengths.push_back(part.element_length(k));
  }
  return out;
}

}  // namespace hawser::model
