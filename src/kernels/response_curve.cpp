// Cubic through the rows of a stiffness table and the origin: force, tangent stiffness and strain energy for
// cable and beam elements.
#include "hawser/kernels/response_curve.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {
namespace {

// Smallest tangent as a fraction of the secant; a smaller one would make a line limp beyond its table.
constexpr double kMinRatio = 0.1;

std::vector<ResponseCurve::Row> through_zero(std::span<const ResponseCurve::Row> rows, bool odd) {
  std::vector<ResponseCurve::Row> out;
  const auto refuse = [](size_t row, const char* problem) {
    throw std::invalid_argument("row " + std::to_string(row + 1) + " " + problem);
  };
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto [e, f] = rows[i];
    if (!std::isfinite(e) || !std::isfinite(f)) refuse(i, "is not finite");
    if (odd && e < 0) refuse(i, "is negative: what bends the other way is the same");
    if (e == 0 ? f != 0 : e * f <= 0)
      refuse(i,
             e == 0 ? "has a force without strain" : "does not pull back: it must go through zero, rising");
    if (i > 0 && !(e > rows[i - 1].first)) refuse(i, "does not go further than the one before");
    if (i > 0 && !(f > rows[i - 1].second)) refuse(i, "has no more force than the one before");
    if (e > 0 && (out.empty() || out.back().first < 0)) out.emplace_back(0, 0);
    out.push_back(rows[i]);
  }
  if (!out.empty() && out.back().first < 0) out.emplace_back(0, 0);
  if (out.size() < 2) throw std::invalid_argument("a table needs a row beyond zero");
  if (odd) {
    std::vector<ResponseCurve::Row> mirrored;
    for (size_t i = out.size(); i-- > 1;) mirrored.emplace_back(-out[i].first, -out[i].second);
    out.insert(out.begin(), mirrored.begin(), mirrored.end());
  }
  return out;
}

}  // namespace

ResponseCurve::ResponseCurve(std::span<const Row> rows, bool odd)
    : curve_(through_zero(rows, odd), {}, kMinRatio) {
  const MonotoneCubic::Value zero = curve_.at(0);
  initial_ = zero.slope;
  integral_ = zero.integral;
}

ResponseCurve::Value ResponseCurve::at(double strain) const {
  const MonotoneCubic::Value v = curve_.at(strain);
  return {v.y, v.slope, v.integral - integral_};
}

}  // namespace hawser
