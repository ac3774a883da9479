// How long a step may be beside and in a contact, so that an impact is followed and its force makes no
// energy. Scalars only. See docs/theory/contact.md, "Steps".
#pragma once

#include <limits>

namespace hawser {

// Of a step from here.
struct StepLimit {
  double longest = std::numeric_limits<double>::infinity();  // s
  // s, shortest period of the contacts that strike now: what they set in motion is followed for some time.
  double period = std::numeric_limits<double>::infinity();

  void take(const StepLimit& o) {
    if (o.longest < longest) longest = o.longest;
    if (o.period < period) period = o.period;
  }
};

// What meets something: how far it is from where forces begin (m, negative: beyond), how fast it closes (m/s)
// and its acceleration along the normal (m/s², positive: away).
struct Approach {
  double gap = 0, closing = 0, acceleration = 0;
  bool last = true;  // in touch: no other place of the same contact is deeper, so that it ends with this one
};

// slowness: s, sqrt(m/k) of the contact, its period over 2 pi. seen: m; what inertia takes deeper than that,
// by speed or by acceleration, strikes. An impact has six steps in a period, and steps end at its touch and
// at its end: across the touch the trapezoid takes half of force times gap of energy, across the end it makes
// that.
StepLimit impact_limit(double slowness, double seen, const Approach& at);

}  // namespace hawser
