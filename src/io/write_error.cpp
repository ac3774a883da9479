// Cause of a failed write: no space left on the disk, or the operating system's message within that of the
// HDF5 library.
#include "hawser/io/write_error.hpp"

#include <sys/statvfs.h>

namespace hawser::io {
namespace {

constexpr unsigned long long kLeast = 1 << 20;  // bytes; a disk with less is full

// Extracts the system's message from an HDF5 text "... errno = 28, error message = 'No space left on device',
// ...".
std::string words_of_system(const std::string& why) {
  const std::string mark = "error message = '";
  const size_t at = why.find(mark);
  if (at == std::string::npos) return why;
  return why.substr(at + mark.size(), why.find('\'', at + mark.size()) - at - mark.size());
}

}  // namespace

std::string cannot_write(const std::string& path, const std::string& why) {
  const size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  struct statvfs disk {};
  const std::string begin = "cannot write " + path;
  if (statvfs(folder.c_str(), &disk) == 0 && 1ULL * disk.f_bavail * disk.f_frsize < kLeast)
    return begin + ": no space left on the disk";
  const std::string words = words_of_system(why);
  return words == why && why.starts_with(begin) ? why : begin + ": " + words;
}

}  // namespace hawser::io
