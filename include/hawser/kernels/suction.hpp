// Pull of the soil on a point that is lifted out of it, and the conditions under which it acts. Gaps [m] are
// relative to the beginning of the contact force, negative in the soil. See docs/theory/seabed.md.
#pragma once

namespace hawser {

// The pull increases from zero at the deepest position to `limit` at half of `length` and decreases to zero
// at `length`: 16 limit s²(1 - s)², s: lift divided by length. Once continuously differentiable; its total
// work is 8/15 limit length. The formula is the program's own, without a published source; it is not the
// cyclic law of Randolph & Quiggin (2009).
struct Suction {
  double limit = 0;   // N; 0: none
  double length = 0;  // m
  bool operator==(const Suction&) const = default;
};

struct Pull {
  double force = 0;    // N
  double by_lift = 0;  // N/m
};

// Pull at the lift [m] from the deepest position.
inline Pull pull_of(const Suction& law, double lift) {
  if (!(lift > 0) || lift >= law.length) return {};
  const double s = lift / law.length;
  const double remaining = 1 - s;
  return {16 * law.limit * s * s * remaining * remaining,
          32 * law.limit / law.length * s * remaining * (1 - 2 * s)};
}

// State of the soil at a point after an accepted step.
struct SuctionState {
  double deepest = 0;  // m, largest depth since the point landed
  bool held = false;   // until the point is lifted by the suction length
};

// New state at `gap`. The soil holds a point that goes deeper than before since it landed, and releases it
// when it is lifted by more than the suction length. The depth is reset when the point has left the bed.
inline SuctionState suction_after(const Suction& law, SuctionState state, double gap) {
  if (!(law.limit > 0)) return {};
  if (-gap > state.deepest) state = {-gap, true};
  if (state.deepest + gap >= law.length) state.held = false;
  if (!state.held && gap >= 0) state.deepest = 0;
  return state;
}

// Pull on a point, if it was held at the start of the step.
inline Pull pull_of(const Suction& law, const SuctionState& state, double gap) {
  return state.held ? pull_of(law, state.deepest + gap) : Pull{};
}

// Largest gap with a pull, plus 1 % of the length so that a point beyond it is released in spite of
// round-off, m. Not positive: none.
inline double suction_range(const Suction& law, const SuctionState& state) {
  return state.held ? 1.01 * law.length - state.deepest : 0;
}

}  // namespace hawser
