// Parallel writing of rows to a shared file, with a common error state. Internal to io.
#pragma once

#include <hdf5.h>
#include <mpi.h>

#include <exception>
#include <map>
#include <string>
#include <vector>

#include "hawser/io/hdf5.hpp"

namespace hawser::io {

struct RowRun {  // consecutive indices of a dimension that this rank holds
  long long first = 0, count = 0;
};

// Runs of consecutive numbers in an ascending list.
std::vector<RowRun> runs_of(const std::vector<int>& ascending);

class SharedFile {
 public:
  // `comm` must outlive the object.
  SharedFile(MPI_Comm comm, std::string path);
  ~SharedFile() { close(); }

  int rank() const { return rank_; }
  MPI_Comm comm() const { return comm_; }
  const std::string& path() const { return path_; }

  // Collective. The datasets stay open; the writers below accept only these.
  void open(const std::vector<std::string>& datasets);
  void close();

  // Runs f on this rank and stores an error for agree(), so that all ranks make the same collective calls.
  template <class F>
  void attempt(F&& f) {
    try {
      f();
    } catch (const std::exception& e) {
      if (error_.empty()) note(e);
    }
  }

  // Collective: returns if no rank has an error, else all throw the first one: WriteError for file or disk
  // errors, else std::runtime_error.
  void agree();

  // The next four functions use attempt(). Collective: writes runs of the first dimension (row < 0) or of the
  // second, in `rows` rows from `row` on.
  void write_runs(const std::string& name, hid_t type, long long row, const std::vector<RowRun>& runs,
                  const void* data, long long rows = 1);
  // Collective: writes whole rows [first, first + rows); only the rank with `contributes` has the data.
  void write_rows(const std::string& name, hid_t type, long long first, long long rows, bool contributes,
                  const void* data);
  // Writes a whole dataset from this rank alone.
  void write_alone(const std::string& name, hid_t type, const void* data);
  // Collective: flushes to the disk, against power failures.
  void flush();

 private:
  void note(const std::exception& e);
  void transfer(hid_t set, hid_t type, hid_t space, hsize_t n, const void* data);

  MPI_Comm comm_;
  int rank_ = 0;
  std::string path_;
  h5::Id file_, transfer_;
  std::map<std::string, h5::Id> open_;  // closed before the file
  std::string error_;                   // first error on this rank since the last agree()
  bool internal_ = false;               // an internal error, not one of the file
};

}  // namespace hawser::io
