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

struct Bracket {
  char kind;
  std::size_t line;
};

// What is open where a line ends.
struct Open {
  std::vector<Bracket> brackets;
  std::optional<YamlFault>
      fault;  // the first bracket that does not fit, quote that is not closed in its line
};

// A line without its comment and the blanks at its end.
struct Line {
  std::string text;
  std::size_t indent = 0;  // of blanks and tabs
  bool flow = false;       // begins within brackets
  bool empty() const { return indent == text.size(); }
  bool tab() const { return text.substr(0, indent).find('\t') != std::string::npos; }
};

int number(std::size_t line) { return static_cast<int>(line) + 1; }

// Whether the line begins with a key, which no value of several lines does.
bool begins_with_key(const std::string& raw) {
  const std::size_t at = raw.find_first_not_of(' ');
  if (at == std::string::npos) return false;
  const std::size_t end =
      raw.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", at);
  return end != std::string::npos && end > at && raw[end] == ':' &&
         (end + 1 == raw.size() || raw[end + 1] == ' ');
}

void close(char c, std::size_t line, Open& open) {
  const char opens = c == ']' ? '[' : '{';
  if (!open.brackets.empty() && open.brackets.back().kind == opens) return open.brackets.pop_back();
  if (open.fault) return;
  open.fault = {number(line),
                open.brackets.empty()
                    ? fmt::format("the bracket '{}' closes none that is open", c)
                    : fmt::format("the bracket '{}' does not close the '{}' of line {}", c,
                                  open.brackets.back().kind, number(open.brackets.back().line))};
}

// Up to a '#' after a blank. Brackets in quotes do not count.
Line cut(const std::string& raw, std::size_t line, Open& open) {
  Line out;
  out.flow = !open.brackets.empty();
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
    if (c == '[' || c == '{') open.brackets.push_back({c, line});
    if (c == ']' || c == '}') close(c, line, open);
  }
  if (quote && !open.fault)
    open.fault = {number(line),
                  fmt::format("the quote {} that opens in this line is not closed in it", quote)};
  out.text = raw.substr(0, end);
  out.text.erase(out.text.find_last_not_of(" \t\r") + 1);
  out.indent = std::min(out.text.find_first_not_of(" \t"), out.text.size());
  return out;
}

// The lines, and the first bracket or quote that does not fit. A bracket is open for good where a line after
// it begins with a key, as far out as its own.
std::vector<Line> lines_of(const std::string& text, std::optional<YamlFault>& unfit) {
  std::vector<Line> out;
  Open open;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string raw = text.substr(at, end - at);
    const bool ends = end == text.size();
    if (!open.brackets.empty() && !open.fault &&
        (ends ||
         (begins_with_key(raw) && raw.find_first_not_of(' ') <= out[open.brackets.front().line].indent)))
      open.fault = {
          number(open.brackets.back().line),
          fmt::format("the bracket '{}' that opens in this line is not closed", open.brackets.back().kind)};
    out.push_back(cut(raw, out.size(), open));
    at = end + 1;
  }
  unfit = open.fault;
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
  std::optional<YamlFault> unfit;
  const std::vector<Line> lines = lines_of(text, unfit);
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
  if (unfit && unfit->line <= line) return unfit;
  return wrong_indent(lines, last - 1);
}

}  // namespace hawser::io
