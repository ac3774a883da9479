// Stiffness of the lines at a body, by condensation of the tangent onto its six unknowns.
#include "hawser/solve/body_stiffness.hpp"

#include <petscksp.h>

#include "condensation.hpp"
#include "hawser/advice/statics.hpp"
#include "hawser/base/error.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "small_motions.hpp"

namespace hawser {

BodyStiffness body_stiffness(System& system, const Kinematics& state, int body_node,
                             const std::vector<TiedNode>& free, const std::vector<TiedNode>& held) {
  const MPI_Comm comm = system.comm();
  const BodyMotion motion = system.tied_nodes().motion();
  std::vector<int> owned = {system.mesh().find(body_node)};
  if (!system.mesh().owns(owned[0])) owned.clear();
  const BodyRows body(system, owned);
  BodyStiffness out;
  const VecHandle residual = system.create_vector();

  system.tie(free, motion);
  system.residual(state, residual.get());
  out.f = body.values(residual.get());
  const MatHandle stiffness = tangent_at_rest(system, state, {1, 0, 0});
  system.tie(held, motion);
  system.residual(state, residual.get());
  const MatHandle others = tangent_at_rest(system, state, {1, 0, 0});

  KspHandle solver;
  check(KSPCreate(comm, solver.out()));
  check(KSPSetOptionsPrefix(solver.get(), "stiffness_"));
  solve_directly(solver.get());
  check(KSPSetOperators(solver.get(), others.get(), others.get()));
  check(KSPSetFromOptions(solver.get()));
  const std::optional<Eigen::MatrixXd> K = condensed(body, system, stiffness.get(), solver.get());
  if (!K) throw SolveError(advice::singular_mooring());
  out.K = *K;
  return out;
}

// With the residual f, m (m in body axes) at the centre of mass c and p = c + r: f_p = f, m_p = R m - r x f.
// dx_c = dx_p + r x dtheta, dphi = R^T dtheta, d(R m) = dtheta x R m + R dm, dr = dtheta x r.
BodyStiffness about_point(const BodyStiffness& s, const Vec3& r, const Mat3& R) {
  const Vec3 force = s.f.head<3>();
  const Vec3 moment = R * s.f.tail<3>();
  Mat6 to_centre, to_point;
  to_centre << Mat3::Identity(), hat(r), Mat3::Zero(), R.transpose();
  to_point << Mat3::Identity(), Mat3::Zero(), -hat(r), R;
  BodyStiffness out;
  out.f << force, moment - r.cross(force);
  out.K = to_point * s.K * to_centre;
  // -dr x f = f x (dtheta x r) = -f^ r^ dtheta
  out.K.bottomRightCorner<3, 3>() -= hat(moment) + hat(force) * hat(r);
  return out;
}

}  // namespace hawser
