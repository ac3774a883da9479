// Keys of supports: roller boxes of ramps and stingers.
#include <cmath>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key path() {
  return map(
      "path",
      {vec3("from", length, "where it begins, at the tensioner's end", required),
       vec3("direction", none,
            "of the path there, the way that the pipe goes overboard; its length does not matter", required),
       list("segments",
            map("", {number("length", length, "along the path", above(0), required),
                     number("radius", length, "of an arc that bends downwards", above(0),
                            or_else_note("none: it is straight"))}),
            "straight lengths and arcs, each going on from the one before it in its direction", required,
            items(1))},
      "line in the body's frame that the places of the boxes are measured along", fixed_in_restart);
}

Key boxes() {
  return list(
      "boxes",
      map("",
          {one_of("at",
                  {number("", length, at_least(0)), list("", number("", length, at_least(0)), items(1))},
                  "one box at each of these lengths along `path` ...", fixed_in_restart),
           number("above_path", length,
                  "... and so far above it, across it (negative: below): the axis of the roller that carries "
                  "the pipe, of a V where its rollers meet",
                  or_else("0"), fixed_in_restart),
           list("points", vec3("", length),
                "instead of `at`: that place of each box in the body's frame, in the order in which the pipe "
                "passes them",
                items(1), fixed_in_restart),
           word("type", {"flat", "V", "U", "box"},
                "one roller below; two that rise to both sides; one below and one at each side; the same "
                "with one above",
                required, fixed_in_restart),
           number("roller_diameter", length, "of all its rollers", above(0), required, fixed_in_restart),
           number("roller_length", length,
                  "of the roller below, and so the clear width of a U or a box; of a V each of the two",
                  above(0), required, fixed_in_restart),
           number("side_height", length,
                  "of a U or a box: of the rollers at the sides above the roller below; in a box the roller "
                  "above is there",
                  above(0), fixed_in_restart),
           number("angle_deg", angle, "of a V: of each roller above the horizontal", above(0),
                  at_most(80 * M_PI / 180), fixed_in_restart),
           one_of("normal_stiffness", {word("", {"auto"}), number("", point_stiffness, above(0))},
                  "of a roller: force over penetration where that is 1 % of the pipe's radius; `auto` is "
                  "raised in the run as far as tensions and speeds need it",
                  or_else("auto"), fixed_in_restart),
           relative_damping(), friction(&Volume::friction)},
          either({{{"at", "above_path"}, {"at"}}, "points"})),
      "roller boxes; several with the same rollers are one entry", required, items(1));
}

}  // namespace

Key supports() {
  return names("supports",
               map("<group>",
                   {reference("body", "bodies",
                              "body they are fixed to: a barge, a stinger; path and points are in its frame",
                              or_else_note("none: fixed in space"), fixed_in_restart),
                    list("on", reference("", "lines"),
                         "straight beams of a structure that carries them: each box is fixed to the nearest "
                         "node of these, where path or points have it in the body's frame at the start",
                         items(1), or_else_note("none: the boxes are fixed to the body"), fixed_in_restart),
                    reference("line", "lines", "line that is laid over them", or_else_note("the only line")),
                    path(), boxes()}),
               "Roller boxes of ramps and stingers, by groups: rollers that turn without friction, in the "
               "order in which the line passes them. Each is called `<group> <number>`.",
               or_else("{}"));
}

}  // namespace hawser::model::schema_build
