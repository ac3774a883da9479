// Length of line that a constant-tension winch pays out in a step. See docs/theory/feeders.md.
#pragma once

#include "hawser/kernels/cable.hpp"
#include "hawser/math/function_ref.hpp"

namespace hawser {

// The speed is per_tension (T - tension), limited to max_speed in both directions. A resting feeder rests
// while the tension is between `min_tension` and `max_tension`. When it starts to move, the tension stays at
// that limit of the band until the speed is that of the law.
struct FeedLaw {
  double tension = 0;      // N
  double per_tension = 0;  // m/s per N; 0: holds exactly that tension
  double max_speed = 0;    // m/s; 0: no limit
  bool resting = false;
  double min_tension = 0, max_tension = 0;  // N, band of a resting feeder
};

// Tension [N] at a feeder as a function of the unstretched length of the element there, and its derivative
// [N/m], which is not positive.
struct FedPull {
  double force = 0, slope = 0;
};

struct FedElement {
  double length = 0;           // m, unstretched, at the end of the step
  double length_by_force = 0;  // m/N, derivative by a force in addition to `pull`
};

// Solves L = from + h v(pull(L)) for the unstretched length L > 0 of the element at the winch, with the
// tension at the end of the step.
FedElement feed_step(FunctionRef<FedPull(double)> pull, const FeedLaw& law, double from, double h);

// Tension of a cable at the end of a step of h [s] that began with the strain `from` above the free strain:
// elastic and damping tension, limited as in cable_force. h = 0: without damping.
struct CableFeed : FedPull {
  double by_chord = 0;  // N/m, derivative by the chord
};
CableFeed cable_feed(const CableSection& s, double chord, double length, double from, double h);

}  // namespace hawser
