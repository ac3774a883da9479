// Conversion of text to a JSON string.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace hawser::model {

inline std::string json_string(std::string_view text) {
  std::string s = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      s += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      s += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      s += c;
  }
  return s + "\"";
}

}  // namespace hawser::model
