// Static condensation onto bodies.
#include "condensation.hpp"

#include "hawser/base/mpi.hpp"

namespace hawser {

BodyRows::BodyRows(const System& system, std::span<const int> nodes) {
  const LocalMesh& mesh = system.mesh();
  std::vector<int> own;
  for (const int n : nodes)
    for (int k = 0; k < 6; ++k) own.push_back(3 * mesh.global_block[mesh.block[n] + k / 3] + k % 3);
  rows_ = gather_all(system.comm(), own);
  check(VecGetOwnershipRange(system.create_vector().get(), &first_, &end_));
}

void BodyRows::set_unit(Vec v, Eigen::Index k) const {
  check(VecSet(v, 0));
  if (owns(k)) check(VecSetValue(v, rows_[k], 1, INSERT_VALUES));
  check(VecAssemblyBegin(v));
  check(VecAssemblyEnd(v));
}

void BodyRows::clear(Vec v) const {
  for (Eigen::Index k = 0; k < count(); ++k)
    if (owns(k)) check(VecSetValue(v, rows_[k], 0, INSERT_VALUES));
  check(VecAssemblyBegin(v));
  check(VecAssemblyEnd(v));
}

Eigen::VectorXd BodyRows::values(Vec v) const {
  std::vector<double> x(rows_.size(), 0);
  for (Eigen::Index k = 0; k < count(); ++k)
    if (owns(k)) check(VecGetValues(v, 1, &rows_[k], &x[k]));
  all_reduce(PetscObjectComm(reinterpret_cast<PetscObject>(v)), MPI_SUM, x);
  return Eigen::Map<Eigen::VectorXd>(x.data(), count());
}

Eigen::MatrixXd BodyRows::block(const System& system, Mat A) const {
  const VecHandle unit = system.create_vector();
  const VecHandle product = system.create_vector();
  Eigen::MatrixXd out(count(), count());
  for (Eigen::Index k = 0; k < count(); ++k) {
    set_unit(unit.get(), k);
    check(MatMult(A, unit.get(), product.get()));
    out.col(k) = values(product.get());
  }
  return out;
}

void BodyRows::hold(Mat A) const {
  std::vector<int> own;
  for (Eigen::Index k = 0; k < count(); ++k)
    if (owns(k)) own.push_back(rows_[k]);
  check(MatZeroRowsColumns(A, static_cast<PetscInt>(own.size()), own.data(), 1, nullptr, nullptr));
}

namespace {

// Sets held components to zero. They do not move, and J may be a tangent in which they are free.
void clear_held(const System& system, Vec v) {
  const auto& held = system.tied_nodes().held();
  PetscScalar* x = nullptr;
  check(VecGetArray(v, &x));
  for (size_t i = 0; i < 3 * static_cast<size_t>(system.mesh().owned_blocks); ++i)
    if (held[i / 3] >> (i % 3) & 1) x[i] = 0;
  check(VecRestoreArray(v, &x));
}

}  // namespace

std::optional<Eigen::MatrixXd> condensed(const BodyRows& bodies, const System& system, Mat J, KSP held) {
  const VecHandle total = system.create_vector();
  const VecHandle push = system.create_vector();
  const VecHandle answer = system.create_vector();
  Eigen::MatrixXd K(bodies.count(), bodies.count());
  for (Eigen::Index k = 0; k < bodies.count(); ++k) {
    bodies.set_unit(total.get(), k);
    check(MatMult(J, total.get(), push.get()));
    bodies.clear(push.get());
    clear_held(system, push.get());
    check(KSPSolve(held, push.get(), answer.get()));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    check(KSPGetConvergedReason(held, &reason));
    if (reason < 0) return std::nullopt;
    check(VecAXPY(total.get(), -1, answer.get()));
    check(MatMult(J, total.get(), push.get()));
    K.col(k) = bodies.values(push.get());
  }
  return K;
}

}  // namespace hawser
