// Whether the axis of an element goes through a body in a step, touching it neither before nor after. Pure.
#pragma once

#include "hawser/kernels/axis_clearance.hpp"

namespace hawser {

// Whether a point of the axis that was outside gets nearer to the surface than a quarter of the line's radius
// on its way, and is clear of it again at the end, or on another side: where the surface's normal points
// back. Axes in the body's frame. A way of no more than the radius goes through nothing: asked about
// longer ones only, steps are never cut below that, however soft a contact is. Pieces of the axis and of its
// way that are farther away than they are large are excluded, so that thin bodies are not missed; what is
// deep is looked at in pieces of a radius.
// `pressed`: what starts nearer than that, or inside, is asked about too: whether it comes to another side. A
// corner or an edge touches with its very place.
bool goes_through(DistanceField field, const BezierAxis& from, const BezierAxis& to, double radius,
                  bool pressed = false);

}  // namespace hawser
