// The substructuring solver as a preconditioner: factorises a rank's own block and the dense systems of the
// interface parts that it solves, and solves with both.
#include "hawser/solve/substructure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <vector>

#include "hawser/solve/interface_parts.hpp"
#include "hawser/solve/lu.hpp"
#include "pc_shell.hpp"

namespace hawser {
namespace {

using VecHandle = Handle<Vec, VecDestroy>;
using KspHandle = Handle<KSP, KSPDestroy>;

struct Substructure {
  MatrixPattern pattern = MatrixPattern::chains;
  int max_unknowns = 0;  // largest number of unknowns of a part
  std::optional<InterfaceParts> interface;
  Handle<PC, PCDestroy> mumps;                              // if a part is too large
  KspHandle local_block;                                    // LU of this rank's diagonal block
  VecHandle ghost, x, y;                                    // sequential: ghost unknowns, work vectors
  std::vector<Eigen::MatrixXd> Z;                           // by part: its rows of Ad^-1 Ao
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXd>> small;  // by part that this rank solves
  std::vector<double> shared, solved, ghosts;               // values of the unknowns of the interface
};

PetscErrorCode make_mumps(PC pc, Substructure& s) {
  PetscFunctionBegin;
  PetscCall(PCShellSetName(pc, "MUMPS, as the cuts are long"));
  PetscCall(PCCreate(PetscObjectComm(reinterpret_cast<PetscObject>(pc)), s.mumps.out()));
  PetscCall(PCSetType(s.mumps.get(), PCLU));
  PetscCall(PCFactorSetMatSolverType(s.mumps.get(), MATSOLVERMUMPS));
  PetscFunctionReturn(0);
}

PetscErrorCode set_up_mumps(PC pc, Mat A, Substructure& s) {
  PetscFunctionBegin;
  PetscCall(PCSetOperators(s.mumps.get(), A, A));
  PetscCall(PCSetUp(s.mumps.get()));
  PCFailedReason reason = PC_NOERROR;
  PetscCall(PCGetFailedReason(s.mumps.get(), &reason));
  PetscCall(PCSetFailedReason(pc, reason));
  PetscFunctionReturn(0);
}

PetscErrorCode factor_local_block(Mat Ad, PetscInt ghosts, Substructure& s) {
  PetscFunctionBegin;
  PetscCall(MatCreateVecs(Ad, s.x.out(), s.y.out()));
  PetscCall(VecCreateSeq(PETSC_COMM_SELF, ghosts, s.ghost.out()));
  PetscCall(KSPCreate(PETSC_COMM_SELF, s.local_block.out()));
  PetscCall(KSPSetType(s.local_block.get(), KSPPREONLY));
  PC lu = nullptr;
  PetscCall(KSPGetPC(s.local_block.get(), &lu));
  use_lu(lu, s.pattern);
  PetscFunctionReturn(0);
}

// Z of every part. A solution has one column of each part, because parts do not share rows.
PetscErrorCode find_columns(Mat Ao, Substructure& s) {
  PetscFunctionBegin;
  const std::vector<InterfacePart>& parts = s.interface->parts();
  size_t columns = 0;
  s.Z.resize(parts.size());
  for (size_t p = 0; p < parts.size(); ++p) {
    s.Z[p].resize(3 * static_cast<Eigen::Index>(parts[p].rows.size()),
                  3 * static_cast<Eigen::Index>(parts[p].ghosts.size()));
    columns = std::max(columns, 3 * parts[p].ghosts.size());
  }
  for (size_t column = 0; column < columns; ++column) {
    PetscCall(VecZeroEntries(s.ghost.get()));
    for (const InterfacePart& part : parts)
      if (column < 3 * part.ghosts.size())
        PetscCall(VecSetValue(s.ghost.get(), 3 * part.ghosts[column / 3] + static_cast<int>(column % 3), 1,
                              INSERT_VALUES));
    PetscCall(MatMult(Ao, s.ghost.get(), s.y.get()));
    PetscCall(KSPSolve(s.local_block.get(), s.y.get(), s.x.get()));
    const PetscScalar* x = nullptr;
    PetscCall(VecGetArrayRead(s.x.get(), &x));
    for (size_t p = 0; p < parts.size(); ++p) {
      if (column >= 3 * parts[p].ghosts.size()) continue;
      double* to = s.Z[p].col(static_cast<Eigen::Index>(column)).data();
      for (const int row : parts[p].rows) to = std::copy_n(x + 3 * row, 3, to);
    }
    PetscCall(VecRestoreArrayRead(s.x.get(), &x));
  }
  PetscFunctionReturn(0);
}

// Factorises I + Z_G of the parts that this rank solves.
void factorise_parts(Substructure& s) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  std::vector<double> local, solved;
  const std::vector<InterfacePart>& parts = s.interface->parts();
  for (size_t p = 0; p < parts.size(); ++p)
    for (const int i : parts[p].shared)
      for (size_t j = 0; j < parts[p].ghosts.size(); ++j) {
        const RowMajor block = s.Z[p].block<3, 3>(3 * i, 3 * static_cast<Eigen::Index>(j));
        local.insert(local.end(), block.data(), block.data() + block.size());
      }
  s.interface->send_matrices(local, solved);
  s.small.clear();
  const double* from = solved.data();
  for (const int size : s.interface->solved()) {
    Eigen::MatrixXd W = Eigen::MatrixXd::Identity(3 * size, 3 * size);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j, from += 9)
        W.block<3, 3>(3 * i, 3 * j) += Eigen::Map<const RowMajor>(from);
    s.small.emplace_back(W);
  }
}

