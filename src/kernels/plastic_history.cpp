// Parabolas through the plastic history at Gauss points, their projection onto other stretches of the
// material, and the work of a feeder on plastic bending that enters and leaves.
#include "hawser/kernels/plastic_history.hpp"

#include <algorithm>
#include <vector>

#include "beam_local.hpp"

namespace hawser {

using namespace beam_local;

std::array<RememberedCell, kBendingPlaces> remembered_cells(double from, double to, const double* values,
                                                            std::size_t n) {
  std::array<RememberedCell, kBendingPlaces> out;
  double at = from;
  for (size_t k = 0; k < kBendingPlaces; ++k) {
    const double next = k + 1 == kBendingPlaces ? to : at + kWeight[k] * (to - from);
    out[k] = {at, next, values + k * n};
    at = next;
  }
  return out;
}

void remember_cells(std::span<const RememberedCell> cells, std::size_t n, double from, double to,
                    double* out) {
  std::fill_n(out, kBendingPlaces * n, 0.0);
  for (const RememberedCell& now : remembered_cells(from, to, out, n)) {
    double* values = out + (now.values - out);
    for (const RememberedCell& old : cells) {
      const double overlap = (std::min(now.to, old.to) - std::max(now.from, old.from)) / (now.to - now.from);
      for (size_t i = 0; i < n && overlap > 0; ++i) values[i] += overlap * old.values[i];
    }
  }
}

// dU/dL = w at the feeder + the integral of M times the derivative of the material's curvature by L.
double fed_bending_work(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool second_end,
                        const double* entering) {
  Local o;
  kinematics(s, r, e, false, o);
  const size_t n = s.plastic->memory();
  const double side = second_end ? 1 : -1;
  double sum = 0;
  for (int k = 0; k < kBendingPlaces; ++k) {
    const double xi = kGauss[k];
    const Curvature c = curvature_at(s, r, o, xi);
    const BendingMoment m =
        with_memory(s, c.about2, c.about3, r.set ? r.set + static_cast<size_t>(k) * n : nullptr);
    // At constant label s = (1 + side xi) L/2, xi decreases with L by (side + xi)/L.
    const double turn = -6 * (side + xi) / s.length;
    sum += kWeight[k] * (m.m[0] * (turn * o.a3 - c.about2) - m.m[1] * (turn * o.a2 + c.about3));
  }
  const Curvature c = curvature_at(s, r, o, side);
  std::vector<double> set(n, 0.0);
  double dissipated = 0;
  if (entering)
    std::copy_n(entering, n, set.begin());
  else if (r.set)
    std::copy_n(r.set + (second_end ? kBendingPlaces - 1 : 0) * n, n, set.begin());
  const double stored = with_memory(s, c.about2, c.about3, set.data()).energy;
  if (entering) dissipated = s.plastic->bend(c.about2, c.about3, set.data());
  return sum + stored + dissipated;
}

}  // namespace hawser
