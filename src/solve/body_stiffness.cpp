// Static condensation onto a body: its six columns by solutions with the tangent of the held body.
#include "hawser/solve/body_stiffness.hpp"

#include <petscksp.h>

#include "hawser/advice/statics.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

using Solver = Handle<KSP, KSPDestroy>;

// Positions of the body's six unknowns in the global vectors; empty on ranks that do not own it.
std::vector<PetscInt> rows_of(const LocalMesh& mesh, int body_node) {
  const int n = mesh.find(body_node);
  std::vector<PetscInt> out;
  if (!mesh.owns(n)) return out;
  for (int k = 0; k < 6; ++k) out.push_back(3 * mesh.global_block[mesh.block[n] + k / 3] + k % 3);
  return out;
}

// Values at these rows, on all ranks.
Vec6 values(MPI_Comm comm, Vec v, const std::vector<PetscInt>& rows) {
  std::vector<double> x(6, 0);
  if (!rows.empty()) check(VecGetValues(v, 6, rows.data(), x.data()));
  all_reduce(comm, MPI_SUM, x);
  return Eigen::Map<const Vec6>(x.data());
}

// Sets the held components to zero.
void clear_held(const System& system, Vec v) {
  const auto& held = system.tied_nodes().held();
  PetscScalar* x = nullptr;
  check(VecGetArray(v, &x));
  for (size_t i = 0; i < 3 * static_cast<size_t>(system.mesh().owned_blocks); ++i)
    if (held[i / 3] >> (i % 3) & 1) x[i] = 0;
  check(VecRestoreArray(v, &x));
}

void set(Vec v, const std::vector<PetscInt>& rows, const Vec6& x) {
  if (!rows.empty()) check(VecSetValues(v, 6, rows.data(), x.data(), INSERT_VALUES));
  check(VecAssemblyBegin(v));
  check(VecAssemblyEnd(v));
}

MatHandle tangent(System& system, const Kinematics& state) {
  MatHandle J = system.create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  Weights weights;
  weights.K = 1;
  weights.C = weights.M = 0;
  system.tangent(state, weights, zero, false, J.get());
  return J;
}

}  // namespace

// With the body's unknowns b and all others l: J_ll x = -J_lb e, K e = J_bb e + J_bl x.
BodyStiffness body_stiffness(System& system, const Kinematics& state, int body_node,
                             const std::vector<TiedNode>& free, const std::vector<TiedNode>& held) {
  const MPI_Comm comm = system.comm();
  const BodyMotion motion = system.tied_nodes().motion();
  const std::vector<PetscInt> rows = rows_of(system.mesh(), body_node);
  BodyStiffness out;
  const VecHandle push = system.create_vector(), answer = system.create_vector(),
                  total = system.create_vector();

  system.tie(free, motion);
  system.residual(state, push.get());
  out.f = values(comm, push.get(), rows);
  const MatHandle stiffness = tangent(system, state);
  system.tie(held, motion);
  system.residual(state, answer.get());
  const MatHandle others = tangent(system, state);

  Solver solver;
  check(KSPCreate(comm, solver.out()));
  check(KSPSetOptionsPrefix(solver.get(), "stiffness_"));
  check(KSPSetType(solver.get(), KSPPREONLY));
  PC pc = nullptr;
  check(KSPGetPC(solver.get(), &pc));
  check(PCSetType(pc, PCLU));
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  check(KSPSetOperators(solver.get(), others.get(), others.get()));
  check(KSPSetFromOptions(solver.get()));
  for (int k = 0; k < 6; ++k) {
    check(VecSet(total.get(), 0));
    set(total.get(), rows, Vec6::Unit(k));
    check(MatMult(stiffness.get(), total.get(), push.get()));
    check(VecScale(push.get(), -1));
    clear_held(system, push.get());
    check(KSPSolve(solver.get(), push.get(), answer.get()));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    check(KSPGetConvergedReason(solver.get(), &reason));
    if (reason < 0) throw SolveError(advice::singular_mooring());
    check(VecAXPY(total.get(), 1, answer.get()));
    check(MatMult(stiffness.get(), total.get(), push.get()));
    out.K.col(k) = values(comm, push.get(), rows);
  }
  return out;
}

// With the residual f, m (m in body axes) at the centre of mass c and p = c + r: f_p = f, m_p = R m - r x f.
// dx_c = dx_p + r x dtheta, dphi = R^T dtheta, d(R m) = dtheta x R m + R dm, dr = dtheta x r.
BodyStiffness about_point(const BodyStiffness& s, const Vec3& r, const Mat3& R) {
  const Vec3 force = s.f.head<3>(), moment = R * s.f.tail<3>();
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
