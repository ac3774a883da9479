// From a case file to checked data.
#pragma once

#include <mpi.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::io {

// Reports while a case is read, before what may take long; members may be empty.
struct ReadProgress {
  std::function<void(const std::string& title)> title;  // or the path, where it has none
  std::function<void(const std::string& what, double seconds)>
      busy;  // what begins, and about how long it takes
};
// Seconds that a mesh file takes to read, by its size.
double reading_time(const std::string& path);
// "reading the mesh hull.stl (41 MB)"
std::string reading_text(const std::string& path);

// Changes: "KEY=VALUE" each, made in the document before it is checked (case_changes.hpp).
using CaseChanges = std::vector<std::string>;

// Read and check a case file: form, units, references, sense, and the other files it names but the meshes of
// volumes, which run::load_volumes() reads. Collective over comm, of whose ranks one a host reads the mesh of
// a seabed, for all of them.
// Throws InputError; what() is one sentence "file:line: dotted.key: what is wrong", of a changed case with
// its changes.
model::Case read_case(const std::string& path, const ReadProgress& read_progress = {},
                      MPI_Comm comm = MPI_COMM_SELF, const CaseChanges& changes = {});

// The same for text already read; `path` names the file and gives the directory of relative paths.
model::Case read_case_text(const std::string& text, const std::string& path,
                           const ReadProgress& read_progress = {}, MPI_Comm comm = MPI_COMM_SELF,
                           const CaseChanges& changes = {});

// Unstretched lengths of sections by their dotted keys, "lines.hose.sections[0]", m.
using SectionLengths = std::map<std::string, double>;

// The case, whose `tree` must be there, as if these lengths were in its file: arc lengths said as `end_b`
// move along. The numbers of elements stay. InputError where it is then no valid case. Collective.
model::Case with_lengths(const model::Case& c, const SectionLengths& lengths, MPI_Comm comm = MPI_COMM_SELF);

}  // namespace hawser::io
