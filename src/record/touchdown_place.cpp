// Liftoff point of a line's axis between two nodes, from their gaps and those of neighbours
// (docs/theory/seabed.md, "Touchdown points").
#include "hawser/record/touchdown_place.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::record {
namespace {

constexpr double kSame = 1e-9;  // relative tolerance of lengths
constexpr int kMostTries = 60;  // bisections halve the bracket to round-off in 53

// Zero of the cubic of two gaps with these slopes, m beyond the lying node, by bisection; the sign changes at
// least once.
double zero_of_cubic(double lying, double slope, double hanging, double next_slope, double length) {
  double low = 0, high = 1;
  for (int i = 0; i < kMostTries; ++i) {
    const double t = 0.5 * (low + high);
    const double u = 1 - t;
    const double g = u * u * ((1 + 2 * t) * lying + t * length * slope) +
                     t * t * ((1 + 2 * u) * hanging - u * length * next_slope);
    (lies(g) ? low : high) = t;
  }
  return 0.5 * (low + high) * length;
}

// Slope of the chord of two nodes relative to the bed.
double steepness(const Gap& a, const Gap& b) {
  const double rise = b.value - a.value;
  const double length2 = (b.x - a.x).squaredNorm();
  return rise / std::sqrt(std::max(length2 - rise * rise, 1e-12 * length2));
}

// Distance [m] beyond s0 up to which a line has contact with an elastic bed, from a node at distance `behind`
// before s0 and `deep` [m] below the bed: l of deep = bend l² (1 - exp(-(behind + l) / l)), which increases
// with l. Newton's iteration within a bracket.
double supported_beyond(double deep, double behind, double bend) {
  double low = std::max(0.0, -behind);
  double high = HUGE_VAL;
  if (!(deep > 0)) return low;
  double l = low + std::sqrt(deep / bend);
  double step = HUGE_VAL;
  for (int i = 0; i < kMostTries && std::abs(step) > kSame * l; ++i) {
    const double e = std::exp(-(behind + l) / l);
    const double excess = bend * l * l * (1 - e) - deep;
    (excess < 0 ? low : high) = l;
    step = -excess / (bend * (2 * l * (1 - e) - behind * e));
    const double to = l + step;
    l = to >= low && to <= high ? to : high < HUGE_VAL ? 0.5 * (low + high) : 2 * l;
  }
  return l;
}

}  // namespace

double distance_to_touchdown(const NodesAtChange& n, bool beam) {
  const double length = n.arc[2] - n.arc[1];
  if (beam) return zero_of_cubic(n.gap[1].value, n.gap[1].slope, n.gap[2].value, n.gap[2].slope, length);
  // The second hanging chord is the first without bed forces.
  for (const size_t k : {size_t{2}, size_t{1}}) {
    if (k + 2 >= n.exists.size() || !n.exists[k + 2] || n.two_sided[k + 1] || lies(n.gap[k + 2].value))
      continue;
    const double m1 = 0.5 * (n.arc[k] + n.arc[k + 1]);
    const double m2 = 0.5 * (n.arc[k + 1] + n.arc[k + 2]);
    const double t1 = steepness(n.gap[k], n.gap[k + 1]);
    const double t2 = steepness(n.gap[k + 1], n.gap[k + 2]);
    const double bend = (t2 - t1) / (m2 - m1);
    if (!(bend > 0)) continue;
    const double s0 = m1 - t1 / bend;
    // The last lying node but one, unless it is a held end.
    const size_t from = n.exists[0] && n.inner[0] && lies(n.gap[0].value) ? 0 : 1;
    const double s = s0 + supported_beyond(-n.gap[from].value, s0 - n.arc[from], bend) - n.arc[1];
    return std::clamp(s, n.exists[0] ? 0.5 * (n.arc[0] - n.arc[1]) : 0.0, length);
  }
  return zero_of_line(n.gap[1].value, n.gap[2].value, length);
}

Vec3 position_at(const NodesAtChange& n, double s) {
  const size_t k = s < 0 ? 0 : 1;  // between nodes k and k + 1
  const double t = (n.arc[1] + s - n.arc[k]) / (n.arc[k + 1] - n.arc[k]);
  return n.gap[k].x + t * (n.gap[k + 1].x - n.gap[k].x);
}

}  // namespace hawser::record
