// Rows of numbers from a text file, optionally compressed by gzip with the extension .gz.
#pragma once

#include <string>
#include <vector>

namespace hawser::io {

struct NumberRow {
  int line = 0;  // line number, from 1
  std::vector<double> values;
};

struct NumberTable {
  std::string path;  // of the file read; empty: none found
  std::vector<NumberRow> rows;
};

// `path` or `path`.gz, whichever exists; empty: neither.
std::string number_table_path(const std::string& path);
// Reads the file at number_table_path(). Lines before the first row are titles; a row begins with a number
// and has as many words as one of `columns`. Throws std::runtime_error with a whole sentence if the file is
// unreadable or a later line has a word that is no number or a count that is not in `columns`.
NumberTable read_number_table(const std::string& path, const std::vector<size_t>& columns);

}  // namespace hawser::io
