// The start of a line with one free end that is longer than the way from the held one to where it comes to
// lie: the bed it sinks to, or the surface it floats up to. What lies has no tension, so that no least energy
// says where; any balance of loads alone would leave it in a heap.
#pragma once

#include <optional>
#include <vector>

#include "hawser/kernels/catenary.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// The held end of such a line.
struct HeldEnd {
  Vec3 at = Vec3::Zero();         // m
  Vec3 direction = Vec3::Zero();  // of the line away from it, where it is given
  Vec3 body = Vec3::Zero();       // m, from the origin of the body it is held by
};

// Unit vector in the level: where a line that lies goes from its held end. Down a sloping bed or with the
// current, whichever pulls more; else on as the end is held; else away from the body that holds it; else
// along x.
Vec3 direction_of_free_end(const model::Case& c, const model::Line& line, const HeldEnd& end, bool floats);

// Places at the arc lengths `arc` [m] from the held end of a line of `sections`, counted from there too:
// straight down (or up) to the level with the stretch of what hangs, round a bend of the radius that a beam's
// stiffness gives it, and along the bed or the surface. Nothing where sections that assembler follow ones
// that float, or where the line does not reach the level.
std::optional<std::vector<Vec3>> laid_free_end(const model::Case& c, const model::Line& line,
                                               const HeldEnd& end, std::vector<CatenarySection> sections,
                                               const std::vector<double>& arc);

}  // namespace hawser
