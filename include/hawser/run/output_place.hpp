// Where the results of a run go: whether they can be written there, before anything is computed, and that
// nobody else writes there meanwhile.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hawser/io/run_lock.hpp"

namespace hawser::run {

// Throws InputError if one of the files that are written with `what` ("the results") at `path` is one of
// those that are read.
void check_not_read(const std::string& what, const std::string& path, const std::vector<std::string>& written,
                    const std::vector<std::string>& read);

// Throws InputError if `path` is a file that the case reads, or one that does not begin with `head`, as
// tables of `what` do: neither is replaced.
void check_table(const std::string& path, std::string_view head, const std::string& what,
                 const std::vector<std::string>& inputs);

class OutputPlace {
 public:
  // A file at `path` is replaced only if it is a results file; a link is followed. `restart`: the file the
  // run goes on from, or empty; `inputs`: what the case reads, none of which is replaced. Throws InputError
  // unless results can be made there. Collective.
  OutputPlace(MPI_Comm comm, const std::string& path, const std::string& restart,
              const std::vector<std::string>& inputs);

  const std::string& path() const { return path_; }  // where links lead
  bool appends() const { return appends_; }          // goes on in the file itself
  // Notes on the place, on rank 0.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void check() const;
  void check_old();

  std::string path_;
  bool appends_ = false;
  std::vector<std::string> notes_;
  std::unique_ptr<io::RunLock> lock_;  // of rank 0
};

}  // namespace hawser::run
