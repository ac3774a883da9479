// The pull of soil on what is lifted out of it.
#pragma once

namespace hawser {

// Rises from nothing at the deepest place to `limit` half way and goes again over `length`: 16 limit s²(1 -
// s)², s the lift over the length. Once continuously differentiable; its work all the way is 8/15 limit
// length.
struct Suction {
  double limit = 0;   // N; 0: none
  double length = 0;  // m
  bool operator==(const Suction&) const = default;
};

struct Pull {
  double force = 0;    // N
  double by_lift = 0;  // N/m
};

// lift [m]: how far from the deepest place.
inline Pull pull_of(const Suction& law, double lift) {
  if (!(lift > 0) || lift >= law.length) return {};
  const double s = lift / law.length, rest = 1 - s;
  return {16 * law.limit * s * s * rest * rest, 32 * law.limit / law.length * s * rest * (1 - 2 * s)};
}

}  // namespace hawser
