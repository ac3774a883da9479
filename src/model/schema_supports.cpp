// Keys of supports: roller boxes of ramps and stingers.
#include <cmath>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key path() {
  return map("path",
             {vec3("from", length, "start of the path, at the tensioner's end", required),
              vec3("direction", none,
                   "direction of the path at its start, towards the overboard side, of any length", required),
              list("segments",
                   map("", {number("length", length, "length along the path", above(0), required),
                            number("radius", length, "radius of an arc that bends downwards", above(0),
                                   or_else_note("none: straight"))}),
                   "straight lengths and arcs; each starts in the direction in which the previous one ends",
                   required, items(1))},
             "curve in the body's frame along which the boxes are positioned", fixed_in_restart);
}

Key boxes() {
  return list(
      "boxes",
      map("",
          {one_of("at",
                  {number("", length, at_least(0)), list("", number("", length, at_least(0)), items(1))},
                  "one box at each of these lengths along `path` ...", fixed_in_restart),
           number("above_path", length,
                  "... at this distance above the path, perpendicular to it (negative: below): position of "
                  "the axis of the roller that carries the pipe; for V of the point where the axes of its "
                  "rollers meet",
                  or_else("0"), fixed_in_restart),
           list("points", vec3("", length),
                "position of each box in the body's frame, in place of `at`, in the order in which the pipe "
                "passes them",
                items(1), fixed_in_restart),
           word("type", {"flat", "V", "U", "box"},
                "`flat`, one roller below; `V`, two rollers that rise to both sides; `U`, one roller below "
                "and one at each side; `box`, the same with one roller above",
                required, fixed_in_restart),
           number("roller_diameter", length, "diameter of all its rollers", above(0), required,
                  fixed_in_restart),
           number("roller_length", length,
                  "length of the roller below, which is the clear width of a U or a box; for V of each of "
                  "the two rollers",
                  above(0), required, fixed_in_restart),
           number("side_height", length,
                  "for U and box: height of the side rollers above the roller below, and in a box of the "
                  "roller above",
                  above(0), fixed_in_restart),
           number("angle_deg", angle, "for V: angle of each roller above the horizontal", above(0),
                  at_most(80 * M_PI / 180), fixed_in_restart),
           one_of("normal_stiffness", {word("", {"auto"}), number("", point_stiffness, above(0))},
                  "stiffness of a roller: force over penetration at a penetration of 1 % of the pipe's "
                  "radius; with `auto` the program raises it during the run as tensions and speeds require",
                  or_else("auto"), fixed_in_restart),
           relative_damping(), friction(&Volume::friction)},
          either({{{"at", "above_path"}, {"at"}}, "points"})),
      "roller boxes; boxes with the same rollers form one entry", required, items(1));
}

}  // namespace

Key supports() {
  return map_by_name(
      "supports",
      map("<group>",
          {reference("body", "bodies",
                     "body to which they are fixed, for example a barge or a stinger; path and points are in "
                     "its frame",
                     or_else_note("none: fixed in space"), fixed_in_restart),
           list("on", reference("", "lines"),
                "straight beams of a structure that carries the boxes: each box is fixed to the nearest node "
                "of these lines; path or points give its position in the body's frame at the start",
                items(1), or_else_note("none: the boxes are fixed to the body"), fixed_in_restart),
           reference("line", "lines", "the line that they carry", or_else_note("the only line")), path(),
           boxes()}),
      "Roller boxes of ramps and stingers, by groups: rollers that rotate without friction, in the order in "
      "which the line passes them. Each box is called `<group> <number>`.",
      or_else("{}"));
}

}  // namespace hawser::model::schema_build
