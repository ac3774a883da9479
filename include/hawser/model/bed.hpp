// Where the seabed of a case is, and what lies on it.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

Vec3 bed_normal(const Seabed& bed);  // of a plane
double height_above_bed(const Seabed& bed,
                        const Vec3& x);  // m, of a bed that is present; infinite beyond a mesh

// How far from the bed a place of a line's start shape may be for the line to have been laid there [m].
double laying_reach(const Case& c, const Line& line);
// Whether the points of the case's start shape lie on the bed from end to end, and statics has its friction:
// then it was laid there, and friction holds it both ways.
bool laid_with_friction(const Case& c, const Line& line);
// Whether friction can hold the line in statics although nothing else does: that bed's, or that of volumes or
// other lines, where the case says where it lies.
bool held_by_friction(const Case& c, const Line& line);

}  // namespace hawser::model
