// One degree, rad.
#pragma once

#include <cmath>

namespace hawser {

inline constexpr double kDegree = M_PI / 180;

}  // namespace hawser
