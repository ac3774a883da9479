// The substructuring solver as a preconditioner: finds the unknowns shared between ranks, factorises a rank's
// own block and the dense system of the shared unknowns, and solves with both.
#include "hawser/solve/substructure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "hawser/base/gather.hpp"
#include "hawser/base/handle.hpp"
#include "hawser/solve/lu.hpp"
#include "pc_shell.hpp"

namespace hawser {
namespace {

using VecHandle = Handle<Vec, VecDestroy>;
using KspHandle = Handle<KSP, KSPDestroy>;

struct Substructure {
  KspHandle chains;                  // LU of this rank's diagonal block
  VecHandle ghost, column, x, y;     // sequential: ghost unknowns, a column of Ao, work vectors
  std::vector<PetscInt> shared;      // G: global scalar unknowns that are ghosts on some rank, ascending
  std::vector<int> mine;             // positions in G of the unknowns owned here
  std::vector<PetscInt> mine_local;  // and their local numbers
  std::vector<int> ghosts;           // positions in G of this rank's ghosts, in the order of Ao's columns
  Eigen::MatrixXd Z;                 // Ad^-1 Ao
  Eigen::PartialPivLU<Eigen::MatrixXd> small;
  bool coupled = false;
  bool ready = false;
};

MPI_Comm comm_of(PC pc) {
  MPI_Comm comm = MPI_COMM_NULL;
  PetscObjectGetComm(reinterpret_cast<PetscObject>(pc), &comm);
  return comm;
}

// Finds the shared unknowns. It is called once, because the pattern does not change.
void find_shared(PC pc, Mat A, Substructure& s, const PetscInt* block_columns, PetscInt ghost_blocks) {
  const MPI_Comm comm = comm_of(pc);
  const int size = ranks_of(comm);
  std::vector<int> counts(static_cast<size_t>(size)), starts(static_cast<size_t>(size), 0);
  const int n = static_cast<int>(ghost_blocks);
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
  for (size_t r = 1; r < counts.size(); ++r) starts[r] = starts[r - 1] + counts[r - 1];
  std::vector<PetscInt> blocks(static_cast<size_t>(starts.back() + counts.back()));
  MPI_Allgatherv(block_columns, n, MPIU_INT, blocks.data(), counts.data(), starts.data(), MPIU_INT, comm);
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  PetscInt first = 0, last = 0;
  check(MatGetOwnershipRange(A, &first, &last));
  for (PetscInt b : blocks)
    for (PetscInt c = 0; c < 3; ++c) {
      const PetscInt g = 3 * b + c;
      if (g >= first && g < last) {
        s.mine.push_back(static_cast<int>(s.shared.size()));
        s.mine_local.push_back(g - first);
      }
      s.shared.push_back(g);
    }
  for (PetscInt i = 0; i < ghost_blocks; ++i)
    for (PetscInt c = 0; c < 3; ++c) {
      const auto it = std::lower_bound(s.shared.begin(), s.shared.end(), 3 * block_columns[i] + c);
      s.ghosts.push_back(static_cast<int>(it - s.shared.begin()));
    }
  s.ready = true;
}

PetscErrorCode setup(PC pc) {
  PetscFunctionBegin;
  Substructure* s = nullptr;
  PetscCall(PCShellGetContext(pc, &s));
  Mat A = nullptr, Ad = nullptr, Ao = nullptr;
  const PetscInt* columns = nullptr;
  PetscCall(PCGetOperators(pc, nullptr, &A));
  PetscCall(MatMPIBAIJGetSeqBAIJ(A, &Ad, &Ao, &columns));
  PetscInt n = 0, ghosts = 0;
  PetscCall(MatGetSize(Ad, &n, nullptr));
  PetscCall(MatGetSize(Ao, nullptr, &ghosts));
  if (!s->ready) {
    find_shared(pc, A, *s, columns, ghosts / 3);
    PetscCall(MatCreateVecs(Ad, s->x.out(), s->y.out()));
    PetscCall(VecCreateSeq(PETSC_COMM_SELF, ghosts, s->ghost.out()));
    PetscCall(KSPCreate(PETSC_COMM_SELF, s->chains.out()));
    PetscCall(KSPSetType(s->chains.get(), KSPPREONLY));
    PC lu = nullptr;
    PetscCall(KSPGetPC(s->chains.get(), &lu));
    use_lu(lu, s->coupled);
  }
  PetscCall(KSPSetOperators(s->chains.get(), Ad, Ad));
  PetscCall(KSPSetUp(s->chains.get()));
  if (s->shared.empty()) PetscFunctionReturn(0);

  s->Z.resize(n, ghosts);
  for (PetscInt j = 0; j < ghosts; ++j) {
    PetscCall(VecZeroEntries(s->ghost.get()));
    PetscCall(VecSetValue(s->ghost.get(), j, 1, INSERT_VALUES));
    PetscCall(MatMult(Ao, s->ghost.get(), s->y.get()));
    PetscCall(KSPSolve(s->chains.get(), s->y.get(), s->x.get()));
    const PetscScalar* p = nullptr;
    PetscCall(VecGetArrayRead(s->x.get(), &p));
    std::copy(p, p + n, s->Z.col(j).data());
    PetscCall(VecRestoreArrayRead(s->x.get(), &p));
  }
  const Eigen::Index m = static_cast<Eigen::Index>(s->shared.size());
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(m, m);
  for (size_t i = 0; i < s->mine.size(); ++i) {
    W(s->mine[i], s->mine[i]) = 1;
    for (size_t j = 0; j < s->ghosts.size(); ++j)
      W(s->mine[i], s->ghosts[j]) += s->Z(s->mine_local[i], static_cast<Eigen::Index>(j));
  }
  MPI_Allreduce(MPI_IN_PLACE, W.data(), static_cast<int>(m * m), MPI_DOUBLE, MPI_SUM, comm_of(pc));
  s->small.compute(W);
  PetscFunctionReturn(0);
}

PetscErrorCode apply(PC pc, Vec b, Vec x) {
  PetscFunctionBegin;
  Substructure* s = nullptr;
  PetscCall(PCShellGetContext(pc, &s));
  const PetscScalar* pb = nullptr;
  PetscScalar* px = nullptr;
  PetscCall(VecGetArrayRead(b, &pb));
  PetscCall(VecPlaceArray(s->y.get(), pb));
  PetscCall(VecGetArray(x, &px));
  PetscCall(VecPlaceArray(s->x.get(), px));
  PetscCall(KSPSolve(s->chains.get(), s->y.get(), s->x.get()));
  PetscCall(VecResetArray(s->x.get()));
  PetscCall(VecResetArray(s->y.get()));
  if (!s->shared.empty()) {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s->shared.size()));
    for (size_t i = 0; i < s->mine.size(); ++i) g[s->mine[i]] = px[s->mine_local[i]];
    all_reduce(comm_of(pc), MPI_SUM, g);
    g = s->small.solve(g);
    Eigen::VectorXd ghost_values(static_cast<Eigen::Index>(s->ghosts.size()));
    for (size_t j = 0; j < s->ghosts.size(); ++j)
      ghost_values[static_cast<Eigen::Index>(j)] = g[s->ghosts[j]];
    if (ghost_values.size() > 0)
      Eigen::Map<Eigen::VectorXd>(px, s->Z.rows()).noalias() -= s->Z * ghost_values;
  }
  PetscCall(VecRestoreArray(x, &px));
  PetscCall(VecRestoreArrayRead(b, &pb));
  PetscFunctionReturn(0);
}

}  // namespace

void use_substructuring(PC pc, bool coupled) {
  auto s = std::make_unique<Substructure>();
  s->coupled = coupled;
  use_shell(pc, "chains cut between ranks", std::move(s), setup, apply);
}

}  // namespace hawser
