// Search for the likely fault near the place where the YAML parser stopped, in lines split into indentation,
// text and comment.
#include "yaml_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "hawser/model/nearest.hpp"

namespace hawser::io {
namespace {

// A line without comment and trailing blanks.
struct Line {
  std::string text;
  std::size_t indent = 0;  // blanks and tabs
  bool flow = false;       // begins within brackets or a quote
  bool empty() const { return indent == text.size(); }
  bool tab() const { return text.substr(0, indent).find('\t') != std::string::npos; }
};

int number(std::size_t line) { return static_cast<int>(line) + 1; }

// True if the line begins with a key; a line within a multi-line value does not.
bool begins_with_key(const std::string& raw) {
  const std::size_t at = raw.find_first_not_of(' ');
  if (at == std::string::npos) return false;
  const std::size_t end = raw.find_first_of(" :,#'\"[]{}", at);
  return end != std::string::npos && end > at && raw[end] == ':' &&
         (end + 1 == raw.size() || raw[end + 1] == ' ' || raw[end + 1] == '\r');
}

// Splits a text into lines and finds the first unmatched bracket or quote, counted where a value begins and
// within brackets; lines of a text after | or > are left empty.
class Lines {
 public:
  explicit Lines(const std::string& text) {
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      add(text.substr(at, end - at));
      at = end + 1;
    }
    if (inside()) left_open();
  }
  const std::vector<Line>& all() const { return lines_; }
  const std::optional<YamlFault>& unfit() const { return unfit_; }
  // The line of an unclosed quote, from 0, and its kind.
  const std::optional<std::pair<std::size_t, char>>& open_quote() const { return open_quote_; }

 private:
  struct Open {
    char kind;  // [ { \" or '
    std::size_t line;
  };

  bool inside() const { return !open_.empty(); }
  bool quoted() const { return inside() && (open_.back().kind == '"' || open_.back().kind == '\''); }

  void fault(std::size_t line, std::string text) {
    if (!unfit_) unfit_ = {number(line), std::move(text)};
  }
  void left_open() {
    if (quoted() && !open_quote_) open_quote_ = {open_.back().line, open_.back().kind};
    fault(open_.back().line, fmt::format("the {} {} that opens in this line is not closed",
                                         quoted() ? "quote" : "bracket", open_.back().kind));
    open_.clear();
  }

  void add(const std::string& raw) {
    const std::size_t indent = std::min(raw.find_first_not_of(" \t"), raw.size());
    if (literal_ && (indent == raw.size() || indent > literal_indent_)) {
      lines_.emplace_back();
      return;
    }
    literal_ = false;
    // A bracket stays open for good if a line at its indentation or further out begins with a key.
    if (inside() && begins_with_key(raw) && indent <= lines_[open_.front().line].indent) left_open();
    Line out;
    out.flow = inside();
    out.text = raw.substr(0, scan(raw));
    out.text.erase(out.text.find_last_not_of(" \t\r") + 1);
    out.indent = std::min(out.text.find_first_not_of(" \t"), out.text.size());
    const std::size_t mark = out.text.find_last_not_of("+-0123456789");
    literal_ = !inside() && mark != std::string::npos && mark > 1 && out.text[mark - 1] == ' ' &&
               (out.text[mark] == '|' || out.text[mark] == '>');
    literal_indent_ = out.indent;
    lines_.push_back(std::move(out));
  }

  // Position of the comment of a line, or its length.
  std::size_t scan(const std::string& raw) {
    bool value = true;    // one may begin here: at the start, after "- " and ": ", in brackets after a comma
    bool closed = false;  // the outermost bracket was closed
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const char c = raw[i];
      const char next = i + 1 < raw.size() ? raw[i + 1] : ' ';
      if (quoted()) {
        const char quote = open_.back().kind;
        if ((quote == '"' && c == '\\') || (quote == '\'' && c == '\'' && next == '\''))
          ++i;
        else if (c == quote) {
          open_.pop_back();
          value = false;
          check_after_quote(raw, i);
        }
        continue;
      }
      if (c == '#' && (i == 0 || raw[i - 1] == ' ' || raw[i - 1] == '\t')) return i;
      if (c == ' ' || c == '\t') continue;
      if (value && (c == '"' || c == '\''))
        open_.push_back({c, lines_.size()});
      else if ((c == '[' || c == '{') && (value || inside())) {
        open_.push_back({c, lines_.size()});
        value = true;
      } else if ((c == ']' || c == '}') && (value || inside() || closed)) {
        close(c);
        closed = !inside();
      } else
        value = ((c == ':' || c == '-') && next == ' ') || (c == ',' && inside());
    }
    return raw.size();
  }

