// Likely fault in a file that is not valid YAML.
#pragma once

#include <optional>
#include <string>

namespace hawser::io {

struct YamlFault {
  int line = 0;      // line number, from 1
  std::string text;  // rest of the sentence: the fault and its remedy
};

// Looks for tabs in indentation, missing colons or blanks after colons, unclosed brackets and quotes,
// misaligned keys, and comments and list entries that YAML takes for text, in `text` around the line (from 1)
// where the parser failed. Empty: no fault found.
std::optional<YamlFault> find_yaml_fault(const std::string& text, int line);

// An unclosed quote, which the parser accepts as a value up to the end of the text.
std::optional<YamlFault> find_open_quote(const std::string& text);

}  // namespace hawser::io
