// Detects an element axis that passes through a body in a step without contact before and after. Pure.
#pragma once

#include "hawser/kernels/axis_clearance.hpp"

namespace hawser {

// True if a point of the axis that was outside comes nearer to the surface than a quarter of the line's
// radius during the step, and at the end is clear of it again or on another side, where the surface's normal
// points backwards. Axes in the body's frame. Displacements of at most the radius are not tested, so that
// steps are never reduced below that, for any contact stiffness. Pieces of the axis and of its path are
// excluded if they are farther away than their size, so that thin bodies are not missed; pieces within
// a radius of the surface are examined in lengths of half a radius. `pressed`: also tests whether points that
// start nearer than that, or inside, come to another side. A corner or an edge touches with the tested point
// itself.
bool passes_through(DistanceField field, const BezierAxis& from, const BezierAxis& to, double radius,
                    bool pressed = false);

}  // namespace hawser
