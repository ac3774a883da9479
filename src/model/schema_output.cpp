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
    throw std::invalid_argument("xdmf only describes the data of an hdf5 file; list hdf5 as well");
}

Key clearances() {
  return list(
      {"clearances", &Output::clearances},
      map("",
          {reference({"line", &Clearance::line}, "lines", "line", required),
           reference({"other_line", &Clearance::other_line}, "lines", "distance to this line ..."),
           reference({"volume", &Clearance::volume}, "volumes", "... or to this volume"),
           name({"name", &Clearance::name}, "name in the results", or_else_note("`<line> to <other>`"))},
          either({"other_line", "volume"})),
      "smallest distances between surfaces, recorded at every step; negative for a penetration",
      or_else("[]"));
}

Key clashes() {
  return one_of(
      {"clashes", &Output::clashes},
      {boolean({"", &ClashOutput::enabled}),
       map("",
           {number({"merge_gap", &ClashOutput::merge_gap}, time,
                   "a pair that separates for less than this is still in the same clash", at_least(0),
                   or_else("0.1")),
            number({"merge_length", &ClashOutput::merge_length}, length,
                   "contact points of a pair that are closer than this along a line belong to one clash",
                   above(0), or_else_note("4 contact diameters of the line")),
            integer({"rows", &ClashOutput::rows},
                    "rows of the table at the end of a run, which lists the clashes with the largest forces",
                    in_range(0, 1000), or_else("20"))})},
      "the clash report: all pairs in contact with place, time, force, impulse, energy and penetration; "
      "`false`: none",
      or_else("true"));
}

}  // namespace

Key output() {
  return map(
      {"output", &Case::output},
      {text({"file", &Output::file}, "results (.h5), relative to the case file",
            or_else_note("`<case>.h5` beside the case file")),
       number({"every", &Output::every}, time, "time between outputs of fields", above(0),
              or_else_note("1/100 of the run")),
       number({"checkpoint_every", &Output::checkpoint_every}, time, "time between checkpoints", above(0),
              or_else_note("with outputs of fields, as far as they take at most 2 % of the computing "
                           "time; always at the end of a run")),
       list({"format", set_by<Output>(format)}, word("", {"hdf5", "xdmf"}),
            "file formats: `hdf5` is always written; `xdmf` in addition is for ParaView",
            or_else("[hdf5, xdmf]"), items(1, 2)),
       boolean({"single_precision", &Output::single_precision},
               "write fields, also those at the ends of lines, with 7 digits in half the space; histories, "
               "statistics and checkpoints always have 16",
               or_else("false")),
       list({"histories", &Output::histories},
            map("",
                {reference({"line", &HistoryPoint::line}, "lines", "line"),
                 arc({"at", &HistoryPoint::at}, "arc length from end A"),
                 reference({"body", &HistoryPoint::body}, "bodies",
                           "a floating body, in place of a point of a line"),
                 reference({"volume", &HistoryPoint::volume}, "volumes",
                           "a volume, for the force and moment that it exerts on lines"),
                 name({"name", &HistoryPoint::name}, "name in the results",
                      or_else_note("`<line>@<at>`, `<body>` or `<volume>`"))},
                either({{{"line", "at"}, {"line", "at"}}, "body", "volume"})),
            "points of lines whose motion, tension and contact are recorded at every step, and bodies and "
            "volumes",
            or_else("[]")),
       number({"history_every", &Output::history_every}, time,
              "time between rows of all histories; each row is at the end of the step that reaches this time",
              at_least(0), or_else_note("every step")),
       boolean({"touchdowns", &Output::touchdowns},
               "a history of the touchdown points of every line, if there is a seabed", or_else("true")),
       boolean({"statistics", &Output::statistics},
               "minimum, maximum, mean and standard deviation of node fields over every step",
               or_else("true")),
       number({"statistics_from", &Output::statistics_from}, time,
              "time from which statistics are taken, for example the end of the ramp", at_least(0),
              or_else("0")),
       clearances(), clashes()},
      "Results.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
