// What a user has probably got wrong in a file that is no YAML.
#pragma once

#include <optional>
#include <string>

namespace hawser::io {

struct YamlFault {
  int line = 0;      // of the file, from 1
  std::string text;  // the rest of the sentence: what is wrong and what to do
};

// Looks for tabs in indentation, colons that are missing or without a blank after them, brackets and quotes
// that are not closed and keys that do not begin in one column, comments and entries of lists that YAML takes
// for text, in `text` around the line (from 1) where the parser failed. Nothing: it is something else.
std::optional<YamlFault> find_yaml_fault(const std::string& text, int line);

// A quote that nothing closes up to the end of the text, which the parser takes for a value.
std::optional<YamlFault> find_open_quote(const std::string& text);

}  // namespace hawser::io
