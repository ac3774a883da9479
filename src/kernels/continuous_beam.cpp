// Moments of a continuous beam with settled supports by elimination in the three-moment equation.
#include "hawser/kernels/continuous_beam.hpp"

#include <cstddef>

namespace hawser {

// With f = L/EI of the spans before (i - 1) and after (i) support i and displacements u,
// M_{i-1} f_{i-1} + 2 M_i (f_{i-1} + f_i) + M_{i+1} f_i = 6 (u_{i+1} - u_i)/L_i - 6 (u_i - u_{i-1})/L_{i-1}
// and F_i = (M_{i+1} - M_i)/L_i - (M_i - M_{i-1})/L_{i-1}.
std::vector<SettlementEffect> settlement_effects(std::span<const BeamSpan> spans,
                                                 std::span<const Vec3> displacements) {
  const size_t n = displacements.size();
  std::vector<SettlementEffect> out(n);
  if (n < 3) return out;
  const auto flexibility = [&](size_t i) { return spans[i].length / spans[i].EI; };
  const auto slope = [&](size_t i) -> Vec3 {
    return (displacements[i + 1] - displacements[i]) / spans[i].length;
  };
  std::vector<double> diagonal(n, 1);
  for (size_t i = 1; i + 1 < n; ++i) {
    const double before = flexibility(i - 1);
    diagonal[i] = 2 * (before + flexibility(i));
    out[i].moment = 6 * (slope(i) - slope(i - 1));
    if (i == 1) continue;
    const double factor = before / diagonal[i - 1];
    diagonal[i] -= factor * before;
    out[i].moment -= factor * out[i - 1].moment;
  }
  for (size_t i = n - 2; i > 0; --i)
    out[i].moment = (out[i].moment - flexibility(i) * out[i + 1].moment) / diagonal[i];
  for (size_t i = 0; i + 1 < n; ++i) {
    const Vec3 shear = (out[i + 1].moment - out[i].moment) / spans[i].length;
    out[i].force += shear;
    out[i + 1].force -= shear;
  }
  return out;
}

}  // namespace hawser
