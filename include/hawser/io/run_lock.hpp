// That no two runs write one results file: a lock on a file of its own beside it, `<results>.lock`, which
// says who holds it.
#pragma once

#include <string>

namespace hawser::io {

// Held for as long as the object lives. The system lets go of it when the process dies in whatever way, so a
// lock file that was left behind keeps nobody out.
class RunLock {
 public:
  // Throws InputError when another run writes `results`, or when no file can be made beside it.
  explicit RunLock(const std::string& results);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  // False where the file system knows no locks: nothing keeps other runs away.
  bool held() const { return held_; }

 private:
  std::string path_;
  int file_ = -1;
  bool held_ = true;
};

}  // namespace hawser::io