  void check_after_quote(const std::string& raw, std::size_t at) {
    const std::size_t next = raw.find_first_not_of(" \t\r", at + 1);
    if (next == std::string::npos || std::string_view(",]}:#").find(raw[next]) != std::string_view::npos)
      return;
    fault(lines_.size(), fmt::format("the quote {} ends in the middle of a text: within such quotes write {}",
                                     raw[at], raw[at] == '"' ? "\\\"" : "''"));
  }

  void close(char c) {
    if (inside() && open_.back().kind == (c == ']' ? '[' : '{')) return open_.pop_back();
    fault(lines_.size(), !inside() ? fmt::format("the bracket '{}' closes none that is open", c)
                                   : fmt::format("the bracket '{}' does not close the '{}' of line {}", c,
                                                 open_.back().kind, number(open_.back().line)));
  }

  std::vector<Line> lines_;
  std::vector<Open> open_;
  std::optional<YamlFault> unfit_;
  std::optional<std::pair<std::size_t, char>> open_quote_;
  bool literal_ = false;
  std::size_t literal_indent_ = 0;
};

// Hint for the first key of a line without a blank after its colon; empty: none.
std::string unseparated(const std::string& line) {
  bool start = true;  // at the start of a line, after '-', or in brackets before a key
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (start && c != ' ' && c != '-')
      if (std::string fault = model::missing_blank(std::string_view(line).substr(i)); !fault.empty())
        return fault;
    start = c == '{' || c == ',' || (start && (c == ' ' || c == '-'));
  }
  return "";
}

// Hint for the start of a line that YAML takes for text; null: none.
const char* unexpected_begin(const Line& line) {
  if (line.empty() || line.flow) return nullptr;
  const std::string_view begin = std::string_view(line.text).substr(line.indent);
  if (begin.starts_with("//")) return "a comment begins with '#', not with '//'";
  const char next = begin.size() > 1 ? begin[1] : ' ';
  if (begin.front() == '-' && (next == '{' || next == '[' || (next >= 'a' && next <= 'z')))
    return "a blank is missing after the '-' with which an entry of a list begins";
  return nullptr;
}

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// End of the word at a position: letters, digits and '_', a letter first.
std::size_t end_of_word(std::string_view text, std::size_t at) {
  if (at >= text.size() || !letter(text[at])) return at;
  while (at < text.size() && (letter(text[at]) || (text[at] >= '0' && text[at] <= '9'))) ++at;
  return at;
}

std::string no_colon(std::string_view key) {
  return fmt::format("a colon and a blank are missing after {}", model::quote(key));
}

// Hint for a line with a bracket after a key without a colon; empty: none.
std::string bracket_without_colon(const Line& line) {
  const std::string_view text = line.text;
  std::size_t at = std::min(text.find_first_not_of(" -"), text.size());
  int open = line.flow ? 1 : 0;
  for (bool begin = true; at < text.size();) {
    const std::size_t end = begin ? end_of_word(text, at) : at;
    if (end > at) {
      const std::size_t next = text.find_first_not_of(' ', end);
      if (next > end && next != std::string_view::npos && (text[next] == '[' || text[next] == '{'))
        return no_colon(text.substr(at, end - at));
    }
    begin = false;
    for (at = end; at < text.size() && !begin; ++at) {
      if (text[at] == '{' || text[at] == '[') ++open;
      if (text[at] == '}' || text[at] == ']') --open;
      begin = text[at] == '{' || (text[at] == ',' && open > 0);
    }
    at = std::min(text.find_first_not_of(' ', at), text.size());
  }
  return "";
}

