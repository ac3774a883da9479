// Notes on tables of motion.
#include "hawser/advice/motion_tables.hpp"

#include <fmt/format.h>

#include "hawser/math/degree.hpp"

namespace hawser::advice {

std::string spline_beyond_rows(const std::string& key, double from, double to, const RowCurve::Overshoot& at,
                               bool rotation, double fraction, size_t more) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  const double factor = rotation ? 1 / kDegree : 1;
  const char* unit = rotation ? "deg" : "m";
  return fmt::format(
      "{}: between its rows at {:g} and {:g} s the spline takes {}{} to {:.4g} {} at {:.4g} s, {:.3g} {} "
      "({:.3g} % of what the rows span) beyond both{}; if the body does not do that, give more rows there or "
      "'interpolation: monotone'",
      key, from, to, rotation ? "the rotation about " : "", kAxes[at.component], at.value * factor, unit,
      at.time, at.excess * factor, unit, 100 * fraction,
      more > 0 ? fmt::format(", and so in {} other place{}", more, more > 1 ? "s" : "") : "");
}

}  // namespace hawser::advice
