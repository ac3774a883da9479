// The implicit speed law of a winch: a scalar equation that grows with its unknown, by Newton's method
// between bounds.
#include "hawser/kernels/feed.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr int kMost = 200;  // iterations

// Strain at which the elastic tension is T.
double strain_at(const CableSection& s, double T) {
  double low = 0, high = T / s.EA;
  if (!s.tension) return high;
  while (s.axial(high).force < T && high < 1e3) high *= 2;
  for (int i = 0; i < kMost && high - low > 1e-16 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (s.axial(middle).force < T ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

FedElement feed_step(const CableSection& s, const FeedLaw& law, double from, double h, double chord) {
  if (law.resting || !(h > 0)) return {from, 0};
  const double reach = law.max_speed > 0 ? h * law.max_speed : HUGE_VAL;
  if (law.per_tension == 0) {
    const double stretch = 1 + s.free_strain + strain_at(s, law.tension), L = chord / stretch;
    if (std::abs(L - from) > reach) return {from + std::copysign(reach, L - from), 0};
    return {L, 1 / stretch};
  }
  // g(L) = L - from - h v: the tension falls and g grows with L.
  const double k = h * law.per_tension;
  struct At {
    double g, slope, by_chord;
  };
  const auto at = [&](double L) {
    const double strain = chord / L - 1 - s.free_strain;
    const StiffnessTable::Value axial = strain > 0 ? s.axial(strain) : StiffnessTable::Value{0, 0, 0};
    const double out = k * (axial.force - law.tension);
    if (std::abs(out) > reach) return At{L - from - std::copysign(reach, out), 1, 0};
    return At{L - from - out, 1 + k * axial.slope * chord / (L * L), k * axial.slope / L};
  };
  double low = std::max(1e-6 * from, from - std::min(k * law.tension, reach));
  double high = std::max(from, low);
  while (at(high).g < 0) high += std::max(0.1 * from, std::min(reach, from));
  double L = std::clamp(from, low, high);
  At here = at(L);
  for (int i = 0; i < kMost && high - low > 2e-16 * high; ++i) {
    if (here.g == 0) break;
    (here.g > 0 ? high : low) = L;
    const double newton = L - here.g / here.slope;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - L) <= 1e-16 * L) break;
    L = next, here = at(L);
  }
  return {L, here.by_chord / here.slope};
}

}  // namespace hawser
