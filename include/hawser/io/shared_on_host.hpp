// Meshes are read and checked by one rank of a host, for all of them.
#pragma once

#include <mpi.h>

#include <functional>
#include <memory>

#include "hawser/base/host.hpp"
#include "hawser/geometry/mesh_surface.hpp"

namespace hawser::io {

// Calls work; what goes wrong in it on any rank is thrown on all, as InputError. Collective over comm.
void rethrow_on_all_ranks(MPI_Comm comm, const std::function<void()>& work);

// What `make` gives on the leading rank of the host, on all of its ranks, in memory that they share; where
// the host has none to give, each rank makes its own. Throws as agreed(). Collective over comm, and so is
// letting go of what is shared (base/host.hpp).
std::shared_ptr<const MeshSurface> shared_on_host(
    MPI_Comm comm, const Host& host, const std::function<std::shared_ptr<const MeshSurface>()>& make);

}  // namespace hawser::io
