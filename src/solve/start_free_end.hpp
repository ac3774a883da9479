// Start shape of a line with one free end that is longer than the distance from the held end to the bed
// (sinking lines) or the water surface (floating lines). The part there has no tension, so neither the
// minimum of energy nor equilibrium determines its position.
#pragma once

#include <optional>
#include <vector>

#include "hawser/kernels/catenary.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// True if the loads of all sections are directed up (sign 1) or down (sign -1).
bool all_act(const std::vector<CatenarySection>& sections, double sign);

// The held end of such a line.
struct HeldEnd {
  Vec3 at = Vec3::Zero();         // m
  Vec3 direction = Vec3::Zero();  // of the line away from the end, if given
  Vec3 body = Vec3::Zero();       // m, from the origin of the body that holds the end
};

// Horizontal unit vector from the held end, along which the line lies: down a sloping bed or with the
// current, whichever pulls more; else in the direction of the held end; else away from the body that holds
// it; else along x.
Vec3 direction_of_free_end(const model::Case& c, const model::Line& line, const HeldEnd& end, bool floats);

// Positions at the arc lengths `arc` [m] from the held end of a line of `sections`, which count from there,
// too: vertically down (or up) to the ground with the stretch of the hanging part, round a bend with the
// radius that a beam's stiffness causes, and along the bed or the surface. None if some sections sink and
// others float, or if the line does not reach the ground.
std::optional<std::vector<Vec3>> laid_free_end(const model::Case& c, const model::Line& line,
                                               const HeldEnd& end, std::vector<CatenarySection> sections,
                                               const std::vector<double>& arc);

}  // namespace hawser
