// Metadata of an output field. Path of a field: `fields()` of a term declares it with the function that
// computes its values at the nodes (example: terms/line_structure_fields.cpp). NodeFields::fill
// (record/node_fields.cpp) calls that function, after every step if statistics, histories or extremes need
// it, else at outputs. At an output io::ResultsFile::write_output writes one row of the data set
// `fields/NAME`; its attributes, and those that report, ParaView and tables use, are the members below.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "hawser/advice/energy.hpp"

namespace hawser {

struct Field {
  // Whether the history of a point of a line has a column for it.
  enum class History {
    no,
    yes,
    after_end_columns  // after the columns that only ends of lines have
  };
  // Output in the report along each line: none, a row in the table of extremes, or also a range graph.
  enum class Report { no, table, graph };

  std::string name;        // in files: "bending_moment"
  std::string unit;        // SI; "1" or empty: dimensionless
  int components = 1;      // 1, or 3 for a vector in space axes
  std::string label = {};  // in tables, figures and warnings; empty: the name, with blanks for underscores
  History history = History::no;
  bool statistics = false;   // minimum, maximum, mean and deviation over every step
  bool at_stations = false;  // also recorded at stations, which stay with the feeder (record/stations.hpp)
  // Name of its row "max EXTREME" in the table of extremes. Fields of one line with the same name share the
  // row.
  std::string extreme = {};
  bool smallest = false;  // it also has a row "min EXTREME"
  bool of_beams = false;  // 0 along cables, whose lines have no row
  Report report = Report::no;
  int order =
      100;  // of rows in tables and reports, smallest first; of equal ones in the order of declaration
  // The field is the contact force [N] of a support of the line: where it is not zero, the line does not hang
  // freely.
  bool is_support_force = false;
  // The field is not zero where the line touches this.
  advice::ContactWith contact_with = advice::ContactWith::nothing;
  // For a utilisation (the used share of what is allowed): the ratio in words ("effective tension over the
  // breaking load of the line type"), and the sentence for a line where it exceeds 1 ("pulled with more than
  // its breaking load").
  std::string meaning = {}, exceeded = {};
};

// Index of the field with that name; -1: none.
int find_field(std::span<const Field> fields, std::string_view name);

// Name for readers: "bending moment".
std::string label_of(const Field& field);

}  // namespace hawser
