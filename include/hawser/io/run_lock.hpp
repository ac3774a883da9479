// Lock against two runs writing the same results: a lock on the file `<results>.lock`, which names the
// holder.
#pragma once

#include <string>

namespace hawser::io {

// Held for the lifetime of the object. The system releases it when the process ends for any reason, so a
// stale lock file blocks no run.
class RunLock {
 public:
  // Throws InputError if another run writes `results` or the lock file cannot be created.
  explicit RunLock(const std::string& results);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  // False if the file system supports no locks; other runs are then not excluded.
  bool held() const { return held_; }

 private:
  std::string path_;
  int file_ = -1;
  bool held_ = true;
};

}  // namespace hawser::io
