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

void BodyRows::set(Vec v, const Eigen::VectorXd& x) const {
  check(VecSet(v, 0));
  for (Eigen::Index k = 0; k < count(); ++k)
    if (owns(k)) check(VecSetValue(v, rows_[k], x[k], INSERT_VALUES));
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
    set(unit.get(), Eigen::VectorXd::Unit(count(), k));
    check(MatMult(A, unit.get(), product.get()));
    out.col(k) = values(product.get());
  }
  return out;
}

void BodyRows::add(const Eigen::MatrixXd& values, Mat A) const {
  for (Eigen::Index i = 0; i < count(); ++i)
    for (Eigen::Index k = 0; k < count() && owns(i); ++k)
      if (values(i, k) != 0) check(MatSetValue(A, rows_[i], rows_[k], values(i, k), ADD_VALUES));
  check(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
}

void BodyRows::hold(Mat A) const {
  std::vector<int> own;
  for (Eigen::Index k = 0; k < count(); ++k)
    if (owns(k)) own.push_back(rows_[k]);
  check(MatZeroRowsColumns(A, static_cast<PetscInt>(own.size()), own.data(), 1, nullptr, nullptr));
}

BodyRows rows_of_bodies(const System& system) {
  std::vector<int> nodes;
  for (int n = 0; n < system.mesh().owned; ++n)
    if (system.mesh().node(n).body >= 0) nodes.push_back(n);
  return {system, nodes};
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

bool move_in_equilibrium(const BodyRows& bodies, const System& system, Mat J, KSP held,
                         const Eigen::VectorXd& e, Vec motion) {
  const VecHandle force = system.create_vector();
  const VecHandle others = system.create_vector();
  bodies.set(motion, e);
  check(MatMult(J, motion, force.get()));
  bodies.clear(force.get());
  clear_held(system, force.get());
  check(KSPSolve(held, force.get(), others.get()));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(held, &reason));
  check(VecAXPY(motion, -1, others.get()));
  return reason >= 0;
}

std::optional<Eigen::MatrixXd> condensed(const BodyRows& bodies, const System& system, Mat J, KSP held) {
  const VecHandle motion = system.create_vector();
  const VecHandle force = system.create_vector();
  const Eigen::Index n = bodies.count();
  Eigen::MatrixXd K(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!move_in_equilibrium(bodies, system, J, held, Eigen::VectorXd::Unit(n, k), motion.get()))
      return std::nullopt;
    check(MatMult(J, motion.get(), force.get()));
    K.col(k) = bodies.values(force.get());
  }
  return K;
}

}  // namespace hawser
