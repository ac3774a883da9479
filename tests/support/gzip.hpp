// Reads a compressed file with gzip.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

namespace hawser::test {

// Text of a .gz file. Throws if gzip cannot read it.
inline std::string read_gzip(const std::string& path) {
  std::FILE* pipe = popen(("gzip -dc '" + path + "'").c_str(), "r");
  if (!pipe) throw std::runtime_error("gzip cannot be run");
  std::string text;
  char block[1 << 16];
  for (std::size_t n; (n = std::fread(block, 1, sizeof block, pipe)) > 0;) text.append(block, n);
  if (pclose(pipe) != 0) throw std::runtime_error(path + " cannot be read");
  return text;
}

}  // namespace hawser::test
