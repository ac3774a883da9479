// Stiffness, mass and damping at rest as matrices of the free components.
#include "small_motions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hawser/base/mpi.hpp"
#include "hawser/solve/stability.hpp"

namespace hawser {

MatHandle tangent_at_rest(System& system, const Kinematics& state, const Weights& weights) {
  MatHandle J = system.create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(state, weights, zero, false, J.get());
  return J;
}

namespace {

// Sets the diagonal of held components, which is 1 in a tangent, to zero.
void clear_held(const System& system, Mat A) {
  const auto& is_held = system.tied_nodes().held();
  for (int b = 0; b < system.mesh().owned_blocks; ++b)
    for (int c = 0; c < 3; ++c) {
      if (!(is_held[b] >> c & 1)) continue;
      const PetscInt row = 3 * system.mesh().global_block[b] + c;
      check(MatSetValue(A, row, row, 0, INSERT_VALUES));
    }
  check(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
}

// Global rows of the unknowns of all bodies among the local nodes, ascending.
std::vector<PetscInt> rows_of_local_bodies(const System& system) {
  const LocalMesh& mesh = system.mesh();
  std::vector<PetscInt> out;
  for (size_t n = 0; n < mesh.block.size(); ++n) {
    if (mesh.node(n).body < 0) continue;
    for (int k = 0; k < 6; ++k) out.push_back(3 * mesh.global_block[mesh.block[n] + k / 3] + k % 3);
  }
  std::sort(out.begin(), out.end());
  return out;
}

// Adds to K, the symmetric part of the tangent J, the antisymmetric part in the rows and columns of bodies.
// Returns whether there is one, beyond rounding.
bool add_asymmetry_of_bodies(const System& system, Mat J, Mat K) {
  constexpr double kRounding = 1e-9;  // of the largest entry
  const std::vector<PetscInt> bodies = rows_of_local_bodies(system);
  struct Entry {
    PetscInt row, column;
    double value;
  };
  std::vector<Entry> antisymmetric;
  std::array<double, 2> largest = {0, 0};  // antisymmetric, of all
  PetscInt first = 0;
  PetscInt end = 0;
  check(MatGetOwnershipRange(K, &first, &end));
  for (const PetscInt row : bodies) {
    if (row < first || row >= end) continue;
    PetscInt count = 0;
    const PetscInt* columns = nullptr;
    const PetscScalar* values = nullptr;
    check(MatGetRow(J, row, &count, &columns, &values));
    for (PetscInt i = 0; i < count; ++i) {
      if (!std::binary_search(bodies.begin(), bodies.end(), columns[i])) continue;
      double symmetric = 0;
      check(MatGetValues(K, 1, &row, 1, &columns[i], &symmetric));
      antisymmetric.push_back({row, columns[i], values[i] - symmetric});
      largest[0] = std::max(largest[0], std::abs(values[i] - symmetric));
      largest[1] = std::max(largest[1], std::abs(values[i]));
    }
    check(MatRestoreRow(J, row, &count, &columns, &values));
  }
  all_reduce(system.comm(), MPI_MAX, largest);
  if (largest[0] <= kRounding * largest[1]) return false;
  for (const Entry& e : antisymmetric) check(MatSetValue(K, e.row, e.column, e.value, ADD_VALUES));
  check(MatAssemblyBegin(K, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(K, MAT_FINAL_ASSEMBLY));
  check(MatSetOption(K, MAT_SYMMETRIC, PETSC_FALSE));
  return true;
}

}  // namespace

StiffnessAtRest stiffness_at_rest(System& system, const Kinematics& state) {
  const MatHandle J = tangent_at_rest(system, state, {1, 0, 0});
  StiffnessAtRest out;
  out.matrix = symmetric_part(J.get());
  out.is_symmetric = !add_asymmetry_of_bodies(system, J.get(), out.matrix.get());
  return out;
}

MatHandle mass_at_rest(System& system, const Kinematics& state) {
  MatHandle M = symmetric_part(tangent_at_rest(system, state, {0, 0, 1}).get());
  clear_held(system, M.get());
  return M;
}

MatHandle damping_at_rest(System& system, const Kinematics& state) {
  MatHandle C;
  check(MatConvert(tangent_at_rest(system, state, {0, 1, 0}).get(), MATAIJ, MAT_INITIAL_MATRIX, C.out()));
  clear_held(system, C.get());
  return C;
}

void solve_directly(KSP ksp) {
  check(KSPSetType(ksp, KSPPREONLY));
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCLU));
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
}

}  // namespace hawser
