// Bending stiffness along a bend stiffener by linear interpolation, and the harmonic mean of line and
// stiffeners over the length of one beam element.
#include "hawser/model/bend_stiffener.hpp"

#include <cstddef>

namespace hawser::model {

double BendStiffener::EI(double s) const {
  const double d = towards_a ? at - s : s - at;
  if (rows.size() < 2 || d < rows.front().first || d > rows.back().first) return 0;
  std::size_t i = 1;
  while (i + 1 < rows.size() && d > rows[i].first) ++i;
  const auto& before = rows[i - 1];
  const auto& after = rows[i];
  return before.second + (d - before.first) / (after.first - before.first) * (after.second - before.second);
}

double stiffened_EI(const std::vector<BendStiffener>& stiffeners, double from, double to, double EI) {
  constexpr int kPieces = 32;  // midpoint rule; computed once per element
  double flexibility = 0;
  bool any = false;
  for (int k = 0; k < kPieces; ++k) {
    const double s = from + (k + 0.5) / kPieces * (to - from);
    double local_EI = EI;
    for (const BendStiffener& b : stiffeners) {
      const double more = b.EI(s);
      any |= more > 0;
      local_EI += more;
    }
    flexibility += 1 / local_EI;
  }
  return any ? kPieces / flexibility : EI;
}

}  // namespace hawser::model
