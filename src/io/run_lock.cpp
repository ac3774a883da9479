// The class RunLock: creation, locking and removal of the lock file, and the message if another run holds it.
#include "hawser/io/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "hawser/base/error.hpp"

namespace hawser::io {
namespace {

// Another process may have removed the file at its end; an open descriptor then refers to a deleted file.
bool is_same_file(int file, const std::string& path) {
  struct stat opened {
  }, on_disk{};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &on_disk) == 0 && opened.st_ino == on_disk.st_ino &&
         opened.st_dev == on_disk.st_dev;
}

}  // namespace

RunLock::RunLock(const std::string& results) : path_(results + ".lock") {
  const std::string begin = "cannot write the results to " + results + ": ";
  for (;;) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) throw InputError("{}{} cannot be made ({})", begin, path_, std::strerror(errno));
    held_ = flock(file_, LOCK_EX | LOCK_NB) == 0;
    if (!held_ && errno == EWOULDBLOCK) {
      close(file_);
      std::string holder;
      std::getline(std::ifstream(path_), holder);
      throw InputError(
          "{}another run is writing them{}; wait for its end, or give this one another file with -o", begin,
          holder.empty() ? "" : " (" + holder + ")");
    }
    if (!held_ || is_same_file(file_, path_)) break;
    close(file_);
  }
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  // The text is informative only; a full disk does not matter.
  if (ftruncate(file_, 0) == 0) dprintf(file_, "process %d on %s\n", static_cast<int>(getpid()), host);
}

RunLock::~RunLock() {
  unlink(path_.c_str());  // before others can lock it
  close(file_);
}

}  // namespace hawser::io
