// Reader of case files.
#pragma once

#include <mpi.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::io {

// Progress reports while a case is read, before long operations; members may be empty.
struct ReadProgress {
  std::function<void(const std::string& title)> title;  // the path if the case has no title
  std::function<void(const std::string& text, double seconds)>
      busy;  // the next operation and its estimated duration [s]
};
// Estimated time to read a mesh file [s], from its size.
double reading_time(const std::string& path);
// "reading the mesh hull.stl (41 MB)"
std::string reading_text(const std::string& path);

// Changes "KEY=VALUE", applied before the document is checked (case_changes.hpp).
using CaseChanges = std::vector<std::string>;

// Reads and checks a case file: form, units, references, consistency, and the files it names except meshes of
// volumes, which run::load_volumes() reads. Collective over comm; one rank per host reads a seabed mesh for
// all of its ranks. Throws InputError; what() is one sentence "file:line: dotted.key: what is wrong", with
// the changes of a changed case.
model::Case read_case(const std::string& path, const ReadProgress& read_progress = {},
                      MPI_Comm comm = MPI_COMM_SELF, const CaseChanges& changes = {});

// The same for text in memory; `path` names the file and gives the directory of relative paths.
model::Case read_case_text(std::string text, const std::string& path, const ReadProgress& read_progress = {},
                           MPI_Comm comm = MPI_COMM_SELF, const CaseChanges& changes = {});

// Unstretched lengths of sections [m] by dotted key, "lines.hose.sections[0]".
using SectionLengths = std::map<std::string, double>;

// The case re-read from its `tree`, which must exist, with these section lengths; arc lengths given as
// `end_b` move along, the numbers of elements stay. Throws InputError if the result is invalid. Collective.
model::Case with_lengths(const model::Case& c, const SectionLengths& lengths, MPI_Comm comm = MPI_COMM_SELF);

}  // namespace hawser::io
