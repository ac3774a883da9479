// Degrees of freedom of a rigid body, in the order of its six velocities.
#pragma once

#include <array>

namespace hawser {

inline constexpr std::array<const char*, 6> kFreedomNames{"surge", "sway", "heave", "roll", "pitch", "yaw"};
// Surge, sway and yaw.
inline constexpr std::array<int, 3> kHorizontalFreedoms{0, 1, 5};

}  // namespace hawser
