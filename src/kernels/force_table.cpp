#include "hawser/kernels/force_table.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {

ForceTable::ForceTable(std::span<const Row> rows) : rows_{{0, 0}} {
  const auto bad = [](size_t row, const char* what) {
    throw std::invalid_argument("row " + std::to_string(row + 1) + " " + what);
  };
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto [p, f] = rows[i];
    if (!std::isfinite(p) || !std::isfinite(f)) bad(i, "is not finite");
    if (i == 0 && p == 0 && f == 0) continue;
    if (!(p > rows_.back().first)) bad(i, "does not penetrate further than the one before");
    if (f < rows_.back().second) bad(i, "has less force than the one before");
    rows_.push_back(rows[i]);
  }
  if (rows_.size() < 2 || !(rows_.back().second > 0))
    throw std::invalid_argument("a table of forces needs a row with a force");
  const size_t n = rows_.size();
  std::vector<double> width(n - 1), secant(n - 1);
  for (size_t i = 0; i + 1 < n; ++i) {
    width[i] = rows_[i + 1].first - rows_[i].first;
    secant[i] = (rows_[i + 1].second - rows_[i].second) / width[i];
  }
  // Slopes by the weighted harmonic mean (Fritsch & Butland 1984): monotone by construction.
  slope_.assign(n, 0);
  for (size_t i = 1; i + 1 < n; ++i) {
    const double a = 2 * width[i] + width[i - 1], b = width[i] + 2 * width[i - 1];
    if (secant[i - 1] > 0 && secant[i] > 0) slope_[i] = (a + b) / (a / secant[i - 1] + b / secant[i]);
  }
  // At the end as if the last piece were a parabola, within what keeps it monotone.
  slope_[n - 1] = std::clamp(2 * secant[n - 2] - slope_[n - 2], 0.0, 3 * secant[n - 2]);
  potential_.assign(n, 0);
  for (size_t i = 0; i + 1 < n; ++i) {
    const double w = width[i];
    potential_[i + 1] = potential_[i] + w * (rows_[i].second + rows_[i + 1].second) / 2 +
                        w * w * (slope_[i] - slope_[i + 1]) / 12;
    // The slope is a parabola: largest at an end or at its crest.
    const double s0 = slope_[i], s1 = slope_[i + 1], bulge = 6 * secant[i] - 3 * (s0 + s1);
    largest_slope_ = std::max({largest_slope_, s0, s1});
    if (bulge > 0) {
      const double t = std::clamp(0.5 + (s1 - s0) / (2 * bulge), 0.0, 1.0);
      largest_slope_ = std::max(largest_slope_, (1 - t) * s0 + t * s1 + bulge * t * (1 - t));
    }
  }
}

ForceTable::Value ForceTable::at(double p) const {
  Value v;
  if (p <= 0) return v;
  if (p >= rows_.back().first) {
    const double d = p - rows_.back().first;
    v.slope = slope_.back();
    v.force = rows_.back().second + v.slope * d;
    v.potential = potential_.back() + d * (rows_.back().second + 0.5 * v.slope * d);
    return v;
  }
  const auto next =
      std::upper_bound(rows_.begin(), rows_.end(), p, [](double x, const Row& r) { return x < r.first; });
  const size_t i = static_cast<size_t>(next - rows_.begin()) - 1;
  const double w = rows_[i + 1].first - rows_[i].first, t = (p - rows_[i].first) / w;
  const double f0 = rows_[i].second, rise = rows_[i + 1].second - f0;
  const double m0 = w * slope_[i], m1 = w * slope_[i + 1];
  // f = f0 + m0 t + b t² + c t³
  const double b = 3 * rise - 2 * m0 - m1, c = m0 + m1 - 2 * rise;
  v.force = f0 + t * (m0 + t * (b + t * c));
  v.slope = (m0 + t * (2 * b + 3 * c * t)) / w;
  v.bend = (2 * b + 6 * c * t) / (w * w);
  v.potential = potential_[i] + w * t * (f0 + t * (m0 / 2 + t * (b / 3 + t * c / 4)));
  return v;
}

}  // namespace hawser
