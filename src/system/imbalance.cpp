// Finds the node with the largest residual force or moment over all ranks.
#include "hawser/system/imbalance.hpp"

#include <cmath>

namespace hawser {
namespace {

struct Worst {
  double value = -1;
  int node = 0;
};

// A value that is not a number counts as larger than all others.
void take(Worst& worst, double value, int node) {
  if (std::isnan(value)) value = HUGE_VAL;
  if (value > worst.value) worst = {value, node};
}

Worst over_ranks(MPI_Comm comm, Worst w) {
  MPI_Allreduce(MPI_IN_PLACE, &w, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm);
  return w;
}

}  // namespace

advice::Imbalance imbalance(const System& system, Vec residual, const ResidualNorms& norms) {
  const LocalMesh& m = system.mesh();
  Worst force, moment;
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(residual, &p));
  for (int n = 0; n < m.owned; ++n) {
    const PetscScalar* r = p + 3 * m.block[n];
    const int node = m.global[n];
    take(force, Eigen::Map<const Vec3>(r).norm(), node);
    if (m.rotates(n)) take(moment, Eigen::Map<const Vec3>(r + 3).norm(), node);
  }
  check(VecRestoreArrayRead(residual, &p));
  force = over_ranks(system.comm(), force);
  moment = over_ranks(system.comm(), moment);
  const bool turns = std::isfinite(force.value) &&
                     moment.value * norms.force_scale > force.value * norms.moment_scale &&
                     norms.moment_scale > 0;
  const Worst& worst = turns ? moment : force;
  return {.place = m.mesh->place(worst.node),
          .value = worst.value,
          .scale = turns ? norms.moment_scale : norms.force_scale,
          .turns = turns,
          .finite = std::isfinite(worst.value) && norms.finite()};
}

}  // namespace hawser
