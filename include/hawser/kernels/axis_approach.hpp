// Checks that two axes stay on the same sides of each other in a step, from their smallest distance.
//
// Every point of an axis is assumed to move along a straight path from the start of the step to its end. The
// axes are halved until the chords of the pieces decide the question for the curves; most pieces are decided
// from their distance. If accepted steps satisfy the check, no axis has passed through the other, whatever
// the curves.
#pragma once

#include "hawser/kernels/axis_shape.hpp"

namespace hawser {

// Limits of the distance between two axes, m, relative to that at the same place at the start of the step.
struct ApproachLimits {
  double min_distance = 0;  // smallest distance allowed,
  double part = 0.5;        // or this fraction of the distance at the start;
  double floor = 0;         // lower bound of both, unless the axes were already nearer
  double no_side = -1;      // axes nearer than this at the start cross; < 0: not tested
};

enum class Sides { kept, near, crossing };

// `kept`: all distances are above the limits. `near`: a distance is below a limit, or so close above it (a
// quarter) that chords and search leave it open. `crossing`: the axes crossed at the start of the step, so
// that neither side is the correct one.
Sides sides_kept(const AxisShape& a0, const AxisShape& a1, const AxisShape& b0, const AxisShape& b1,
                 const ApproachLimits& limits);

}  // namespace hawser
