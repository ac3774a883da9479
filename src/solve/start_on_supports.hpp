// The start shape of a line that is laid over supports.
#pragma once

#include <optional>

#include "hawser/terms/bodies.hpp"
#include "start_line.hpp"

namespace hawser {

// From the tensioner over the supports, in a catenary from the last support to the bed, and along the bed to
// the other end. A free end lies where the length ends. None if the line has no supports or no held end.
// Throws InputError if the line is too short for this path.
std::optional<LineStart> line_over_supports(const model::Case& c, const model::Line& line,
                                            const Bodies& bodies, const Mesh& mesh, const LineSpan& span);

}  // namespace hawser
