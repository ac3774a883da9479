// The pull of soil on a point that is lifted out of it, and when the soil holds the point. Gaps [m] are to
// where the contact force begins, negative in the soil. See docs/theory/seabed.md.
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

// How the soil has a point after an accepted state.
struct SuctionState {
  double deepest = 0;  // m, largest depth since the point landed
  bool held = false;   // until it is lifted too far
};

// From the state before to that at `gap`. The soil holds a point that goes deeper than ever since it landed,
// and releases it when it is lifted by more than the suction length. When the point has left the bed, its
// depth is forgotten.
inline SuctionState suction_after(const Suction& law, SuctionState state, double gap) {
  if (!(law.limit > 0)) return {};
  if (-gap > state.deepest) state = {-gap, true};
  if (state.deepest + gap >= law.length) state.held = false;
  if (!state.held && gap >= 0) state.deepest = 0;
  return state;
}

// Of a point that was held at the start of a step.
inline Pull pull_of(const Suction& law, const SuctionState& state, double gap) {
  return state.held ? pull_of(law, state.deepest + gap) : Pull{};
}

// m, largest gap at which there is a pull, and 1 % of the length more, so that a point beyond it is released
// in spite of round-off. Not positive: no gap.
inline double suction_range(const Suction& law, const SuctionState& state) {
  return state.held ? 1.01 * law.length - state.deepest : 0;
}

}  // namespace hawser
