// What is asked of a file before any of it is read: some never end, and some are larger than any memory.
#pragma once

#include <string>

namespace hawser::io {

// Largest files that are read, MB. A case of 1000 lines has 0.3 MB, 10^7 facets have 500 MB in binary STL,
// and text takes up to 300 times its size in memory while YAML is made of it, 20 times as a table or a mesh.
inline constexpr double kMostCase = 4, kMostTable = 500, kMostMesh = 1000;

// Why the file cannot be read, as the end of a sentence; empty: it is a regular file of at most that many MB.
// kind: "case", "mesh" or the like.
std::string unreadable(const std::string& path, const std::string& kind, double most);

}  // namespace hawser::io
