// Where the seabed of a case is, and what lies on it.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

Vec3 bed_normal(const Seabed& bed);  // of a plane
double height_above_bed(const Seabed& bed,
                        const Vec3& x);  // m, of a bed that is present; infinite beyond a mesh

// The point of the bed straight below or above x [m]; x itself beyond a mesh.
Vec3 below_on_bed(const Seabed& bed, const Vec3& x);

// Of a line of this type, N/m; negative of what floats.
double submerged_weight(const Case& c, const LineType& type);
// How deep the soil lets a force [N per m of line] press a line of this contact diameter [m]: m.
double penetration_under(const Seabed& bed, double force, double diameter);
// Height of the axis of a line of this type above the bed [m] where it lies at rest under its own weight.
double resting_height(const Case& c, const LineType& type);

// The bed beside an anchor that is not above the bed. The anchor stays where the case puts it and the bed
// gives way, so that the line lies straight there: the bed is lowered by `depth` at the end (raised where
// that is negative), linearly less along the line, and by nothing from `length` on.
struct BedAtEnd {
  double depth = 0, length = 0;  // m
  double lowering(double from_end) const { return from_end < length ? depth * (1 - from_end / length) : 0; }
};
// b: at end B. element [m]: length of the first element there, which a cable bridges by its chord.
BedAtEnd bed_at_end(const Case& c, const Line& line, bool b, double element);

// Whether the bed of the case has friction in statics.
bool static_bed_friction(const Case& c);
// How far from the bed a place of a line's start shape may be for the line to have been laid there [m].
double laying_reach(const Case& c, const Line& line);
// Whether the points of the case's start shape lie on the bed from end to end, and statics has its friction:
// then it was laid there, and friction holds it both ways.
bool laid_with_friction(const Case& c, const Line& line);
// Whether friction can hold the line in statics although nothing else does: that bed's, or that of volumes or
// other lines, where the case says where it lies.
bool held_by_friction(const Case& c, const Line& line);

}  // namespace hawser::model
