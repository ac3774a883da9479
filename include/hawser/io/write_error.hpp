// Results that cannot be written, because the disk is full, say. Exit code 1.
#pragma once

#include <stdexcept>
#include <string>

namespace hawser::io {

// what() is one sentence with the file. Thrown on all ranks.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// That sentence for `path`, when the system or a library says `why`. They don't always pass on that the disk
// is full; it is asked.
std::string cannot_write(const std::string& path, const std::string& why);

}  // namespace hawser::io
