// Continuous collision detection of two moving segments.
//
// Conservative advancement (Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems", section
// 2.3.2): the distance of two segments whose ends move along straight lines changes no faster than the ends
// move relative to each other, so a time step of (distance - least) / speed cannot miss an approach to
// `least`.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Ends at time 0 and at time 1, with straight paths between.
struct MovingSegment {
  Vec3 from0, to0, from1, to1;  // m
};

// Time in [0, 1] before which the segments are not nearer than `least` [m, > 0], and at which their distance
// is at most least + tolerance [m, > 0]; 2 if they stay apart. Returns the time reached if a few hundred
// steps (long grazing at that distance) do not decide.
double first_approach(const MovingSegment& a, const MovingSegment& b, double least, double tolerance);

}  // namespace hawser
