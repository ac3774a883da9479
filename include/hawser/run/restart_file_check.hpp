// Whether a run can go on from the given file, before anything is computed.
#pragma once

#include <mpi.h>

#include <span>
#include <string>

#include "hawser/mesh/mesh.hpp"

namespace hawser::run {

// Throws InputError unless `path` is a results file of lines cut like those of `mesh`. Each rank compares the
// lines whose first node is one of `owned`, ascending: nodes of this rank, of which each is one rank's.
// Collective.
void check_restart_file(MPI_Comm comm, const std::string& path, const Mesh& mesh, std::span<const int> owned);

}  // namespace hawser::run
