// Keys of links: springs and dampers between two points.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key link_end(Head head) {
  return map(std::move(head),
             {vec3({"anchor", &LinkEnd::at}, length, "fixed at this point in space"),
              reference({"body", &LinkEnd::body}, "bodies", "at a point of this body ..."),
              reference({"line", &LinkEnd::line}, "lines", "at a node of this line ..."),
              one_of("at",
                     {vec3({"", &LinkEnd::at}, length), number({"", &LinkEnd::arc}, length, at_least(0)),
                      word({"", &LinkEnd::arc}, {{"end_a", 0}, {"end_b", kEndB}})},
                     "... a point of the body's frame, or an arc length of the line from end A")},
             "what it is fixed to there", required, either({"anchor", "body", "line"}));
}

}  // namespace

Key links() {
  return names(
      {"links", &Case::links},
      map("<link>",
          {link_end({"end_a", &Link::end_a}), link_end({"end_b", &Link::end_b}),
           number({"stiffness", within(&Link::law, &LinkLaw::stiffness)}, point_stiffness,
                  "of a linear spring", above(0), or_else_note("0")),
           rows("force_table",
                "or the tension over the elongation, `[[m, N], ...]`: a rising curve through the rows, "
                "straight beyond them",
                items(2)),
           number({"rest_length", within(&Link::law, &LinkLaw::rest_length), set(&Link::rest_given, true)},
                  length, "from which the elongation counts", at_least(0),
                  or_else_note("the distance between its ends in the start shape")),
           number({"damping", within(&Link::law, &LinkLaw::damping)}, point_damping,
                  "tension for the speed at which it lengthens", above(0), or_else_note("0")),
           rows("damping_table",
                "or the tension over that speed, `[[m/s, N], ...]`: a rising curve through zero and the "
                "rows; without negative rows the same both ways",
                items(1)),
           boolean({"tension_only", within(&Link::law, &LinkLaw::tension_only)},
                   "it goes slack and never pushes", or_else("false"))},
          at_most_one({"stiffness", "force_table"}), fixed_in_restart),
      "Springs and dampers between two points, along the straight line that joins them, by name: heave "
      "compensators, links, fender springs ([theory](../theory/links.md)).",
      or_else("{}"));
}

}  // namespace hawser::model::schema_build
