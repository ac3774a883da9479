// Whether a run can go on from the given file, before anything is computed.
#pragma once

#include <mpi.h>

#include <string>

#include "hawser/mesh/mesh.hpp"

namespace hawser::run {

// Throws InputError unless `path` is a results file of lines cut like those of `mesh`. Collective.
void check_restart_file(MPI_Comm comm, const std::string& path, const Mesh& mesh);

}  // namespace hawser::run
