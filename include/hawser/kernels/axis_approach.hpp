// Whether two axes keep their sides in a step: how near they come to each other on the way.
//
// Every point of an axis is taken to move straight from the start of the step to its end. The axes are halved
// until the chords of the pieces decide what is asked of the curves; most pieces are decided from afar.
// Between accepted states that keep this no axis has gone through the other, whatever the curves.
#pragma once

#include "hawser/kernels/axis_shape.hpp"

namespace hawser {

// All m. What is asked of a place follows from how far the axes were apart there when the step began.
struct ApproachLimits {
  double most = 0;      // no nearer than this,
  double part = 0.5;    // or than this part of what they were apart;
  double floor = 0;     // nor nearer than this, unless they were already somewhere
  double no_side = -1;  // axes that were nearer than this cross; < 0: that is not asked
};

enum class Sides { kept, near, none };

// `kept`: no place of the curves comes nearer than the limits. `near`: one does, or comes within a quarter
// more (what chords and search leave open). `none`: the axes crossed when the step began, and neither side is
// the right one.
Sides sides_kept(const AxisShape& a0, const AxisShape& a1, const AxisShape& b0, const AxisShape& b1,
                 const ApproachLimits& limits);

}  // namespace hawser
