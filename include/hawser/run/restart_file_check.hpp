// Check before the computation that a run can continue from a file.
#pragma once

#include <mpi.h>

#include <span>
#include <string>

#include "hawser/mesh/mesh.hpp"

namespace hawser::run {

// Throws InputError unless `path` is a results file with the lines and nodes of `mesh`. Each rank compares
// the lines whose first node is one of its nodes `owned` (ascending, disjoint between ranks). Collective.
void check_restart_file(MPI_Comm comm, const std::string& path, const Mesh& mesh, std::span<const int> owned);

}  // namespace hawser::run
