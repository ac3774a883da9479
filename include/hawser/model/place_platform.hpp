// The things of a platform file, moved and turned to a place of a farm.
#pragma once

#include "hawser/model/case.hpp"
#include "hawser/model/farm.hpp"

namespace hawser::model {

// Adds bodies, volumes, supports, joints, lines and links of `platform` to `to`, called as at `place` and
// moved with it: positions, motions, directions and springs turn by its heading. Forces and moments in axes
// of space keep their direction, as wind and current do. Anchors and points of start shapes that are on or
// under the bed of the platform's file, `bed`, keep their height above the bed there and are as high above
// that of `to`. What the file fixes in space is fixed to a body that stands still at the place and has its
// name. InputError: springs or dampers of a floating body that differ in x and y and are not turned by
// quarters.
void place_platform(const Case& platform, const Seabed& bed, const FarmPlace& place, Case& to);

}  // namespace hawser::model
