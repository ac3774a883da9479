// The structure of a results file: made (or made anew, with more room) by one rank in a file of its own
// that then takes the name of the old one in a single step. Inside io only.
#pragma once

#include <hdf5.h>

#include <array>
#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"
#include "hawser/io/results.hpp"

namespace hawser::io {

// Rows or lengths the datasets have.
struct ResultRoom {
  long long outputs = 0, steps = 0;
  long long slot_doubles = 0, slot_text = 0;  // of each of the two checkpoint slots; 0: no slots
  ClashRoom clashes = {};
  long long contacts = 0;  // points of contact
};

// What the file gets beside the rows it keeps: with the last of them these clashes, and the table of the
// summary and the notes and warnings of the run when it is made for the last time.
struct ResultLast {
  const ClashTables& clashes;
  const std::vector<SummaryRow>* summary = nullptr;
  const std::vector<std::string>* messages = nullptr;
};

// The counter that makes rows count. One small aligned write, after the rows are written.
struct ResultCount {
  long long outputs = 0, steps = 0;
};
h5::Id result_count_type();

// Throws std::logic_error where contents contradict themselves. writes: this rank has what rank 0 alone
// writes.
void check_contents(const ResultContents& contents, bool writes);

// A dataset with one row an output, one a step, one a node, or one a point of contact.
enum class RowsBy { output, step, node, contact };
struct RowSet {
  std::string name;
  RowsBy by = RowsBy::output;
  hid_t type = -1;  // of its numbers, in file and memory
  h5::Shape tail;   // shape of one row
  std::string unit;
};
std::vector<RowSet> row_sets(const ResultContents& contents);
std::string field_place(const ResultField& field);
std::string statistics_place(const ResultField& field);

// Numbers in a row of a series.
hsize_t numbers_in_row(const ResultSeries& series);

// "volumes/<name>"; "series/<name>", or "line_series/<name>" of those by line: in the order of the contents.
std::vector<std::string> volume_places(const ResultContents& contents);
std::vector<std::string> series_places(const ResultContents& contents);

// Write `path` anew. `from`: an earlier file whose first `kept` rows, ended `clashes`, `contacts` and newest
// checkpoint are taken over, or empty; one at `path` is then kept (back_up_results). Serial. Throws
// InputError when `from` does not hold the same things, std::runtime_error when the disk fails; the file at
// `path` is then as it was.
void build_results(const std::string& path, const ResultContents& contents, const ResultRoom& room,
                   const std::string& from, const ResultCount& kept, long long clashes, long long contacts,
                   const ResultLast* last);

}  // namespace hawser::io
