// Implicit speed law of a winch or tensioner: a scalar equation with a monotone left side, solved by Newton's
// method between bounds. The choice of the law and its effect on the line are in terms/feeders.cpp.
#include "hawser/kernels/feeder_law.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

// g(L) = (L - from) / (h k) - (T(L) - T0) increases with L; the first part is absent for an exact tension.
FedElement feed_step(FunctionRef<FedPull(double)> pull, const FeedLaw& law, double from, double h) {
  constexpr int kMaxIterations = 200;
  constexpr double kShortest = 1e-6;  // fraction of the length at the start
  if (!(h > 0)) return {from, 0};
  if (law.resting) {
    const double T = pull(from).force;
    if (T >= law.min_tension && T <= law.max_tension) return {from, 0};
    const FeedLaw at_edge{T > law.max_tension ? law.max_tension : law.min_tension, 0, law.max_speed, false};
    const FedElement fed = feed_step(pull, at_edge, from, h);
    if (std::abs(fed.length - from) <= h * law.per_tension * std::abs(at_edge.tension - law.tension))
      return fed;
  }
  const double resists = law.per_tension > 0 ? 1 / (h * law.per_tension) : 0;  // N/m
  struct At {
    double g, slope;
  };
  const auto at = [&](double L) {
    const FedPull p = pull(L);
    return At{resists * (L - from) - (p.force - law.tension), resists - p.slope};
  };
  const double reach = law.max_speed > 0 ? h * law.max_speed : HUGE_VAL;
  double low = std::max(kShortest * from, from - reach);
  double high = std::max(from, low);
  if (at(low).g >= 0) return {low, 0};
  while (high < from + reach && at(high).g < 0) high = std::min(2 * high, from + reach);
  if (at(high).g < 0) return {high, 0};
  double L = std::clamp(from, low, high);
  At current = at(L);
  for (int i = 0; i < kMaxIterations && current.g != 0 && high - low > 2e-16 * high; ++i) {
    (current.g > 0 ? high : low) = L;
    const double newton = L - current.g / current.slope;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - L) <= 1e-16 * L) break;
    L = next;
    current = at(L);
  }
  return {L, 1 / current.slope};
}

CableFeed cable_feed(const CableSection& s, double chord, double length, double from, double h) {
  const double strain = s.strain(chord, length);
  if (!(strain > 0)) return {};
  const ResponseCurve::Value axial = s.axial(strain);
  const double viscous = h > 0 ? s.EA * s.beta / h : 0;
  const double damper = viscous * (strain - std::max(from, 0.0));
  if (damper <= -axial.force) return {};
  const bool limited = damper >= axial.force && viscous > 0;
  const double slope = limited ? 2 * axial.slope : axial.slope + viscous;  // N, derivative by the strain
  CableFeed out;
  out.force = limited ? 2 * axial.force : axial.force + damper;
  out.slope = -slope * chord / (length * length);
  out.by_chord = slope / length;
  return out;
}

}  // namespace hawser
