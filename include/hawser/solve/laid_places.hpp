// Where the nodes of the lines of a case were laid on the bed: friction in statics acts from there. See
// docs/theory/seabed.md, "Statics: as laid".
#pragma once

#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// starts: the places of the start shape [m, space], by line and node of the line. The result is likewise. A
// line is laid without tension from the end that is nearer to the bed: its nodes follow each other at their
// natural distances in the direction of the start shape. Through a joint it goes on from the line there. A
// line whose start shape the case gives, on the bed from end to end, was laid where it starts, and so was one
// with a free end whose other end is near the bed. Not a number: of a line that hangs down onto the bed
// nothing says where it was laid.
std::vector<std::vector<Vec3>> laid_places(const model::Case& c, const Mesh& mesh,
                                           const std::vector<std::vector<Vec3>>& starts);

}  // namespace hawser
