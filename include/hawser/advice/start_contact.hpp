// Sentences about lines that start inside volumes or on the wrong side of them.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// A stretch of a line inside a volume, m of arc length and m.
struct InsideVolume {
  double from = 0, to = 0;    // of the stretch
  double at = 0, depth = 0;   // where it is deepest, and how deep
  Vec3 place = Vec3::Zero();  // of that, in space
  double length = 0;          // of the line
};
// A clause on a volume that is switched on.
std::string line_inside(const std::string& line, const InsideVolume& s);
std::string starts_inside(const model::Line& line, const std::string& volume, const InsideVolume& s);
// statics: has not brought it out, or there is none.
std::string stays_inside(const model::Line& line, const std::string& volume, const InsideVolume& s,
                         bool statics);
// At end A or B, `depth` [m] inside or at the surface, and so without contact over a length [m].
std::string excluded_at_end(const model::Line& line, bool at_b, const std::string& volume, double depth,
                            double without);

// A line that passes a volume, while its ends are on the other side.
struct Passes {
  bool under = false;                 // of the volume
  double distance = 0, arc = 0;       // m, from it; m
  Vec3 place = Vec3::Zero();          // m
  bool own_a = false, own_b = false;  // the volume carries that end, which is above
};
std::string passes_volume(const model::Line& line, const std::string& volume, const Passes& p);

// Beyond those that are listed.
std::string more_stretches_inside(size_t stretches);
std::string more_ends_excluded(size_t ends);
std::string more_lines_on_wrong_side(size_t lines);

}  // namespace hawser::advice
