// What of two lines touches in the accepted state, for the clash report.
#include <algorithm>
#include <cmath>

#include "hawser/mesh/arc.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

void reach(double& from, double& to, double arc) { from = std::min(from, arc), to = std::max(to, arc); }

}  // namespace

void LinePairs::touches(Touches& out) const {
  const Mesh& mesh = *mesh_.mesh;
  for (const Pair& pair : pairs_) {
    if (!pair.counted || !pair.history) continue;
    const Element &a = element(pair.key.first), &b = element(pair.key.second);
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
