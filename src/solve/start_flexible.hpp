// The start of a line that no catenary in closed form fits: it lies on the bed somewhere between, comes
// through the water's surface or streams in a current.
#pragma once

#include <vector>

#include "hawser/kernels/current.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// N/m of a line under water.
double buoyancy(const model::Case& c, const model::LineType& t);

// The current that acts in statics.
CurrentProfile acting_current(const model::Case& c);

// Whether a line with its nodes at x goes through the bed, or through the water's surface.
bool goes_through(const model::Case& c, const model::Line& line, const std::vector<Vec3>& x);

// Whether a current's drag on a line is more than a small share of what the line weighs in water.
bool streams(const model::Case& c, const model::Line& line);

// Whether neighbouring elements of such a line turn back on each other, or nearly.
bool folded(const std::vector<Vec3>& x);

// Rest shape of a line without bending stiffness, on the bed, through the surface and in the
// current (kernels/flexible_shape.hpp), from the shape x, whose held ends stay; one place a node. `way`:
// where a slight pull takes a line with one free end, whose slack would come to lie in a heap without; else
// zero.
std::vector<Vec3> flexible_start(const model::Case& c, const model::Line& line, const Mesh& mesh,
                                 const LineSpan& span, const std::vector<Vec3>& x, const Vec3& way);

}  // namespace hawser
