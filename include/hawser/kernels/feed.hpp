// How much line a winch that keeps to a tension lets out in a step.
#pragma once

#include "hawser/kernels/cable.hpp"

namespace hawser {

// The speed is per_tension (T - tension), limited to max_speed either way; at rest it is zero.
struct FeedLaw {
  double tension = 0;      // N
  double per_tension = 0;  // m/s per N; 0: exactly that tension
  double max_speed = 0;    // m/s; 0: no limit
  bool resting = false;
};

struct FedElement {
  double length = 0;    // m, unstretched, at the end of the step
  double by_chord = 0;  // derivative by the chord
};

// Solves L = from + h v(T(chord / L)) for the unstretched length L of the element at the winch, with the
// elastic tension T at the end of the step; L > 0 for a chord > 0.
FedElement feed_step(const CableSection& s, const FeedLaw& law, double from, double h, double chord);

}  // namespace hawser
