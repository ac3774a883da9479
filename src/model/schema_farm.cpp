// Keys of farms: platforms from files of their own and their positions. Read by src/io/case_reader_farm.cpp.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key rows_of_places() {
  return map(
      "rows",
      {integer("rows", "number of rows", in_range(1, 1e4), required),
       integer("columns", "number of places in a row", in_range(1, 1e5), required),
       list("spacing", number("", length, above(0)), "distance between places in a row, and between rows",
            required, items(2, 2)),
       list("from", number("", length), "x and y of the first place", items(2, 2), or_else("[0, 0]")),
       number("direction_deg", angle,
              "direction of the rows, anticlockwise from +x; the next row is to the left", or_else("0")),
       number("stagger", length, "offset of every second row along its direction", or_else("0"))},
      "places in rows, numbered along the first row, then along the second");
}

Key platform(Head head) {
  return map(
      std::move(head),
      {text("of",
            "case file of the platform, beside the case: each place gets its `bodies`, `volumes`, "
            "`supports`, `joints`, `lines` and `links`; its `line_types` are shared by the whole case",
            required),
       one_of("at",
              {list("", list("", number("", none), items(2, 3)), items(1)),
               map_by_name("", list("", number("", none), items(2, 3)), items(1))},
              "x and y [m] and optionally heading [deg] of each place, as a list, `[[x, y], [x, y, heading], "
              "...]`, or by name, `{A1: [x, y], ...}`"),
       rows_of_places(),
       text("file",
            "text file beside the case: columns x, y [m] and optionally heading [deg]; blanks or commas "
            "between, `#` starts a comment"),
       name("name", "prefix of places without names, followed by their number: T1, T2, ...", or_else("T")),
       number("heading_deg", angle,
              "heading of places that have none: direction of the x axis of the platform's file, "
              "anticlockwise from +x",
              or_else("0"))},
      either({"at", "rows", "file"}));
}

}  // namespace

Key farm() {
  return one_of(
      "farm", {platform(""), list("", platform(""), items(1))},
      "Platforms described in a separate file and placed at many positions; a list of such entries for "
      "several kinds of platforms. The line `mooring 3` at the place `T12` is called `T12/mooring 3`.");
}

}  // namespace hawser::model::schema_build
