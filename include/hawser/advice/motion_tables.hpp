// Notes on tables of motion.
#pragma once

#include <cstddef>
#include <string>

#include "hawser/kernels/motion.hpp"

namespace hawser::advice {

// The spline between two rows, at the times `from` and `to` [s], leaves the range of both. rotation: the
// columns are those of the rotation vector [rad], otherwise of the position [m]; fraction: the excess over
// the range of all rows; more: number of other places.
std::string spline_beyond_rows(const std::string& key, double from, double to, const RowCurve::Overshoot& at,
                               bool rotation, double fraction, size_t more);

}  // namespace hawser::advice
