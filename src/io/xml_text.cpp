// UTF-8 decoding and the characters allowed in XML 1.0, for names in the XDMF file.
#include "hawser/io/xml_text.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hawser::io {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// Length in bytes of the first character; 0: no valid UTF-8 (RFC 3629), or not allowed in XML 1.0 (section
// 2.2).
size_t character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r';
  const size_t n = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC0 || first >= 0xF8 || text.size() < n) return 0;
  std::uint32_t code = first & (0x7Fu >> n);
  for (const char c : text.substr(1, n - 1)) {
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) return 0;
    code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  }
  const std::uint32_t min_code = n == 2 ? 0x80 : n == 3 ? 0x800 : 0x10000;
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  const bool never = code == 0xFFFE || code == 0xFFFF;
  return code < min_code || code > 0x10FFFF || surrogate || never ? 0 : n;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string out;
  for (std::string_view remaining = text; !remaining.empty();) {
    const size_t n = character(remaining);
    const char c = remaining[0];
    if (n == 0)
      out += kReplacement;
    else if (n == 1 && (c < ' ' || c == '&' || c == '<' || c == '>' || c == '"'))
      out += "&#" + std::to_string(static_cast<int>(c)) + ";";
    else
      out += remaining.substr(0, n);
    remaining.remove_prefix(n == 0 ? 1 : n);
  }
  return out;
}

bool xml_holds(const std::string& text) {
  for (std::string_view remaining = text; !remaining.empty();) {
    const size_t n = character(remaining);
    if (n == 0) return false;
    remaining.remove_prefix(n);
  }
  return true;
}

}  // namespace hawser::io
