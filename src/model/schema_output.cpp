// Keys of the output of a run.
#include <algorithm>
#include <stdexcept>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

void format(Output& o, const Value& v) {
  const auto lists = [&v](const char* w) {
    return std::any_of(v.items.begin(), v.items.end(), [&](const Value& f) { return f.is(w); });
  };
  o.xdmf = lists("xdmf");
  if (!lists("hdf5"))
    throw std::invalid_argument("xdmf only describes the numbers of an hdf5 file; list hdf5 as well");
}

Key clearances() {
  return list(
      {"clearances", &Output::clearances},
      map("",
          {reference({"line", &Clearance::line}, "lines", "line", required),
           reference({"other_line", &Clearance::other_line}, "lines", "its distance to this line ..."),
           reference({"volume", &Clearance::volume}, "volumes", "... or to this volume"),
           name({"name", &Clearance::name}, "name in the results", or_else_note("`<line> to <other>`"))},
          either({"other_line", "volume"})),
      "smallest distances between surfaces, kept at every step; negative where they press in", or_else("[]"));
}

Key clashes() {
  return one_of(
      {"clashes", &Output::clashes},
      {boolean({"", &ClashOutput::enabled}),
       map("", {number({"merge_gap", &ClashOutput::merge_gap}, time,
                       "a pair that parts for less is still in the same clash", at_least(0), or_else("0.1")),
                number({"merge_length", &ClashOutput::merge_length}, length,
                       "places that touch nearer to each other along a line than this are one clash",
                       above(0), or_else_note("4 contact diameters of the line")),
                integer({"rows", &ClashOutput::rows},
                        "of the table at the end of a run: those with the largest forces", in_range(0, 1000),
                        or_else("20"))})},
      "the clash report: every pair that touches, when and where, with force, impulse, energy and "
      "penetration; `false`: none",
      or_else("true"));
}

}  // namespace

Key output() {
  return map(
      {"output", &Case::output},
      {text({"file", &Output::file}, "results (.h5), relative to the case file",
            or_else_note("`<case>.h5` beside the case file")),
       number({"every", &Output::every}, time, "time between fields", above(0),
              or_else_note("100 outputs a run")),
       number({"checkpoint_every", &Output::checkpoint_every}, time, "time between checkpoints", above(0),
              or_else_note("with every output")),
       list({"format", by<Output>(format)}, word("", {"hdf5", "xdmf"}),
            "`hdf5` is always written; `xdmf` beside it is what ParaView opens", or_else("[hdf5, xdmf]"),
            items(1, 2)),
       boolean({"single_precision", &Output::single_precision},
               "fields, those at the ends of lines too, have 7 digits and take half the space; histories, "
               "statistics and checkpoints have all 16",
               or_else("false")),
       list({"histories", &Output::histories},
            map("",
                {reference({"line", &HistoryPoint::line}, "lines", "line"),
                 arc({"at", &HistoryPoint::at}, "arc length from end A"),
                 reference({"body", &HistoryPoint::body}, "bodies",
                           "instead of a point of a line: a floating body"),
                 reference({"volume", &HistoryPoint::volume}, "volumes",
                           "or force and moment that this volume exerts on lines"),
                 name({"name", &HistoryPoint::name}, "name in the results",
                      or_else_note("`<line>@<at>`, `<body>` or `<volume>`"))},
                either({{{"line", "at"}, {"line", "at"}}, "body", "volume"})),
            "points whose motion, tension and contact are kept at every step", or_else("[]")),
       number({"history_every", &Output::history_every}, time,
              "time between rows of all histories, each at the end of the step that reaches it", at_least(0),
              or_else_note("every step")),
       boolean({"touchdowns", &Output::touchdowns},
               "a history of every line's touchdown points, where there is a seabed", or_else("true")),
       boolean({"statistics", &Output::statistics},
               "minimum, maximum, mean and standard deviation of node fields over every step",
               or_else("true")),
       number({"statistics_from", &Output::statistics_from}, time,
              "time from which statistics count, for example the end of the ramp", at_least(0), or_else("0")),
       clearances(), clashes()},
      "Results.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
