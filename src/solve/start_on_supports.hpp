// The start shape of a line that is laid over supports.
#pragma once

#include <optional>

#include "hawser/terms/bodies.hpp"
#include "start_line.hpp"

namespace hawser {

// From its tensioner over its supports, off them along their direction in a catenary to the bed and along
// that to its other end; a free end lies where it comes to. Nothing where the line has no supports or no held
// end. InputError when the line is too short to lie so.
std::optional<LineStart> line_over_supports(const model::Case& c, const model::Line& line,
                                            const Bodies& bodies, const Mesh& mesh, const LineSpan& span);

}  // namespace hawser
