// Positions where the nodes of the lines of a case were laid on the bed, from which friction in statics acts.
// See docs/theory/seabed.md, "Statics: as laid".
#pragma once

#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// starts: the positions of the start shape [m, space axes], by line and node of the line; the result has the
// same layout. Both are empty for lines that are not required, and for lines joined to them. A line is laid
// without tension from the end that is nearer to the bed: its nodes are at their unstretched distances in the
// direction of the start shape. At a joint it continues from the line there. A line was laid in its start
// shape if the case prescribes this shape and it is on the bed from end to end, or if the line has a free end
// and its other end is near the bed. NaN: a line hangs down onto the bed, and where it was laid is unknown.
std::vector<std::vector<Vec3>> laid_places(const model::Case& c, const Mesh& mesh,
                                           const std::vector<std::vector<Vec3>>& starts);

}  // namespace hawser
