// Start shape of a line for which no catenary in closed form exists, because a part between its ends lies on
// the bed, it passes through the water's surface, or a current moves it.
#pragma once

#include <vector>

#include "hawser/kernels/current.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// Buoyancy of a submerged line, N/m.
double buoyancy(const model::Case& c, const model::LineType& t);

// The current that acts in statics.
CurrentProfile acting_current(const model::Case& c);

// True if a line with its nodes at x goes through the bed, or through the water's surface.
bool crosses_bed_or_surface(const model::Case& c, const model::Line& line, const std::vector<Vec3>& x);

// True if the drag of a current on a line is more than a small fraction of the line's weight in water.
bool streams(const model::Case& c, const model::Line& line);

// True if neighbouring elements of such a line are folded on each other, or almost.
bool folded(const std::vector<Vec3>& x);

// Shape at rest of a line without bending stiffness, on the bed, through the water's surface and in the
// current (kernels/flexible_shape.hpp), from the shape x, with the same held ends. Returns one position for
// each node. `direction` is that of a small load on a line with one free end, whose slack part would
// otherwise lie in a heap; zero: none.
std::vector<Vec3> flexible_start(const model::Case& c, const model::Line& line, const Mesh& mesh,
                                 const LineSpan& span, const std::vector<Vec3>& x, const Vec3& direction);

}  // namespace hawser
