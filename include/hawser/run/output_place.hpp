// Location of the results of a run: checks that it is writable before the computation, and locks it against
// other runs.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hawser/io/run_lock.hpp"

namespace hawser::run {

// Throws InputError if one of the files written with `kind` ("the results") at `path` is an input file.
void check_not_read(const std::string& kind, const std::string& path, const std::vector<std::string>& written,
                    const std::vector<std::string>& read);

// Throws InputError unless the folder of `path` exists and can be written.
void check_folder(const std::string& path);

// Throws InputError if the folder of `path` cannot be written, or `path` is a file that the case reads, or
// does not begin with `head`, as tables of `contents` do; such files are not overwritten.
void check_table(const std::string& path, std::string_view head, const std::string& contents,
                 const std::vector<std::string>& inputs);

// Path of the table of one of several bodies: `path` with the name of the body, in which a slash (a body of a
// farm) becomes a dash, before its ending.
std::string table_of_body(const std::string& path, const std::string& body);

// Path of the file that a command writes: `output`, or if it is empty the name of the case with `ending`,
// beside the case file.
std::string path_of_output(const std::string& case_path, const std::string& output,
                           const std::string& ending);

// Writes `text` of rank 0 to the file. Throws WriteError on all ranks if that fails. Collective.
void write_table(MPI_Comm comm, const std::string& path, const std::string& text);

class OutputPlace {
 public:
  // A file at `path` is replaced only if it is a results file; links are followed. `restart`: the file that
  // the run continues, or empty; `inputs`: files read by the case, which are never replaced. Throws
  // InputError if results cannot be created there. Collective.
  OutputPlace(MPI_Comm comm, const std::string& path, const std::string& restart,
              const std::vector<std::string>& inputs);

  const std::string& path() const { return path_; }  // after following links
  bool appends() const { return appends_; }          // continues in the same file
  // Notes on the location, on rank 0.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void check() const;
  void check_old();

  std::string path_;
  bool appends_ = false;
  std::vector<std::string> notes_;
  std::unique_ptr<io::RunLock> lock_;  // on rank 0
};

}  // namespace hawser::run
