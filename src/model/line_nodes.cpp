// Lengths of the elements of lines, and the nodes that are moved to what is fixed to a line.
#include "hawser/model/line_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::model {
namespace {

constexpr double kSame = 1e-9;  // of an element
constexpr double kApart = 0.1;  // of an element: nodes that are moved come no nearer to each other

// A geometric progression.
std::vector<double> plain_lengths(const Section& s) {
  std::vector<double> l(static_cast<std::size_t>(s.elements), s.length / s.elements);
  if (s.elements < 2 || s.grading == 1) return l;
  const double q = std::pow(s.grading, 1.0 / (s.elements - 1));
  double sum = 0;
  for (std::size_t i = 0; i < l.size(); ++i) sum += l[i] = std::pow(q, static_cast<double>(i));
  for (double& x : l) x *= s.length / sum;
  return l;
}

// A node with the number `first` among the section's is moved to `second`, m from its beginning.
using Moved = std::pair<std::size_t, double>;

// `at` [m]: where the section's nodes are; [from, from + at.back()] is the section.
std::vector<Moved> moved_nodes(const std::vector<double>& at, double from,
                               const std::vector<double>& places) {
  std::vector<Moved> out = {{0, 0}};
  const std::size_t last = at.size() - 1;
  bool moves = false;
  for (const double arc : places) {
    const double place = arc - from;
    const auto after = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), place) - at.begin());
    if (after == 0 || after > last) continue;
    const double element = at[after] - at[after - 1], apart = kApart * element;
    if (place - out.back().second < apart || at[last] - place < apart) continue;
    const std::size_t nearest = place - at[after - 1] < at[after] - place ? after - 1 : after;
    const std::size_t node = std::min(std::max(nearest, out.back().first + 1), last - 1);
    if (node <= out.back().first) continue;
    moves |= std::abs(at[node] - place) > kSame * element;
    out.emplace_back(node, place);
  }
  out.emplace_back(last, at[last]);
  return moves ? out : std::vector<Moved>{};
}

std::vector<double> lengths(const Section& s, double from, const std::vector<double>& places) {
  std::vector<double> l = plain_lengths(s);
  std::vector<double> at = {0};
  for (const double x : l) at.push_back(at.back() + x);
  const std::vector<Moved> moved = moved_nodes(at, from, places);
  for (std::size_t k = 1; k < moved.size(); ++k) {
    const auto [a, x] = moved[k - 1];
    const auto [b, y] = moved[k];
    for (std::size_t i = a; i < b; ++i) l[i] *= (y - x) / (at[b] - at[a]);
  }
  return l;
}

}  // namespace

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
    if (b.on) add(b.on->line, b.on->at);
  for (auto& places : out) std::sort(places.begin(), places.end());
  return out;
}

std::vector<std::vector<double>> element_lengths(const Line& line, const std::vector<double>& places) {
  std::vector<std::vector<double>> out;
  double from = 0;
  for (const Section& s : line.sections) {
    out.push_back(lengths(s, from, places));
    from += s.length;
  }
  return out;
}

}  // namespace hawser::model
