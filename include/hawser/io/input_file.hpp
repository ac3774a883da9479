// Checks of a file before it is read: regular, and not too large.
#pragma once

#include <string>
#include <string_view>

namespace hawser::io {

// Largest accepted files, MB. A case of 1000 lines has 0.3 MB, 10^7 facets have 500 MB in binary STL; the
// parser of YAML takes up to 300 times the size of the text in memory, tables and meshes take 20 times.
inline constexpr double kMostCase = 16, kMostTable = 500, kMostMesh = 1000;

// Reason why the file cannot be read, as the end of a sentence; empty: it is a regular file of at most
// `max_megabytes` MB. kind: "case", "mesh" or the like.
std::string unreadable(const std::string& path, const std::string& kind, double max_megabytes);

// Length of the UTF-8 byte order mark at the start of a text, bytes.
inline std::size_t mark_length(std::string_view text) { return text.starts_with("\xef\xbb\xbf") ? 3 : 0; }
// True if a text begins with a byte order mark of UTF-16, which no reader supports.
inline bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

}  // namespace hawser::io
