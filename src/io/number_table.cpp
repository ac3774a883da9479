// Reading of number tables by zlib, which passes uncompressed files through.
#include "number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "hawser/io/input_file.hpp"

namespace hawser::io {
namespace {

std::string unpacked(const std::string& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::string text;
  std::vector<char> part(1 << 16);
  while (true) {
    const int count = gzread(file.get(), part.data(), static_cast<unsigned>(part.size()));
    if (count < 0) throw std::runtime_error(path + ": is damaged: it cannot be unpacked");
    if (count == 0) break;
    text.append(part.data(), static_cast<size_t>(count));
    if (static_cast<double>(text.size()) > 1e6 * kMostTable)
      throw std::runtime_error(fmt::format("{}: has more than {:g} MB unpacked", path, kMostTable));
  }
  int error = 0;
  const char* message = gzerror(file.get(), &error);
  if (error != Z_OK && error != Z_STREAM_END)
    throw std::runtime_error(fmt::format("{}: is truncated or damaged ({})", path, message));
  return text;
}

// False if a word of the line is no number. Fortran writes some exponents with D.
bool numbers_of(std::string line, std::vector<double>& to) {
  for (size_t i = 1; i < line.size(); ++i)
    if ((line[i] == 'D' || line[i] == 'd') &&
        (std::isdigit(static_cast<unsigned char>(line[i - 1])) || line[i - 1] == '.'))
      line[i] = 'e';
  const char* at = line.c_str();
  while (true) {
    while (*at == ' ' || *at == '\t' || *at == '\r' || *at == ',') ++at;
    if (*at == '\0') return true;
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || !std::isfinite(value)) return false;
    to.push_back(value);
    at = end;
  }
}

// True if a line has as many words between blanks as a row, and one of them is a number with a decimal comma.
bool has_decimal_commas(const std::string& line, const std::vector<size_t>& columns) {
  if (line.find(',') == std::string::npos) return false;
  std::istringstream words(line);
  size_t count = 0;
  bool comma = false;
  for (std::string word; words >> word; ++count)
    for (size_t i = 1; i + 1 < word.size(); ++i)
      comma = comma || (word[i] == ',' && std::isdigit(static_cast<unsigned char>(word[i - 1])) &&
                        std::isdigit(static_cast<unsigned char>(word[i + 1])));
  return comma && std::count(columns.begin(), columns.end(), count) > 0;
}

// Number of words of a line, and of those that begin like numbers.
struct Words {
  size_t all = 0, numbers = 0;
};
Words words_of(const std::string& line) {
  constexpr const char* kBlank = " \t\r,";
  Words words;
  for (size_t at = line.find_first_not_of(kBlank); at != std::string::npos; ++words.all) {
    char* end = nullptr;
    std::strtod(line.c_str() + at, &end);
    words.numbers += end != line.c_str() + at;
    at = line.find_first_not_of(kBlank, line.find_first_of(kBlank, at));
  }
  return words;
}

// Lengths of the lines of rows, by the number of their values.
class RowLengths {
 public:
  // True if the line is shorter than the earlier rows with as many values, which all have one length:
  // programs write their numbers in columns of fixed width.
  bool shorter(const std::string& line, size_t values) {
    constexpr int kFew = 3;  // rows
    Length& of_rows = lengths_[values];
    const size_t length = line.find_last_not_of(" \t\r") + 1;
    const bool out = of_rows.rows >= kFew && of_rows.equal && length < of_rows.length;
    of_rows.equal = of_rows.equal && (of_rows.rows == 0 || length == of_rows.length);
    of_rows.length = length;
    ++of_rows.rows;
    return out;
  }

 private:
  struct Length {
    int rows = 0;
    size_t length = 0;
    bool equal = true;
  };
  std::map<size_t, Length> lengths_;
};

}  // namespace

std::string number_table_path(const std::string& path) {
  for (const char* ending : {"", ".gz"})
    if (std::error_code error; std::filesystem::exists(path + ending, error)) return path + ending;
  return "";
}

NumberTable read_number_table(const std::string& path, const std::vector<size_t>& columns) {
  NumberTable table;
  table.path = number_table_path(path);
  if (table.path.empty()) return table;
  if (const std::string why = unreadable(table.path, "table", kMostTable); !why.empty())
    throw std::runtime_error(table.path + ": " + why);
  const std::string text = unpacked(table.path);
  if (is_utf16(text)) throw std::runtime_error(table.path + ": is a text in UTF-16: save it in UTF-8");
  RowLengths lengths;
  size_t from = mark_length(text);
  for (int line = 1; from < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', from), text.size());
    NumberRow row{line, {}};
    const std::string words = text.substr(from, end - from);
    const bool numbers = numbers_of(words, row.values);
    from = end + 1;
    const bool unended = from >= text.size() && text.back() != '\n';
    if (numbers && row.values.empty()) continue;
    const auto fits = [&columns](size_t count) {
      return std::count(columns.begin(), columns.end(), count) > 0;
    };
    if (numbers && has_decimal_commas(words, columns))
      throw std::runtime_error(
          fmt::format("{}:{}: its numbers have decimal commas: give them decimal points", table.path, line));
    if (numbers && fits(row.values.size())) {
      if (lengths.shorter(words, row.values.size()) && unended)
        throw std::runtime_error(fmt::format(
            "{}:{}: the last row is shorter than the others and ends without a line break: is the "
            "file truncated? If not, end the row with a line break",
            table.path, line));
      table.rows.push_back(std::move(row));
      continue;
    }
    // Before the first row, a line whose words are mostly numbers is a faulty row; else it is a title.
    const Words count = words_of(words);
    if (table.rows.empty() && !(fits(count.all) && 2 * count.numbers > count.all)) continue;
    throw std::runtime_error(fmt::format("{}:{}: a row of this file has {} numbers, but this one has {}{}{}",
                                         table.path, line, fmt::join(columns, " or "), row.values.size(),
                                         numbers ? "" : " and something that is no number",
                                         unended ? ": is the file truncated?" : ""));
  }
  if (table.rows.empty())
    throw std::runtime_error(
        fmt::format("{}: has no row of {} numbers", table.path, fmt::join(columns, " or ")));
  return table;
}

}  // namespace hawser::io
