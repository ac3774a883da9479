// How the lines of a file that is no valid YAML are split into indentation, text and comment, and searched
// for the likely mistake near the place where the parser stopped.
#include "yaml_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "hawser/model/nearest.hpp"

namespace hawser::io {
namespace {

// A line without its comment and the blanks at its end.
struct Line {
  std::string text;
  std::size_t indent = 0;  // of blanks and tabs
  bool flow = false;       // begins within brackets
  bool empty() const { return indent == text.size(); }
  bool tab() const { return text.substr(0, indent).find('\t') != std::string::npos; }
};

// Up to a '#' after a blank; counts brackets. Nothing in quotes counts.
Line cut(const std::string& raw, int& brackets) {
  Line out;
  out.flow = brackets > 0;
  char quote = 0;
  std::size_t end = 0;
  for (; end < raw.size(); ++end) {
    const char c = raw[end], before = end > 0 ? raw[end - 1] : ' ';
    if (quote) {
      if (c == quote) quote = 0;
      continue;
    }
    // Within a word a quote is a letter.
    if ((c == '"' || c == '\'') && std::string_view(" \t[{,:").find(before) != std::string_view::npos)
      quote = c;
    if (c == '#' && (before == ' ' || before == '\t')) break;
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') --brackets;
  }
  out.text = raw.substr(0, end);
  out.text.erase(out.text.find_last_not_of(" \t\r") + 1);
  out.indent = std::min(out.text.find_first_not_of(" \t"), out.text.size());
  return out;
}

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> out;
  int brackets = 0;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(cut(text.substr(at, end - at), brackets));
    at = end + 1;
  }
  return out;
}

// What is said of the first key of a line without a blank after its colon; empty: there is none.
std::string unseparated(const std::string& line) {
  bool start = true;  // at the start of a line, after a '-', or in brackets before a key
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (start && c != ' ' && c != '-')
      if (std::string said = model::missing_blank(std::string_view(line).substr(i)); !said.empty())
        return said;
    start = c == '{' || c == ',' || (start && (c == ' ' || c == '-'));
  }
  return "";
}

std::optional<YamlFault> wrong_indent(const std::vector<Line>& lines, std::size_t at) {
  struct Level {
    std::size_t indent, line;
    bool open;  // its value may follow further in
  };
  std::vector<Level> levels;
  for (std::size_t i = 0; i <= at; ++i) {
    const Line& l = lines[i];
    if (l.empty() || l.flow) continue;
    bool dropped = false;
    while (!levels.empty() && levels.back().indent > l.indent) levels.pop_back(), dropped = true;
    const auto number = [](std::size_t line) { return static_cast<int>(line) + 1; };
    const bool known = !levels.empty() && levels.back().indent == l.indent;
    if (i == at && !known && levels.empty() && dropped)
      return YamlFault{number(i),
                       "the line begins further left than the first one: all top-level keys begin in "
                       "the same column"};
    if (i == at && !known && dropped)
      return YamlFault{
          number(i),
          fmt::format("the line is indented by {} blanks, which no line that it could belong to is "
                      "(line {} is by {}): keys of one map begin in the same column",
                      l.indent, number(levels.back().line), levels.back().indent)};
    if (!known && !levels.empty() && !levels.back().open && i + 1 >= at && l.indent > levels.back().indent)
      return YamlFault{
          number(i),
          fmt::format("the line is indented by {} blanks, but line {} by {}, and that has its value "
                      "already: keys of one map begin in the same column",
                      l.indent, number(levels.back().line), levels.back().indent)};
    if (known) levels.pop_back();
    const char last = l.text.back();
    const bool item = l.text.compare(l.indent, 2, "- ") == 0;
    levels.push_back({l.indent, i,
                      item || last == ':' || last == '-' || last == '|' || last == '>' ||
                          l.text.find(':') == std::string::npos});
    if (item) {
      const std::size_t key = std::min(l.text.find_first_not_of(' ', l.indent + 1), l.text.size() - 1);
      levels.push_back({key, i, last == ':' || l.text.find(':') == std::string::npos});
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<YamlFault> find_yaml_fault(const std::string& text, int line) {
  const std::vector<Line> lines = lines_of(text);
  const std::size_t last = std::min(static_cast<std::size_t>(std::max(line, 1)), lines.size());
  for (std::size_t i = 0; i < last; ++i)
    if (!lines[i].flow && !lines[i].empty() && lines[i].tab())
      return YamlFault{static_cast<int>(i) + 1,
                       "the line is indented with a tab, which YAML does not allow: use blanks"};
  // The parser may notice at the key after.
  std::size_t before = last - 1;
  while (before > 0 && lines[before - 1].empty()) --before;
  for (const std::size_t i : {last - 1, before > 0 ? before - 1 : before})
    if (std::string said = unseparated(lines[i].text); !said.empty())
      return YamlFault{static_cast<int>(i) + 1, std::move(said)};
  return wrong_indent(lines, last - 1);
}

}  // namespace hawser::io
