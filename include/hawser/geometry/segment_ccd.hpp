// Continuous collision detection of two moving segments.
//
// Conservative advancement (Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems", section
// 2.3.2): the distance of two segments whose ends move along straight lines changes no faster than the ends
// move relative to each other, so a time step of (distance - threshold) / speed cannot miss an approach
// to `threshold`.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Ends at time 0 and at time 1, with straight paths between.
struct MovingSegment {
  Vec3 from0, to0, from1, to1;  // m
};

// Time in [0, 1] before which the segments are not nearer than `threshold` [m, > 0], and at which their
// distance is at most threshold + tolerance [m, > 0]; 2 if they stay apart. Returns the time reached if a few
// hundred steps (long grazing at that distance) do not decide.
double first_approach(const MovingSegment& a, const MovingSegment& b, double threshold, double tolerance);

}  // namespace hawser
