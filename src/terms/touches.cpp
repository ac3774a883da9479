// What touches in the accepted state, told by the terms of contact of lines for the clash report.
#include <algorithm>
#include <cmath>

#include "hawser/mesh/arc.hpp"
#include "hawser/terms/line_contact.hpp"
#include "hawser/terms/line_pairs.hpp"
#include "hawser/terms/volume_contact.hpp"

namespace hawser {
namespace {

void reach(double& from, double& to, double arc) { from = std::min(from, arc), to = std::max(to, arc); }

}  // namespace

// One for each panel: panels that meet are put together where stretches are.
void LineContact::touches(Touches& out) const {
  const Mesh& mesh = *mesh_.mesh;
  for (const Pair& pair : pairs_) {
    const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
    if (!e.counted) continue;
    const Element& element = mesh.elements[static_cast<size_t>(e.global)];
    double panel = NAN;
    for (const Point& p : pair.history) {
      if (p.from != panel) {
        Touch& t = out.emplace_back();
        t.line = element.line, t.volume = pair.volume;
        t.from = arc_at(mesh, element, p.from), t.to = arc_at(mesh, element, p.to);
        panel = p.from;
      }
      Touch& t = out.back();
      t.force += p.weight * p.normal_force, t.energy += p.weight * p.potential;
      t.depth = std::max(t.depth, -p.gap);
    }
  }
}

// A node stands for half the elements beside it.
void VolumeContact::touches(Touches& out) const {
  const auto half_way = [this](int node, int beside) {
    const auto& nodes = mesh_.nodes;
    const Node& n = nodes[static_cast<size_t>(node)];
    if (beside < 0 || beside >= static_cast<int>(nodes.size())) return n.arc;
    const Node& m = nodes[static_cast<size_t>(beside)];
    return m.line == n.line ? 0.5 * (n.arc + m.arc) : n.arc;
  };
  for (const Pair& pair : pairs_) {
    if (!pair.history.touches) continue;
    const int node = global_[static_cast<size_t>(pair.node)];
    Touch& t = out.emplace_back();
    t.line = mesh_.nodes[static_cast<size_t>(node)].line, t.volume = pair.volume;
    t.from = half_way(node, node - 1), t.to = half_way(node, node + 1);
    t.force = pair.history.normal_force, t.energy = pair.history.potential, t.depth = pair.history.depth;
  }
}

void LinePairs::touches(Touches& out) const {
  const Mesh& mesh = *mesh_.mesh;
  for (const Pair& pair : pairs_) {
    if (!pair.counted || !pair.history) continue;
    const Element &a = mesh.elements[static_cast<size_t>(pair.key.first)],
                  &b = mesh.elements[static_cast<size_t>(pair.key.second)];
    Touch t;
    t.line = a.line, t.other_line = b.line;
    t.from = t.other_from = HUGE_VAL, t.to = t.other_to = -HUGE_VAL;
    for (size_t k = 0; k < kParts; ++k) {
      const bool swapped = k >= 3;
      const Element &slave = swapped ? b : a, &master = swapped ? a : b;
      double &from = swapped ? t.other_from : t.from, &to = swapped ? t.other_to : t.to;
      double &foot_from = swapped ? t.from : t.other_from, &foot_to = swapped ? t.to : t.other_to;
      const auto& points = (*pair.history)[k];
      for (const LinePairHistory& h : points) {
        reach(from, to, arc_at(mesh, slave, h.from)), reach(from, to, arc_at(mesh, slave, h.to));
        reach(foot_from, foot_to, arc_at(mesh, master, std::clamp(h.eta, 0.0, 1.0)));
        t.force += h.weight * h.normal_force, t.energy += h.weight * h.potential;
      }
      if (k % 3 == 0) t.depth = std::max(t.depth, deepest_of(points));
    }
    out.push_back(t);
  }
}

}  // namespace hawser
