// Placement of the objects of a platform file in a farm.
#pragma once

#include "hawser/model/case.hpp"
#include "hawser/model/farm.hpp"

namespace hawser::model {

// Adds bodies, volumes, supports, joints, lines and links of `platform` to `to`, named after `place` and
// moved there: positions, motions, directions and springs are rotated by its heading. Forces and moments in
// space axes keep their direction, as wind and current do. Anchors and points of start shapes on or below the
// bed of the platform's file, `bed`, keep their height above the bed in `to`. Objects that the file fixes in
// space are fixed to a stationary body with the name of the place. Throws InputError if springs or dampers of
// a floating body differ in x and y and the heading is no multiple of 90 degrees.
void place_platform(const Case& platform, const Seabed& bed, const FarmPlace& place, Case& to);

}  // namespace hawser::model
