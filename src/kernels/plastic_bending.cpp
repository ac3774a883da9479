// The class PlasticBending: springs from the slopes of a polyline, their radial return, and placement of the
// rows on a smooth curve.
#include "hawser/kernels/plastic_bending.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {

PlasticBending::PlasticBending(std::span<const Row> rows) {
  double c = 0, m = 0, before = HUGE_VAL;
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto [c_next, m_next] = rows[i];
    if (!(c_next > c && m_next > m))
      throw std::invalid_argument("row " + std::to_string(i + 1) + " does not rise");
    const double slope = (m_next - m) / (c_next - c);
    if (slope > before * (1 + 1e-9))
      throw std::invalid_argument("row " + std::to_string(i + 1) + " makes the curve steeper than before");
    if (i == 0) initial_ = slope;
    if (i > 0) springs_.push_back({std::max(before - slope, 0.0), c});
    c = c_next;
    m = m_next;
    before = slope;
  }
  if (springs_.empty()) throw std::invalid_argument("at least two rows are needed");
  hardening_ = before;
}

// M = k_inf kappa + sum k_i e_i,  e_i = kappa - kappa_i^p,  |e_i| <= y_i (docs/theory/plastic-bending.md).
BendingMoment PlasticBending::at(double c2, double c3, const double* set) const {
  BendingMoment o;
  o.m[0] = hardening_ * c2;
  o.m[1] = hardening_ * c3;
  o.energy = 0.5 * hardening_ * (c2 * c2 + c3 * c3);
  o.K[0][0] = o.K[1][1] = hardening_;
  for (const Spring& s : springs_) {
    const double e2 = c2 - (set ? set[0] : 0);
    const double e3 = c3 - (set ? set[1] : 0);
    const double e = std::hypot(e2, e3);
    if (set) set += 2;
    if (e <= s.yield) {
      o.m[0] += s.stiffness * e2;
      o.m[1] += s.stiffness * e3;
      o.K[0][0] += s.stiffness;
      o.K[1][1] += s.stiffness;
      o.energy += 0.5 * s.stiffness * e * e;
      continue;
    }
    // On the yield circle only the component normal to the direction has stiffness.
    const double secant = s.stiffness * s.yield / e;
    const double n2 = e2 / e;
    const double n3 = e3 / e;
    o.m[0] += secant * e2;
    o.m[1] += secant * e3;
    o.K[0][0] += secant * n3 * n3;
    o.K[1][1] += secant * n2 * n2;
    o.K[0][1] -= secant * n2 * n3;
    o.energy += 0.5 * s.stiffness * s.yield * s.yield;
  }
  o.K[1][0] = o.K[0][1];
  return o;
}

double PlasticBending::bend(double c2, double c3, double* set) const {
  double dissipated = 0;
  for (const Spring& s : springs_) {
    const double e2 = c2 - set[0];
    const double e3 = c3 - set[1];
    const double e = std::hypot(e2, e3);
    const double beyond = e - s.yield;
    if (beyond > 0) {
      set[0] += beyond * e2 / e;
      set[1] += beyond * e3 / e;
      dissipated += s.stiffness * s.yield * beyond;
    }
    set += 2;
  }
  return dissipated;
}

std::pair<double, double> PlasticBending::residual(const double* set) const {
  double r2 = 0, r3 = 0;
  for (const Spring& s : springs_) {
    r2 += s.stiffness * set[0];
    r3 += s.stiffness * set[1];
    set += 2;
  }
  return {r2 / initial_, r3 / initial_};
}

std::vector<PlasticBending::Row> ramberg_osgood(double EI, double yield_moment, double A, double B,
                                                double last, int rows) {
  const double yield = yield_moment / EI;  // 1/m
  const auto curvature = [&](double m) {
    return yield * (m + A * std::pow(m, B));
  };  // m: relative to the yield moment
  double largest = 1;
  while (curvature(largest) < last) largest *= 2;
  for (double low = 0; largest - low > 1e-12 * largest;) {
    const double middle = 0.5 * (low + largest);
    (curvature(middle) < last ? low : largest) = middle;
  }
  // A chord of length h has the error M'' h²/8 for a curve with the second derivative M'': equal parts of the
  // integral of sqrt(M''/M) give equal relative errors of the moment.
  constexpr int kFine = 4000;
  std::vector<double> at, sum;
  for (int k = 0; k <= kFine; ++k) {
    const double m = largest * k / kFine;
    const double slope = yield * (1 + A * B * std::pow(m, B - 1));
    const double bend = yield * A * B * (B - 1) * std::pow(m, B - 2);  // of the curvature by the moment
    const double density = k == 0 ? 0 : std::sqrt(bend / (slope * m));
    sum.push_back(k == 0 ? 0 : sum.back() + density);
    at.push_back(m);
  }
  std::vector<PlasticBending::Row> out;
  for (int r = 1; r <= rows; ++r) {
    const double target = sum.back() * r / rows;
    const auto after = std::lower_bound(sum.begin(), sum.end(), target);
    const double m = at[std::min<std::ptrdiff_t>(after - sum.begin(), kFine)];
    if (out.empty() || m * yield_moment > out.back().second) out.emplace_back(curvature(m), m * yield_moment);
  }
  return out;
}

}  // namespace hawser
