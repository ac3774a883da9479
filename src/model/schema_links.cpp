// Keys of links: springs and dampers between two points.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key link_end(Head head) {
  return map(std::move(head),
             {vec3({"anchor", &LinkEnd::at}, length, "this fixed point in space"),
              reference({"body", &LinkEnd::body}, "bodies", "this body ..."),
              reference({"line", &LinkEnd::line}, "lines", "a node of this line ..."),
              one_of("at",
                     {vec3({"", &LinkEnd::at}, length), number({"", &LinkEnd::arc}, length, at_least(0)),
                      word({"", &LinkEnd::arc}, {{"end_a", 0}, {"end_b", kEndB}})},
                     "... at this point of the body's frame, or at this arc length of the line from end A")},
             "where this end is attached", required, either({"anchor", "body", "line"}));
}

}  // namespace

Key links() {
  return map_by_name(
      {"links", &Case::links},
      map("<link>",
          {link_end({"end_a", &Link::end_a}), link_end({"end_b", &Link::end_b}),
           number({"stiffness", within(&Link::law, &LinkLaw::stiffness)}, point_stiffness,
                  "stiffness of a linear spring", above(0), or_else_note("0")),
           rows("force_table",
                "in place of `stiffness`: tension against elongation, `[[m, N], ...]`: an increasing curve "
                "through the rows, linear beyond them",
                items(2)),
           number({"rest_length", within(&Link::law, &LinkLaw::rest_length), set(&Link::rest_given, true)},
                  length, "length without elongation", at_least(0),
                  or_else_note("distance between its ends in the start shape")),
           number({"damping", within(&Link::law, &LinkLaw::damping)}, point_damping,
                  "tension per speed of lengthening", above(0), or_else_note("0")),
           rows("damping_table",
                "in place of `damping`: tension against that speed, `[[m/s, N], ...]`: an increasing curve "
                "through zero and the rows; without negative rows it is symmetric",
                items(1)),
           boolean({"tension_only", within(&Link::law, &LinkLaw::tension_only)},
                   "the link goes slack and does not push", or_else("false"))},
          at_most_one_of({"stiffness", "force_table"}), fixed_in_restart),
      "Springs and dampers along the straight line between two points, by name: heave compensators, links, "
      "fender springs ([theory](../theory/links.md)).",
      or_else("{}"));
}

}  // namespace hawser::model::schema_build
