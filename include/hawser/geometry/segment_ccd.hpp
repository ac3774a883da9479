// Continuous collision detection of two moving segments.
//
// Conservative advancement (Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems",
// section 2.3.2): the distance of two segments whose ends move straight changes no faster than the ends move
// apart, so a step in time of (distance - least) / speed cannot miss an approach to `least`.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Ends at time 0 and at time 1, moving straight between.
struct MovingSegment {
  Vec3 from0, to0, from1, to1;  // m
};

// A time in [0, 1] before which the segments are not nearer than `least` [m, > 0] and at which they are no
// further apart than least + tolerance [m, > 0]; 2 where they stay apart. Inconclusive after a few hundred
// steps (they graze that distance for long): the time reached.
double first_approach(const MovingSegment& a, const MovingSegment& b, double least, double tolerance);

}  // namespace hawser
