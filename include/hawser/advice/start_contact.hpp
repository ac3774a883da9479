// Messages about lines that start inside volumes or on the wrong side of them.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Part of a line inside a volume, m of arc length and m.
struct InsideVolume {
  double from = 0, to = 0;    // of the part
  double at = 0, depth = 0;   // deepest point, and its depth
  Vec3 place = Vec3::Zero();  // of the deepest point, in space
  double length = 0;          // of the line
  // Length of elements with which a line on its start points is outside; 0: none, or its points are inside.
  double outside_with = 0;
};
// A clause for a volume that is switched on.
std::string line_inside(const std::string& line, const InsideVolume& s);
std::string starts_inside(const model::Line& line, const std::string& volume, const InsideVolume& s);
// statics: statics ran and did not move the line out.
std::string stays_inside(const model::Line& line, const std::string& volume, const InsideVolume& s,
                         bool statics);
// For end A or B, `depth` [m] inside or at the surface and therefore without contact over the length
// `without` [m].
std::string excluded_at_end(const model::Line& line, LineEnd line_end, const std::string& volume,
                            double depth, double without);

// A line that passes a volume on the other side than its ends.
struct Passes {
  bool under = false;                         // below the volume
  double distance = 0, arc = 0;               // m, distance to the volume; m
  Vec3 place = Vec3::Zero();                  // m
  bool carries_a = false, carries_b = false;  // the volume's body carries that end, which is above
};
std::string passes_volume(const model::Line& line, const std::string& volume, const Passes& p);

// Volumes whose contact begins with more elastic energy [J] than motion and other forces take up; body: the
// floating body to be moved, by `out` [m].
std::string driven_apart(const std::string& volume, const std::string& other, const std::string& body,
                         double energy, double out);

// Numbers beyond those that are listed.
std::string more_stretches_inside(size_t stretches);
std::string more_ends_excluded(size_t ends);
std::string more_lines_on_wrong_side(size_t lines);

}  // namespace hawser::advice
