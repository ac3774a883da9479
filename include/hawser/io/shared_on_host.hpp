// Meshes read and checked by one rank per host and shared with the others.
#pragma once

#include <mpi.h>

#include <functional>
#include <memory>

#include "hawser/base/host.hpp"
#include "hawser/geometry/mesh_surface.hpp"

namespace hawser::io {

// Calls `work`; an error on any rank is thrown on all as InputError. Collective over comm.
void rethrow_on_all_ranks(MPI_Comm comm, const std::function<void()>& work);

// Result of `make` on the leading rank of the host, in memory shared by its ranks; if the host has no shared
// memory each rank calls `make`. Throws as rethrow_on_all_ranks(). Collective over comm, and so is the
// release of the result (base/host.hpp).
std::shared_ptr<const MeshSurface> shared_on_host(
    MPI_Comm comm, const Host& host, const std::function<std::shared_ptr<const MeshSurface>()>& make);

}  // namespace hawser::io
