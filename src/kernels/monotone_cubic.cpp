// Slopes at the rows that make a piecewise cubic monotone, and its value, derivatives and integral, for
// tables of force and stiffness.
#include "hawser/kernels/monotone_cubic.hpp"

#include <algorithm>

namespace hawser {

MonotoneCubic::MonotoneCubic(std::vector<Row> rows, std::optional<double> first, double min_ratio)
    : rows_(std::move(rows)) {
  const size_t n = rows_.size();
  std::vector<double> width(n - 1);
  std::vector<double> secant(n - 1);
  for (size_t i = 0; i + 1 < n; ++i) {
    width[i] = rows_[i + 1].first - rows_[i].first;
    secant[i] = (rows_[i + 1].second - rows_[i].second) / width[i];
  }
  // Inside: weighted harmonic mean, monotone by construction.
  slope_.assign(n, 0);
  for (size_t i = 1; i + 1 < n; ++i) {
    const double a = 2 * width[i] + width[i - 1];
    const double b = width[i] + 2 * width[i - 1];
    if (secant[i - 1] > 0 && secant[i] > 0) slope_[i] = (a + b) / (a / secant[i - 1] + b / secant[i]);
  }
  // At the ends: slope of a parabola, limited to what keeps the curve monotone.
  const auto parabola = [min_ratio](double chord, double other) {
    return std::clamp(2 * chord - other, min_ratio * chord, 3 * chord);
  };
  if (n == 2)
    slope_[0] = first.value_or(secant[0]);
  else
    slope_[0] = first ? *first : parabola(secant[0], slope_[1]);
  slope_[n - 1] = parabola(secant[n - 2], slope_[n - 2]);
  integral_.assign(n, 0);
  for (size_t i = 0; i + 1 < n; ++i) {
    const double w = width[i];
    integral_[i + 1] = integral_[i] + w * (rows_[i].second + rows_[i + 1].second) / 2 +
                       w * w * (slope_[i] - slope_[i + 1]) / 12;
    // The slope is a parabola: largest at an end or at its crest.
    const double s0 = slope_[i];
    const double s1 = slope_[i + 1];
    const double bulge = 6 * secant[i] - 3 * (s0 + s1);
    largest_slope_ = std::max({largest_slope_, s0, s1});
    if (bulge > 0) {
      const double t = std::clamp(0.5 + (s1 - s0) / (2 * bulge), 0.0, 1.0);
      largest_slope_ = std::max(largest_slope_, (1 - t) * s0 + t * s1 + bulge * t * (1 - t));
    }
  }
}

MonotoneCubic::Value MonotoneCubic::at(double x) const {
  Value v;
  const bool before = x < rows_.front().first;
  if (before || x >= rows_.back().first) {
    const Row& row = before ? rows_.front() : rows_.back();
    const double d = x - row.first;
    v.slope = before ? slope_.front() : slope_.back();
    v.y = row.second + v.slope * d;
    v.integral = (before ? 0 : integral_.back()) + d * (row.second + 0.5 * v.slope * d);
    return v;
  }
  const auto next =
      std::upper_bound(rows_.begin(), rows_.end(), x, [](double p, const Row& r) { return p < r.first; });
  const size_t i = static_cast<size_t>(next - rows_.begin()) - 1;
  const double w = rows_[i + 1].first - rows_[i].first;
  const double t = (x - rows_[i].first) / w;
  const double f0 = rows_[i].second;
  const double rise = rows_[i + 1].second - f0;
  const double m0 = w * slope_[i];
  const double m1 = w * slope_[i + 1];
  // y = f0 + m0 t + b t² + c t³
  const double b = 3 * rise - 2 * m0 - m1;
  const double c = m0 + m1 - 2 * rise;
  v.y = f0 + t * (m0 + t * (b + t * c));
  v.slope = (m0 + t * (2 * b + 3 * c * t)) / w;
  v.bend = (2 * b + 6 * c * t) / (w * w);
  v.integral = integral_[i] + w * t * (f0 + t * (m0 / 2 + t * (b / 3 + t * c / 4)));
  return v;
}

}  // namespace hawser