PetscErrorCode setup(PC pc) {
  PetscFunctionBegin;
  Substructure* s = nullptr;
  PetscCall(PCShellGetContext(pc, &s));
  Mat A = nullptr, Ad = nullptr, Ao = nullptr;
  PetscCall(PCGetOperators(pc, nullptr, &A));
  PetscCall(MatMPIBAIJGetSeqBAIJ(A, &Ad, &Ao, nullptr));
  if (!s->interface) {  // once, because the pattern does not change
    s->interface.emplace(A);
    PetscInt ghosts = 0;
    PetscCall(MatGetSize(Ao, nullptr, &ghosts));
    if (s->interface->largest() > s->max_unknowns)
      PetscCall(make_mumps(pc, *s));
    else
      PetscCall(factor_local_block(Ad, ghosts, *s));
  }
  if (s->mumps) {
    PetscCall(set_up_mumps(pc, A, *s));
    PetscFunctionReturn(0);
  }
  PetscCall(KSPSetOperators(s->local_block.get(), Ad, Ad));
  PetscCall(KSPSetUp(s->local_block.get()));
  PetscCall(find_columns(Ao, *s));
  factorise_parts(*s);
  PetscFunctionReturn(0);
}

// Adds the contribution of other ranks' unknowns to x, which contains Ad^-1 b.
void correct(Substructure& s, PetscScalar* x) {
  const std::vector<InterfacePart>& parts = s.interface->parts();
  s.shared.clear();
  for (const InterfacePart& part : parts)
    for (const int k : part.shared) {
      const PetscScalar* at = x + 3 * part.rows[static_cast<size_t>(k)];
      s.shared.insert(s.shared.end(), at, at + 3);
    }
  s.interface->send_shared(s.shared, s.solved);
  double* values = s.solved.data();
  for (const auto& small : s.small) {
    Eigen::Map<Eigen::VectorXd> g(values, small.rows());
    g = small.solve(g).eval();
    values += small.rows();
  }
  s.interface->send_ghosts(s.solved, s.ghosts);
  const double* ghosts = s.ghosts.data();
  for (size_t p = 0; p < parts.size(); ++p) {
    const Eigen::Map<const Eigen::VectorXd> g(ghosts, s.Z[p].cols());
    const Eigen::VectorXd change = s.Z[p] * g;
    const double* from = change.data();
    for (const int row : parts[p].rows)
      for (int c = 0; c < 3; ++c) x[3 * row + c] -= *from++;
    ghosts += s.Z[p].cols();
  }
}

PetscErrorCode apply(PC pc, Vec b, Vec x) {
  PetscFunctionBegin;
  Substructure* s = nullptr;
  PetscCall(PCShellGetContext(pc, &s));
  if (s->mumps) {
    PetscCall(PCApply(s->mumps.get(), b, x));
    PetscFunctionReturn(0);
  }
  const PetscScalar* pb = nullptr;
  PetscScalar* px = nullptr;
  PetscCall(VecGetArrayRead(b, &pb));
  PetscCall(VecPlaceArray(s->y.get(), pb));
  PetscCall(VecGetArray(x, &px));
  PetscCall(VecPlaceArray(s->x.get(), px));
  PetscCall(KSPSolve(s->local_block.get(), s->y.get(), s->x.get()));
  PetscCall(VecResetArray(s->x.get()));
  PetscCall(VecResetArray(s->y.get()));
  correct(*s, px);
  PetscCall(VecRestoreArray(x, &px));
  PetscCall(VecRestoreArrayRead(b, &pb));
  PetscFunctionReturn(0);
}

}  // namespace

void use_substructuring(PC pc, MatrixPattern pattern, int max_unknowns) {
  auto s = std::make_unique<Substructure>();
  s->pattern = pattern;
  s->max_unknowns = max_unknowns;
  use_shell(pc, "lines cut between ranks", std::move(s), setup, apply);
}

}  // namespace hawser
