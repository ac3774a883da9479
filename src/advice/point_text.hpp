// Text of a point.
#pragma once

#include <fmt/format.h>

#include <string>

#include "hawser/math/types.hpp"

namespace hawser::advice {

inline std::string point_text(const Vec3& x) {  // m
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", x.x(), x.y(), x.z());
}

}  // namespace hawser::advice
