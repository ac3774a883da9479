// Retraction of positions and rotations by an increment, and constant velocities from one state to another.
#include "hawser/state/state.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {

void retract(const LocalMesh& mesh, const State& from, const double* u, State& to) {
  for (size_t n = 0; n < from.x.size(); ++n) {
    const double* p = u + 3 * mesh.block[n];
    to.x[n] = from.x[n] + Eigen::Map<const Vec3>(p);
    if (mesh.rotates(static_cast<int>(n))) {
      // Normalised every time, so that round-off does not accumulate over many turns.
      to.q[n] = (from.q[n] * exp_so3(Eigen::Map<const Vec3>(p + 3))).normalized();
    }
  }
}

State straight_path(const LocalMesh& mesh, const State& from, const State& to, double h) {
  State path = from;
  for (size_t n = 0; n < path.x.size(); ++n) {
    path.v[n] = (to.x[n] - from.x[n]) / h;
    path.a[n] = Vec3::Zero();
    if (!mesh.rotates(static_cast<int>(n))) continue;
    path.w[n] = log_so3(from.q[n].conjugate() * to.q[n]) / h;
    path.alpha[n] = Vec3::Zero();
  }
  return path;
}

}  // namespace hawser
