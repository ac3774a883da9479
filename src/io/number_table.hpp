// Rows of numbers from a text file that may be packed by gzip, with the ending .gz.
#pragma once

#include <string>
#include <vector>

namespace hawser::io {

struct NumberRow {
  int line = 0;  // of the file, from 1
  std::vector<double> values;
};

struct NumberTable {
  std::string path;  // of the file that was read; empty: there is none
  std::vector<NumberRow> rows;
};

// `path` or `path`.gz. Lines before the first row are titles; a row begins with a number and has as many
// words as one of `columns`. std::runtime_error, a whole sentence, where the file cannot be read, or a later
// line has something else than numbers or another count of them than one of `columns`.
NumberTable read_number_table(const std::string& path, const std::vector<size_t>& columns);

}  // namespace hawser::io
