// Height of points above the seabed, and rules for lines that rest on it.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

Vec3 bed_normal(const Seabed& bed);  // normal of a plane bed
double height_above_bed(const Seabed& bed,
                        const Vec3& x);  // m; the bed must be present; infinite beyond a mesh

// Point of the bed vertically below or above x [m]; x itself beyond a mesh.
Vec3 below_on_bed(const Seabed& bed, const Vec3& x);

// Submerged weight of a line of this type, N/m; negative if it floats.
double submerged_weight(const Case& c, const LineType& type);
// Penetration [m] at which the soil balances a force [N per m of line] on a line of this contact diameter
// [m].
double penetration_under(const Seabed& bed, double force, double diameter);
// Height of the axis above the bed [m] of a line of this type that rests under its own weight.
double resting_height(const Case& c, const LineType& type);

// Local change of the bed at an anchor that is not above it. The anchor is held at its given position, and
// the bed is lowered by `depth` at the end (raised if negative), with a linear transition to zero at `length`
// along the line, so that the line lies straight.
struct BedAtEnd {
  double depth = 0, length = 0;  // m
  double lowering(double from_end) const { return from_end < length ? depth * (1 - from_end / length) : 0; }
};
// element [m]: length of the first element at that end, which a cable spans as a chord.
BedAtEnd bed_at_end(const Case& c, const Line& line, LineEnd line_end, double element);

// True if bed friction acts in statics.
bool static_bed_friction(const Case& c);
// Largest height above the bed [m] at which a point of the line's start shape counts as laid on the bed.
double laying_reach(const Case& c, const Line& line);
// True if all points of the case's start shape lie on the bed and statics has bed friction in both
// directions: the line was laid there, and friction holds it axially and laterally.
bool laid_with_friction(const Case& c, const Line& line);
// True if friction alone can hold the line in statics: bed friction of a laid line, or static friction on
// volumes and other lines if the case defines the start shape.
bool held_by_friction(const Case& c, const Line& line);

}  // namespace hawser::model
