// How much line a winch that keeps to a tension lets out in a step.
#pragma once

#include <functional>

#include "hawser/kernels/cable.hpp"

namespace hawser {

// The speed is per_tension (T - tension), limited to max_speed either way; at rest it is zero.
struct FeedLaw {
  double tension = 0;      // N
  double per_tension = 0;  // m/s per N; 0: exactly that tension
  double max_speed = 0;    // m/s; 0: no limit
  bool resting = false;
};

// Tension [N] at a feeder by the unstretched length of the element there, and its derivative [N/m], which is
// not positive.
struct FedPull {
  double force = 0, slope = 0;
};

struct FedElement {
  double length = 0;  // m, unstretched, at the end of the step
  double gives = 0;   // m/N, derivative by a force on top of `pull`
};

// Solves L = from + h v(pull(L)) for the unstretched length L > 0 of the element at the winch, with the
// tension at the end of the step.
FedElement feed_step(const std::function<FedPull(double)>& pull, const FeedLaw& law, double from, double h);

// Of a cable: its elastic tension, and the derivative of that by its chord [N/m].
FedPull cable_feed(const CableSection& s, double chord, double length);
double cable_feed_by_chord(const CableSection& s, double chord, double length);

}  // namespace hawser
