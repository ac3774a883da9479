// A process that no launcher (mpirun, srun) has started.
#pragma once

#include <cstdlib>

namespace hawser {

// Before MPI_Init: lets Open MPI start without the drivers of fast networks, one of which measures the
// processor's clock for 0.2 s. (Without its daemon, ess_singleton_isolated, processes that start at the same
// time would take each other's folder in /tmp away.) What the environment says goes first.
inline void start_alone() {
  for (const char* launcher : {"PMIX_NAMESPACE", "PMI_RANK", "PMI_FD", "OMPI_COMM_WORLD_SIZE"})
    if (std::getenv(launcher)) return;
  setenv("OMPI_MCA_pml", "ob1", 0);
}

}  // namespace hawser
