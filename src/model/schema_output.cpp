// The keys of what a run leaves behind.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key clearances() {
  return list("clearances",
              map("",
                  {reference("line", "lines", "line").is_required(),
                   reference("other_line", "lines", "its distance to this line ..."),
                   reference("volume", "volumes", "... or to this volume"),
                   make(Type::name, "name", "name in the results").or_else_note("`<line> to <other>`")},
                  "")
                  .either({{{"other_line"}, {"other_line"}}, {{"volume"}, {"volume"}}}, true),
              "smallest distances between surfaces, kept at every step; negative where they press in")
      .or_else("[]");
}

Key clashes() {
  return one_of("clashes",
                {boolean(""),
                 map("",
                     {number("merge_gap", time, "a pair that parts for less is still in the same clash")
                          .at_least(0)
                          .or_else("0.1"),
                      number("merge_length", length,
                             "places that touch nearer to each other along a line than this are one clash")
                          .above(0)
                          .or_else_note("4 contact diameters of the line"),
                      integer("rows", "of the table at the end of a run: those with the largest forces")
                          .at_least(0)
                          .at_most(1000)
                          .or_else("20")},
                     "")},
                "the clash report: every pair that touches, when and where, with force, impulse, energy and "
                "penetration; `false`: none")
      .or_else("true");
}

}  // namespace

Key output() {
  return map("output",
             {text("file", "results (.h5), relative to the case file")
                  .or_else_note("`<case>.h5` beside the case file"),
              number("every", time, "time between fields").above(0).or_else_note("100 outputs a run"),
              number("checkpoint_every", time, "time between checkpoints")
                  .above(0)
                  .or_else_note("with every output"),
              list("format", word("", {"hdf5", "xdmf"}),
                   "`hdf5` is always written; `xdmf` beside it is what ParaView "
                   "opens")
                  .or_else("[hdf5, xdmf]")
                  .items(1, 2),
              boolean(
                  "single_precision",
                  "fields, those at the ends of lines too, have 7 digits and take half the space; histories, "
                  "statistics and checkpoints have all 16")
                  .or_else("false"),
              list("histories",
                   map("",
                       {reference("line", "lines", "line"), arc("at", "arc length from end A"),
                        reference("body", "bodies", "instead of a point of a line: a floating body"),
                        make(Type::name, "name", "name in the results")
                            .or_else_note("`<line>@<at>` or `<body>`")},
                       "")
                       .either({{{"line", "at"}, {"line", "at"}}, {{"body"}, {"body"}}}, true),
                   "points whose motion, tension and contact are kept at every step")
                  .or_else("[]"),
              number("history_every", time,
                     "time between rows of all histories, each at the end of the step that reaches it")
                  .at_least(0)
                  .or_else_note("every step"),
              boolean("touchdowns", "a history of every line's touchdown points, where there is a seabed")
                  .or_else("true"),
              boolean("statistics",
                      "minimum, maximum, mean and standard deviation of node fields over every step")
                  .or_else("true"),
              number("statistics_from", time,
                     "time from which statistics count, for example the end of the ramp")
                  .at_least(0)
                  .or_else("0"),
              clearances(), clashes()},
             "Results.")
      .or_else("{}");
}

}  // namespace hawser::model::schema_build
