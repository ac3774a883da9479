// The keys of links: springs and dampers between two points.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key link_end(std::string name) {
  return map(std::move(name),
             {vec3("anchor", length, "fixed at this point in space"),
              reference("body", "bodies", "at a point of this body ..."),
              reference("line", "lines", "at the nearest node of this line ..."),
              one_of("at", {vec3("", length), number("", length).at_least(0), word("", {"end_a", "end_b"})},
                     "... a point of the body's frame, or an arc length of the line from end A")},
             "what it is fixed to there")
      .either({{{"anchor"}, {"anchor"}}, {{"body"}, {"body"}}, {{"line"}, {"line"}}}, true);
}

Key rows(std::string name, std::string about) {
  return list(std::move(name), list("", number("", none), "").items(2, 2), std::move(about));
}

}  // namespace

Key links() {
  return names(
             "links",
             map("<link>",
                 {link_end("end_a").is_required(), link_end("end_b").is_required(),
                  number("stiffness", point_stiffness, "of a linear spring").above(0).or_else_note("0"),
                  rows(
                      "force_table",
                      "or the tension over the elongation, `[[m, N], ...]`: a rising curve through the rows, "
                      "straight beyond them")
                      .items(2),
                  number("rest_length", length, "from which the elongation counts")
                      .at_least(0)
                      .or_else_note("the distance between its ends in the start shape"),
                  number("damping", point_damping, "tension for the speed at which it lengthens")
                      .above(0)
                      .or_else_note("0"),
                  rows("damping_table",
                       "or the tension over that speed, `[[m/s, N], ...]`: a rising curve through zero and "
                       "the "
                       "rows; without negative rows the same both ways")
                      .items(1),
                  boolean("tension_only", "it goes slack and never pushes").or_else("false")},
                 "")
                 .either({{{"stiffness"}, {}}, {{"force_table"}, {}}}, false),
             "Springs and dampers between two points, along the straight line that joins them, by name: "
             "heave "
             "compensators, links, fender springs ([theory](../theory/links.md)).")
      .or_else("{}");
}

}  // namespace hawser::model::schema_build
