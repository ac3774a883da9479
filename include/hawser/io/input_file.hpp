// What is asked of a file before any of it is read: some never end, and some are larger than any memory.
#pragma once

#include <string>
#include <string_view>

namespace hawser::io {

// Largest files that are read, MB. A case of 1000 lines has 0.3 MB, 10^7 facets have 500 MB in binary STL,
// and text takes up to 300 times its size in memory while YAML is made of it, 20 times as a table or a mesh.
inline constexpr double kMostCase = 16, kMostTable = 500, kMostMesh = 1000;

// Why the file cannot be read, as the end of a sentence; empty: it is a regular file of at most that many MB.
// kind: "case", "mesh" or the like.
std::string unreadable(const std::string& path, const std::string& kind, double most);

// Bytes of the mark that some editors and spreadsheets put before a text in UTF-8 (byte order mark).
inline std::size_t mark_length(std::string_view text) { return text.starts_with("\xef\xbb\xbf") ? 3 : 0; }
// Whether a text begins with that of UTF-16, which nothing here reads.
inline bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

}  // namespace hawser::io
