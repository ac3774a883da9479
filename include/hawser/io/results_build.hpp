// Structure of a results file. One rank creates it, also with more capacity later, as a separate file that
// then replaces the old one atomically. Internal to io.
#pragma once

#include <hdf5.h>

#include <array>
#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"
#include "hawser/io/results.hpp"

namespace hawser::io {

// Capacity of the datasets, rows or lengths.
struct ResultRoom {
  long long outputs = 0, steps = 0;
  long long slot_doubles = 0, slot_text = 0;  // of each of the two checkpoint slots; 0: no slots
  ClashRoom clashes = {};
  long long contacts = 0;  // points of contact
};

// Additional contents after the kept rows: the clashes of the last one and, at the end of the run, the
// summary table, notes and warnings.
struct ResultLast {
  const ClashTables& clashes;
  const std::vector<SummaryRow>* summary = nullptr;
  const std::vector<std::string>* messages = nullptr;
};

// Counter that validates rows: one small aligned write after the rows are written.
struct ResultCount {
  long long outputs = 0, steps = 0;
};
h5::Id result_count_type();

// Rows that a file has or takes over from an earlier one: those that the counter validates, and those of the
// tables that grow with them.
struct ValidRows {
  ResultCount count;
  long long clashes = 0;   // that had ended at the last output
  long long contacts = 0;  // points of contact of the outputs
};

// Throws std::logic_error where contents contradict themselves. writes: this rank has the data that only rank
// 0 writes.
void check_contents(const ResultContents& contents, bool writes);

// A dataset with one row an output, one a step, one a node, or one a point of contact.
enum class RowsBy { output, step, node, contact };
struct RowSet {
  std::string name;
  RowsBy rows_by = RowsBy::output;
  hid_t type = -1;  // of its numbers, in file and memory
  h5::Shape tail;   // shape of one row
  std::string unit;
};
std::vector<RowSet> row_sets(const ResultContents& contents);
// Number of rows of a set if there are so many of each kind.
hsize_t rows_in(const RowSet& set, const ResultContents& contents, const ResultCount& count,
                long long contacts);
std::string field_place(const ResultField& field);
std::string statistics_place(const ResultField& field);

// Numbers per row of a series.
hsize_t numbers_in_row(const ResultSeries& series);

// "volumes/<name>"; "series/<name>", or "line_series/<name>" for those by line; in the order of the contents.
std::vector<std::string> volume_places(const ResultContents& contents);
std::vector<std::string> series_places(const ResultContents& contents);

// Writes `path` anew. `from`: an earlier file whose first `kept` rows and checkpoints are taken over, or
// empty; one at `path` is then kept (back_up_results). Serial. Throws InputError if the contents of `from`
// differ, std::runtime_error if the disk fails; the file at `path` is then unchanged.
void build_results(const std::string& path, const ResultContents& contents, const ResultRoom& room,
                   const std::string& from, const ValidRows& kept, const ResultLast* last);

}  // namespace hawser::io
