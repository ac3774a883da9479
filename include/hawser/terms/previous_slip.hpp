// The elastic slip that friction at a place of an axis starts from in a step.
#pragma once

#include <span>

#include "hawser/kernels/contact_rates.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

// Sets slip and normal of `start`, and on request their derivatives along the axis, at the place xi from the
// contact points of the last accepted state, by increasing xi: between points of one interval interpolated.
// False: the material there did not touch, and nothing is set.
bool previous_slip(std::span<const AxisContactPoint> points, double xi, ContactStart& start,
                   ContactRates* rates);

}  // namespace hawser
