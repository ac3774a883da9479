// Error for results that cannot be written, for example on a full disk. Exit code 1.
#pragma once

#include <stdexcept>
#include <string>

namespace hawser::io {

// what() is one sentence that names the file. Thrown on all ranks.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Sentence for `path` if the system or a library reports `why`. Libraries do not always report a full disk;
// the function checks for it.
std::string cannot_write(const std::string& path, const std::string& why);

}  // namespace hawser::io
