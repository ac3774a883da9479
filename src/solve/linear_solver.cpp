#include "hawser/solve/linear_solver.hpp"

#include <algorithm>
#include <numeric>

#include "hawser/solve/elimination_order.hpp"
#include "hawser/solve/gathered_solver.hpp"
#include "hawser/solve/substructure.hpp"

namespace hawser {
namespace {

// Of the blocks of the whole, at least so many must be shared before gathering all of it is thought of: farms
// on many ranks never do.
constexpr int kManyShared = 8;
// Models of so many blocks that are cut or touch are gathered all the same: it costs no more than the
// messages, and the answer is that of one rank to the last bit.
constexpr double kSmall = 2000;
// Costs in multiplications of blocks: to send a block to all; one of a dense system, of which caches see
// more; what MUMPS does beside multiplying, a block of the matrix, and how much of the ranks it uses.
constexpr double kSend = 4, kDense = 1.0 / 3, kMumpsBlock = 40, kMumpsShare = 1.0 / 3;

double over_ranks(const System& system, double x, MPI_Op op) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, op, system.comm());
  return x;
}

// Blocks that some rank sees as ghosts, counted once for each rank that does.
double shared_blocks(const System& system) {
  return over_ranks(system, system.mesh().blocks() - system.mesh().owned_blocks, MPI_SUM);
}

// This rank's rows and columns alone.
BlockGraph own_graph(const System& system) {
  const int n = system.mesh().owned_blocks;
  BlockGraph g;
  g.start.assign(static_cast<size_t>(n) + 1, 0);
  for (const auto& [row, column] : system.pattern())
    if (column < n && column != row) g.next.push_back(column), ++g.start[static_cast<size_t>(row) + 1];
  std::partial_sum(g.start.begin(), g.start.end(), g.start.begin());
  return g;
}

// Factors of the slowest rank, the columns of what couples it to others, the dense system.
double substructuring_work(const System& system, double shared) {
  const BlockGraph g = own_graph(system);
  const std::vector<int> order = cheapest_order(g);
  const double ghosts = system.mesh().blocks() - system.mesh().owned_blocks;
  const double mine = factorisation_work(g, order) + 2 * ghosts * factor_blocks(g, order);
  return over_ranks(system, mine, MPI_MAX) + kDense / 3 * shared * shared * shared + kSend * shared * shared;
}

enum class Direct { substructuring, gathered, mumps };

// The cheapest, by numbers that all ranks know. `order`: of the whole, when it is to be gathered.
Direct choose(const System& system, std::vector<int>& order) {
  int size = 1;
  MPI_Comm_size(system.comm(), &size);
  const double shared = shared_blocks(system),
               whole = over_ranks(system, system.mesh().owned_blocks, MPI_SUM);
  const Direct chains = 3 * shared <= kMaxShared ? Direct::substructuring : Direct::mumps;
  const bool small = whole <= kSmall && (shared > 0 || system.coupled());
  if (!small && (!system.coupled() || kManyShared * shared < whole)) return chains;
  const BlockGraph g = gather_graph(system);
  order = cheapest_order(g);
  if (small) return Direct::gathered;
  const double work = factorisation_work(g, order), blocks = static_cast<double>(g.next.size()) + g.size();
  const double gathered = work + kSend * blocks;
  const double other = chains == Direct::substructuring
                           ? substructuring_work(system, shared)
                           : work / std::max(1.0, kMumpsShare * size) + kMumpsBlock * blocks;
  return gathered <= other ? Direct::gathered : chains;
}

}  // namespace

void configure_linear_solver(KSP ksp, const System& system, const char* prefix) {
  int size = 1;
  MPI_Comm_size(system.comm(), &size);
  check(KSPSetOptionsPrefix(ksp, prefix));
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  const MatOrderingType order = system.coupled() ? cheapest_ordering() : MATORDERINGNATURAL;
  if (size == 1) {
    check(KSPSetType(ksp, KSPPREONLY));
    check(PCSetType(pc, PCLU));
    check(PCFactorSetMatOrderingType(pc, order));
    check(KSPSetFromOptions(ksp));
    return;
  }
  check(KSPSetType(ksp, KSPPREONLY));
  std::vector<int> elimination;
  switch (choose(system, elimination)) {
    case Direct::substructuring:
      use_substructuring(pc, order);
      break;
    case Direct::gathered:
      use_gathered(pc, system.mesh(), elimination);
      break;
    case Direct::mumps:
      check(PCSetType(pc, PCLU));
      check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  }
  check(KSPSetFromOptions(ksp));
}

int negative_eigenvalues(Mat J) {
  MatHandle a, t;
  check(MatConvert(J, MATAIJ, MAT_INITIAL_MATRIX, a.out()));
  check(MatTranspose(a.get(), MAT_INITIAL_MATRIX, t.out()));
  check(MatAXPY(a.get(), 1, t.get(), DIFFERENT_NONZERO_PATTERN));
  check(MatSetOption(a.get(), MAT_SYMMETRIC, PETSC_TRUE));
  MatHandle factor;
  if (MatGetFactor(a.get(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor.out())) return -1;
  check(MatMumpsSetIcntl(factor.get(), 24, 1));  // what PETSc asks for before it tells the inertia
  check(MatMumpsSetIcntl(factor.get(), 13, 1));
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info));
  if (MatCholeskyFactorSymbolic(factor.get(), a.get(), nullptr, &info)) return -1;
  if (MatCholeskyFactorNumeric(factor.get(), a.get(), &info)) return -1;
  PetscInt negative = 0, zero = 0, positive = 0;
  if (MatGetInertia(factor.get(), &negative, &zero, &positive)) return -1;
  return static_cast<int>(negative);
}

}  // namespace hawser
