// Set-up of a process that no launcher (mpirun, srun) has started.
#pragma once

#include <cstdlib>

namespace hawser {

inline bool launched() {
  for (const char* launcher : {"PMIX_NAMESPACE", "PMI_RANK", "PMI_FD", "OMPI_COMM_WORLD_SIZE"})
    if (std::getenv(launcher)) return true;
  return false;
}

// Called before MPI_Init by a process without a launcher. Variables set in the environment have precedence.
// Open MPI then starts
// - without the drivers of fast networks, one of which measures the processor's clock for 0.2 s,
// - without its daemon, which takes 0.1 s to start, and without the session folder, because without the
//   daemon processes that start at the same time would delete each other's folder in /tmp,
// - without a list of the machine's devices.
inline void start_singleton() {
  if (launched()) return;
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  setenv("HWLOC_COMPONENTS", "-pci,-linuxio", 0);
}

}  // namespace hawser