// Hint for a line with a key and perhaps a value but no colon; empty: none.
std::string line_without_colon(const Line& line) {
  if (line.empty() || line.flow || line.text.find(':') != std::string::npos) return "";
  const std::size_t end = end_of_word(line.text, line.indent);
  if (end == line.indent || (end < line.text.size() && line.text[end] != ' ')) return "";
  return fmt::format(
      "there is no colon in {}: a key ends with one, and a blank stands between that and the value",
      model::quote(std::string_view(line.text).substr(line.indent)));
}

std::optional<YamlFault> wrong_indent(const std::vector<Line>& lines, std::size_t at) {
  struct Level {
    std::size_t indent, line;
    bool open;  // its value may follow at deeper indentation
  };
  std::vector<Level> levels;
  for (std::size_t i = 0; i <= at; ++i) {
    const Line& l = lines[i];
    if (l.empty() || l.flow) continue;
    bool dropped = false;
    while (!levels.empty() && levels.back().indent > l.indent) {
      levels.pop_back();
      dropped = true;
    }
    const bool known = !levels.empty() && levels.back().indent == l.indent;
    if (i == at && !known && levels.empty() && dropped)
      return YamlFault{
          number(i),
          "the line begins further left than the first one: all top-level keys begin in the same column"};
    if (i == at && !known && dropped)
      return YamlFault{number(i),
                       fmt::format("the line is indented by {} blanks, which no line that it could belong to "
                                   "is (line {} is by {}): keys of one map begin in the same column",
                                   l.indent, number(levels.back().line), levels.back().indent)};
    if (!known && !levels.empty() && !levels.back().open && i + 1 >= at && l.indent > levels.back().indent)
      return YamlFault{number(i),
                       fmt::format("the line is indented by {} blanks, but line {} by {}, and that has its "
                                   "value already: keys of one map begin in the same column",
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

std::optional<YamlFault> find_open_quote(const std::string& text) {
  const Lines parts(text);
  const auto& open = parts.open_quote();
  if (!open) return std::nullopt;
  std::size_t at = 0;
  for (std::size_t i = 0; i < open->first; ++i) at = text.find('\n', at) + 1;
  if (std::count(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), open->second) != 1)
    return std::nullopt;
  return YamlFault{number(open->first),
                   fmt::format("the quote {} that opens in this line is not closed", open->second)};
}

std::optional<YamlFault> find_yaml_fault(const std::string& text, int line) {
  const Lines parts(text);
  const std::vector<Line>& lines = parts.all();
  const std::size_t last = std::min(static_cast<std::size_t>(std::max(line, 1)), lines.size());
  for (std::size_t i = 0; i < last; ++i)
    if (!lines[i].flow && !lines[i].empty() && lines[i].tab())
      return YamlFault{static_cast<int>(i) + 1,
                       "the line is indented with a tab, which YAML does not allow: use blanks"};
  // The parser may notice at the key after.
  std::size_t before = last - 1;
  while (before > 0 && lines[before - 1].empty()) --before;
  const std::size_t near[] = {last - 1, before > 0 ? before - 1 : before};
  for (const std::size_t i : near)
    if (std::string fault = unseparated(lines[i].text); !fault.empty())
      return YamlFault{static_cast<int>(i) + 1, std::move(fault)};
  for (std::size_t i = 0; i < last; ++i)
    if (const char* fault = unexpected_begin(lines[i])) return YamlFault{static_cast<int>(i) + 1, fault};
  for (const std::size_t i : near)
    if (std::string fault = bracket_without_colon(lines[i]); !fault.empty())
      return YamlFault{number(i), std::move(fault)};
  if (parts.unfit() && parts.unfit()->line <= line) return parts.unfit();
  for (const std::size_t i : near)
    if (std::string fault = line_without_colon(lines[i]); !fault.empty())
      return YamlFault{number(i), std::move(fault)};
  return wrong_indent(lines, last - 1);
}

}  // namespace hawser::io
