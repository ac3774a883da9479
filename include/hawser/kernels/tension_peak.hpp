// Resolution of tension peaks of snap loads by time steps and elements. A peak resembles a half wave,
// T cos(w t) about its maximum T (docs/theory/time-integration.md#snap-loads).
#pragma once

#include <cmath>

namespace hawser {

// Largest phase w h of a step of h, or w tau of the travel time through an element, rad: six in a half wave.
inline constexpr double kResolvedPhase = M_PI / 6;

// True if a step from the tension `before` to the tension `now` [N, positive] resolves a peak at its end:
//   before >= now cos(w h) for w h = kResolvedPhase
inline bool resolves_peak(double before, double now) { return before >= now * std::cos(kResolvedPhase); }

}  // namespace hawser
