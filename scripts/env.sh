# Environment of all runs and tests of hawser. Source it: . scripts/env.sh
# Variables that are already set are kept.

# Open MPI refuses to start as root, or with more ranks than cores, unless asked to; both are usual in a container.
export OMPI_ALLOW_RUN_AS_ROOT="${OMPI_ALLOW_RUN_AS_ROOT:-1}"
export OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="${OMPI_ALLOW_RUN_AS_ROOT_CONFIRM:-1}"
export OMPI_MCA_rmaps_base_oversubscribe="${OMPI_MCA_rmaps_base_oversubscribe:-1}"
# Open MPI's cross-memory attach needs ptrace rights, which containers do not have.
export OMPI_MCA_btl_vader_single_copy_mechanism="${OMPI_MCA_btl_vader_single_copy_mechanism:-none}"

# Several MPI programs at a time (tests) must not be pinned to the same first cores, nor spin while they wait.
# A run of its own with a core per rank is faster with both at their defaults, so scripts/run does not set them.
hawser_share_cores() {
  export OMPI_MCA_mpi_yield_when_idle="${OMPI_MCA_mpi_yield_when_idle:-1}"
  export OMPI_MCA_hwloc_base_binding_policy="${OMPI_MCA_hwloc_base_binding_policy:-none}"
  # If programs start and end at the same time, one may remove Open MPI's folder while another needs it, which then
  # fails. A file in the folder prevents this.
  local session
  session="${TMPDIR:-/tmp}/ompi.$(uname -n | cut -d. -f1).$(id -u)"
  mkdir -m 700 -p "$session" && touch "$session/kept" || true
}

# The program is parallel by ranks; additional threads would only compete with them.
export OMP_NUM_THREADS="${OMP_NUM_THREADS:-1}"
export OPENBLAS_NUM_THREADS="${OPENBLAS_NUM_THREADS:-1}"

# nproc follows the variables of OpenMP above.
hawser_cores() { env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc; }

# Number of parallel compilers: one a core, with 1.5 GB of memory each.
hawser_jobs() {
  local cores memory by_memory
  cores=$(hawser_cores)
  memory=$(awk '/MemAvailable/ {print $2}' /proc/meminfo)
  by_memory=$((memory / 1500000))
  [ "$by_memory" -ge 1 ] || by_memory=1
  echo $((cores < by_memory ? cores : by_memory))
}
