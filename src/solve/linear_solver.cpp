#include "hawser/solve/linear_solver.hpp"

#include <vector>

namespace hawser {
namespace {

// Blocks of the nodes on this rank that an element ties to a lower rank: taken out, what is left of the
// chains does not couple the ranks.
std::vector<PetscInt> interface_blocks(const System& system) {
  const LocalMesh& m = system.mesh();
  int rank = 0;
  MPI_Comm_rank(system.comm(), &rank);
  std::vector<char> cut(static_cast<size_t>(m.owned), 0);
  const int first = m.owned > 0 ? m.global_block[0] : 0;
  for (const LocalElement& e : m.elements) {
    const int a = e.first < m.owned ? e.first : e.second, b = e.first < m.owned ? e.second : e.first;
    if (b < m.owned) continue;
    // Ranks number their blocks in order, so a smaller block belongs to a lower rank.
    if (m.global_block[static_cast<size_t>(m.block[static_cast<size_t>(b)])] < first)
      cut[static_cast<size_t>(a)] = 1;
  }
  std::vector<PetscInt> blocks;
  for (int n = 0; n < m.owned; ++n)
    if (cut[static_cast<size_t>(n)])
      for (int k = 0; k <= m.rotates(n); ++k)
        blocks.push_back(m.global_block[static_cast<size_t>(m.block[static_cast<size_t>(n)] + k)]);
  return blocks;
}

using IsHandle = Handle<IS, ISDestroy>;

void default_option(const std::string& name, const std::string& value) {
  PetscBool set = PETSC_FALSE;
  check(PetscOptionsHasName(nullptr, nullptr, name.c_str(), &set));
  if (!set) check(PetscOptionsSetValue(nullptr, name.c_str(), value.c_str()));
}

}  // namespace

void configure_linear_solver(KSP ksp, const System& system, const char* prefix) {
  int size = 1;
  MPI_Comm_size(system.comm(), &size);
  check(KSPSetOptionsPrefix(ksp, prefix));
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  if (size == 1) {
    check(KSPSetType(ksp, KSPPREONLY));
    check(PCSetType(pc, PCLU));
    check(PCFactorSetMatOrderingType(pc, MATORDERINGNATURAL));
    check(KSPSetFromOptions(ksp));
    return;
  }
  const std::string p = std::string("-") + prefix;
  check(KSPSetType(ksp, KSPGMRES));
  check(KSPSetPCSide(ksp, PC_RIGHT));
  check(KSPSetTolerances(ksp, 1e-12, PETSC_DEFAULT, PETSC_DEFAULT, 50));
  check(PCSetType(pc, PCFIELDSPLIT));
  default_option(p + "pc_fieldsplit_type", "schur");
  default_option(p + "pc_fieldsplit_schur_fact_type", "full");
  default_option(p + "pc_fieldsplit_schur_precondition", "full");
  default_option(p + "fieldsplit_chains_ksp_type", "preonly");
  default_option(p + "fieldsplit_chains_pc_type", "bjacobi");
  default_option(p + "fieldsplit_chains_sub_pc_type", "lu");
  default_option(p + "fieldsplit_chains_sub_pc_factor_mat_ordering_type", "natural");
  default_option(p + "fieldsplit_cuts_ksp_type", "preonly");
  default_option(p + "fieldsplit_cuts_pc_type", "redundant");
  default_option(p + "fieldsplit_cuts_redundant_pc_type", "lu");
  check(KSPSetFromOptions(ksp));
  PetscBool split = PETSC_FALSE;
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCFIELDSPLIT, &split));
  if (!split) return;
  const std::vector<PetscInt> blocks = interface_blocks(system);
  const LocalMesh& m = system.mesh();
  const PetscInt first = m.owned_blocks > 0 ? m.global_block[0] : 0;
  std::vector<char> cut(static_cast<size_t>(m.owned_blocks), 0);
  for (PetscInt b : blocks) cut[static_cast<size_t>(b - first)] = 1;
  std::vector<PetscInt> rest;
  for (PetscInt b = 0; b < m.owned_blocks; ++b)
    if (!cut[static_cast<size_t>(b)]) rest.push_back(first + b);
  IsHandle chains, cuts;
  check(ISCreateBlock(system.comm(), 3, static_cast<PetscInt>(rest.size()), rest.data(), PETSC_COPY_VALUES,
                      chains.out()));
  check(ISCreateBlock(system.comm(), 3, static_cast<PetscInt>(blocks.size()), blocks.data(),
                      PETSC_COPY_VALUES, cuts.out()));
  check(PCFieldSplitSetIS(pc, "chains", chains.get()));
  check(PCFieldSplitSetIS(pc, "cuts", cuts.get()));
}

int negative_eigenvalues(Mat J) {
  MatHandle a, t, s;
  check(MatConvert(J, MATAIJ, MAT_INITIAL_MATRIX, a.out()));
  check(MatTranspose(a.get(), MAT_INITIAL_MATRIX, t.out()));
  check(MatAXPY(a.get(), 1, t.get(), DIFFERENT_NONZERO_PATTERN));
  check(MatSetOption(a.get(), MAT_SYMMETRIC, PETSC_TRUE));
  check(MatConvert(a.get(), MATSBAIJ, MAT_INITIAL_MATRIX, s.out()));
  MatHandle factor;
  if (MatGetFactor(s.get(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor.out())) return -1;
  check(MatMumpsSetIcntl(factor.get(), 24, 1));  // what PETSc asks for before it tells the inertia
  check(MatMumpsSetIcntl(factor.get(), 13, 1));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  IsHandle rows, columns;
  if (MatCholeskyFactorSymbolic(factor.get(), s.get(), nullptr, &info)) return -1;
  if (MatCholeskyFactorNumeric(factor.get(), s.get(), &info)) return -1;
  PetscInt negative = 0, zero = 0, positive = 0;
  if (MatGetInertia(factor.get(), &negative, &zero, &positive)) return -1;
  return static_cast<int>(negative);
}

}  // namespace hawser
