// Common parts of the case reader: file paths, tables of numbers and motion tables.
#include "hawser/io/case_reader_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string_view>

#include "hawser/advice/motion_tables.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/model/increasing.hpp"
#include "hawser/model/nearest.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::io {

using model::refuse;
using model::Value;
namespace fs = std::filesystem;

namespace {

// True if a comma has no number before it but one after it. Commas at the end of a row are accepted: exports
// of spreadsheets have them.
bool misses_a_number(std::string_view row) {
  bool open = true, missing = false;  // no number since the last comma; a comma without number was read
  for (const char c : row) {
    if (c == ',') {
      missing = missing || open;
      open = true;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      if (missing) return true;
      open = false;
    }
  }
  return false;
}

// What to change in a file with a word that is no number. at_start: no number is before it.
std::string_view table_hint(const std::string& word, bool at_start) {
  if (word.find(';') != std::string::npos) return "; separate numbers by blanks or commas";
  return at_start ? "; begin a line of titles with '#'" : "";
}

}  // namespace

FileRows read_rows(const std::string& path, const Value& at) {
  if (const std::string why = unreadable(path, "table", kMostTable); !why.empty())
    refuse(at, path + ": " + why);
  std::ifstream in(path);
  if (!in) refuse(at, path + ": cannot be read");
  FileRows out;
  std::string line;
  for (int n = 1; std::getline(in, line); ++n) {
    if (n == 1) {
      if (is_utf16(line)) refuse(at, "{}: is a text in UTF-16; save it as UTF-8", path);
      line.erase(0, mark_length(line));
    }
    line = line.substr(0, line.find('#'));
    if (misses_a_number(line)) refuse(at, "{}:{}: a number is missing before a comma", path, n);
    for (char& c : line)
      if (c == ',' || c == '\t' || c == '\r') c = ' ';
    std::vector<double> row;
    std::istringstream words(line);
    for (std::string w; words >> w;) {
      const model::Quantity q = model::parse_quantity(w, model::Dimension::none);
      if (q.status == model::Quantity::Status::out_of_range)
        refuse(at, "{}:{}: {} is out of range; a number is 0 or between {:g} and {:g} in size", path, n,
               model::quote(w), model::kSmallest, model::kLargest);
      if (q.status != model::Quantity::Status::ok)
        refuse(at, "{}:{}: {} is no finite number{}", path, n, model::quote(w),
               table_hint(w, out.rows.empty() && row.empty()));
      row.push_back(q.si);
    }
    if (row.empty()) continue;
    out.rows.push_back(std::move(row));
    out.lines.push_back(n);
  }
  return out;
}

std::string CaseSource::absolute(const std::string& path) const {
  return (fs::path(directory) / fs::path(path)).lexically_normal().string();
}

std::string CaseSource::input(const std::string& path) const {
  std::string named = absolute(path);
  if (inputs && std::find(inputs->begin(), inputs->end(), named) == inputs->end()) inputs->push_back(named);
  return named;
}

void CaseSource::refuse(const Value& v, const std::string& key, const std::string& text) const {
  model::fail(file, v.line, key, text);
}

std::string other_units(double size, const SizeLimits& limits, const model::Case& c) {
  double thin = 0;
  for (const model::Line& l : c.lines)
    for (const model::Section& s : l.sections) {
      const double d = c.line_type(s.type).contact_diameter;
      thin = thin > 0 ? std::min(thin, d) : d;
    }
  const bool beside = thin > 0 && (size > limits.max_ratio * thin || size < limits.min_ratio * thin);
  if (size <= limits.max && !beside) return "";
  return fmt::format("is {:.4g} m large{}; is it in other units than metres?", size,
                     thin > 0
                         ? fmt::format(", {:.3g} times the contact diameter of the thinnest line ({:.4g} m)",
                                       size / thin, thin)
                         : "");
}

Vec3 as_vec3(const Value& v) { return {v.items[0].number, v.items[1].number, v.items[2].number}; }

InputRows read_input_rows(const Value& v, const CaseSource& source) {
  const bool from_file = v.has("file");
  InputRows given{v[from_file ? "file" : "rows"], {}};
  if (from_file) {
    given.rows = read_rows(source.input(given.at.text), given.at).rows;
    return given;
  }
  for (const Value& r : given.at.items) {
    std::vector<double>& row = given.rows.emplace_back();
    for (const Value& x : r.items) row.push_back(x.number);
  }
  return given;
}

void refuse_rows(const InputRows& given, const std::string& text) {
  const bool in_file = given.at.kind == Value::Kind::scalar;
  refuse(given.at, in_file ? given.at.text + ": " + text : text);
}

void check_increase(const InputRows& given, size_t i, std::string_view quantities, std::string_view unit,
                    double tolerance) {
  if (i == 0) return;
  const std::string fault =
      model::increase_fault(quantities, unit, given.rows[i - 1][0], given.rows[i][0], tolerance);
  if (!fault.empty()) refuse_rows(given, "{}: row {}", fault, i + 1);
}

namespace {

// Fraction of a column's range; a sine with eleven or more rows per period stays within it.
constexpr double kOvershoot = 0.02;

// Notes the largest overshoot of a spline beyond its neighbouring rows.
void note_overshoot(const model::TableMotion& m, const std::string& key, std::vector<std::string>& notes) {
  RowCurve::Overshoot worst;
  bool in_rotation = false;
  double worst_ratio = 0;
  size_t places = 0;
  for (const std::vector<Vec3>* rows : {&m.offset, &m.rotation}) {
    if (rows->empty()) continue;
    Vec3 lowest = rows->front();
    Vec3 highest = lowest;
    for (const Vec3& x : *rows) {
      lowest = lowest.cwiseMin(x);
      highest = highest.cwiseMax(x);
    }
    for (const RowCurve::Overshoot& o : RowCurve(m.time, *rows, m.between).overshoots(kOvershoot)) {
      ++places;
      const double span = highest[o.component] - lowest[o.component];
      const double ratio = span > 0 ? o.excess / span : 0;
      if (ratio > worst_ratio) {
        worst = o;
        worst_ratio = ratio;
        in_rotation = rows == &m.rotation;
      }
    }
  }
  if (!(worst_ratio > 0)) return;
  notes.push_back(advice::spline_beyond_rows(key, m.time[worst.row], m.time[worst.row + 1], worst,
                                             in_rotation, worst_ratio, places - 1));
}

}  // namespace

void read_motion_table(const Value& table, const CaseSource& source, model::TableMotion& m,
                       std::vector<std::string>& notes) {
  const InputRows given = read_input_rows(table, source);
  const auto& rows = given.rows;
  if (rows.size() < 2) refuse_rows(given, "a table of motion needs at least 2 rows, found {}", rows.size());
  const std::size_t columns = rows.front().size();
  if (columns != 4 && columns != 7)
    refuse_rows(given, "a row of motion has 4 numbers (t, x, y, z) or 7 (and a rotation vector), found {}",
                columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != columns)
      refuse_rows(given, "row {} has {} numbers, but row 1 has {}", i + 1, r.size(), columns);
    check_increase(given, i, "times", "s");
    m.time.push_back(r[0]);
    m.offset.emplace_back(r[1], r[2], r[3]);
    if (columns == 7) m.rotation.push_back(Vec3(r[4], r[5], r[6]) * (std::numbers::pi / 180));
  }
  note_overshoot(m, table.where, notes);
}

}  // namespace hawser::io
