// What is known of a field beside its values. Said once, where the field is declared (fields() of a force
// term, for example in terms/structure.cpp); everything that shows fields goes by it.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hawser {

struct Field {
  // Whether a history of a point of a line has it as a column.
  enum class History {
    no,
    yes,
    behind_ends
  };  // behind_ends: behind those columns that only ends of lines have
  // What the report of a run has of it along each line: a row of its table of extremes, and a range graph.
  enum class Report { no, table, graph };

  std::string name;        // in files: "bending_moment"
  std::string unit;        // SI; "1" or empty: a number without one
  int components = 1;      // 1, or 3 of a vector in space axes
  std::string label = {};  // in tables, figures and warnings; empty: the name, with blanks for underscores
  History history = History::no;
  bool statistics = false;   // least, largest, mean and deviation over every step
  bool at_stations = false;  // of a line that is fed the same at places that stay with its feeder
  // Has the row "max EXTREME" in the table of extremes; fields of one line that say the same share it.
  std::string extreme = {};
  bool smallest = false;  // and a row "min EXTREME"
  Report report = Report::no;
  int order = 100;  // in tables and reports, smallest first; then as they were declared
  bool carries =
      false;  // N, what something that a line lies on or in exerts on it: it does not hang freely there
  // Of a utilisation, the share of what is allowed that is used: what it is of ("effective tension over the
  // breaking load of the line type"), and what a line is where it is more than 1 ("pulled with more than its
  // breaking load").
  std::string meaning = {}, exceeded = {};
};

// The place of the field of that name; -1: there is none.
int find_field(std::span<const Field> fields, std::string_view name);

// As people read it: "bending moment".
std::string label_of(const Field& field);

}  // namespace hawser
