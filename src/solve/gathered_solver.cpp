#include "hawser/solve/gathered_solver.hpp"

#include <algorithm>
#include <numeric>

#include "hawser/base/gather.hpp"
#include "hawser/base/handle.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "shell.hpp"

namespace hawser {
namespace {

constexpr PetscInt kBlock = 3, kEntries = kBlock * kBlock;

// Of each block of the parallel numbering, its number on one rank.
std::vector<int> file_order(const LocalMesh& mesh) {
  size_t blocks = 0;
  for (const Node& n : mesh.mesh->nodes) blocks += n.pinned_to >= 0 ? 0 : n.rotates ? 2 : 1;
  std::vector<int> number(blocks);
  int next = 0;
  for (size_t n = 0; n < mesh.mesh->nodes.size(); ++n)
    for (int k = 0; k <= mesh.mesh->nodes[n].rotates && mesh.mesh->nodes[n].pinned_to < 0; ++k)
      number[static_cast<size_t>(mesh.first_block[n] + k)] = next++;
  return number;
}

struct Gathered {
  std::vector<int> place;             // of each block of the parallel numbering, in the order of elimination
  GatherPlan rows, values;            // scalars of a vector; of a matrix
  std::vector<size_t> target;         // of each block that comes, where it begins among the values of `whole`
  std::vector<double> sent, come, b;  // values of this rank, of all ranks; right-hand side of all
  MatHandle whole;
  VecHandle x, y;
  KspHandle lu;
};

// This rank's parts of a matrix as PETSc keeps them: values by block, columns of `other` through `ghosts`.
struct Parts {
  Mat own = nullptr, other = nullptr;
  const PetscInt* ghosts = nullptr;
  explicit Parts(Mat A) { check(MatMPIBAIJGetSeqBAIJ(A, &own, &other, &ghosts)); }
};

// Rows and columns (of blocks, in the parallel numbering) of the blocks of one part, in their order.
void append_entries(Mat part, PetscInt first_row, PetscInt first_column, const PetscInt* ghosts,
                    std::vector<int>& entries) {
  PetscInt n = 0;
  const PetscInt *start = nullptr, *column = nullptr;
  PetscBool done = PETSC_FALSE;
  check(MatGetRowIJ(part, 0, PETSC_FALSE, PETSC_TRUE, &n, &start, &column, &done));
  if (!done) throw PetscFailure("a matrix that does not tell its rows");
  for (PetscInt r = 0; r < n; ++r)
    for (PetscInt e = start[r]; e < start[r + 1]; ++e) {
      entries.push_back(static_cast<int>(first_row + r));
      entries.push_back(static_cast<int>(ghosts ? ghosts[column[e]] : first_column + column[e]));
    }
  check(MatRestoreRowIJ(part, 0, PETSC_FALSE, PETSC_TRUE, &n, &start, &column, &done));
}

PetscInt blocks_of(Mat part) {
  MatInfo info;
  check(MatGetInfo(part, MAT_LOCAL, &info));
  return static_cast<PetscInt>(info.nz_used) / kEntries;
}

// The pattern does not change, so once.
void find_pattern(Mat A, MPI_Comm comm, Gathered& g) {
  const Parts parts(A);
  PetscInt first = 0, last = 0;
  check(MatGetOwnershipRange(A, &first, &last));
  g.rows = GatherPlan(comm, static_cast<int>(last - first));
  std::vector<int> mine;
  append_entries(parts.own, first / kBlock, first / kBlock, nullptr, mine);
  append_entries(parts.other, first / kBlock, 0, parts.ghosts, mine);
  const int n = static_cast<int>(mine.size());
  const GatherPlan pairs(comm, n);
  std::vector<int> all(pairs.all());
  pairs.gather(mine.data(), all);
  g.values = GatherPlan(comm, n / 2 * static_cast<int>(kEntries));
  g.sent.resize(static_cast<size_t>(n / 2 * kEntries)), g.come.resize(g.values.all());

  const PetscInt blocks = static_cast<PetscInt>(g.place.size());
  std::vector<std::pair<int, int>> entries;
  for (size_t i = 0; i < all.size(); i += 2)
    entries.emplace_back(g.place[static_cast<size_t>(all[i])], g.place[static_cast<size_t>(all[i + 1])]);
  std::vector<std::pair<int, int>> sorted = entries;
  std::sort(sorted.begin(), sorted.end());
  std::vector<PetscInt> in_row(static_cast<size_t>(blocks), 0);
  for (const auto& [row, column] : sorted) ++in_row[static_cast<size_t>(row)];
  check(MatCreateSeqBAIJ(PETSC_COMM_SELF, kBlock, kBlock * blocks, kBlock * blocks, 0, in_row.data(),
                         g.whole.out()));
  const double zero[kEntries] = {};
  for (const auto& [row, column] : sorted) {
    const PetscInt r = row, c = column;
    check(MatSetValuesBlocked(g.whole.get(), 1, &r, 1, &c, zero, INSERT_VALUES));
  }
  check(MatAssemblyBegin(g.whole.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(g.whole.get(), MAT_FINAL_ASSEMBLY));
  g.target.clear();
  for (const auto& e : entries)
    g.target.push_back(
        static_cast<size_t>(std::lower_bound(sorted.begin(), sorted.end(), e) - sorted.begin()) *
        static_cast<size_t>(kEntries));
  check(MatCreateVecs(g.whole.get(), g.x.out(), g.y.out()));
  g.b.resize(g.rows.all());
  check(KSPCreate(PETSC_COMM_SELF, g.lu.out()));
  check(KSPSetType(g.lu.get(), KSPPREONLY));
  PC lu = nullptr;
  check(KSPGetPC(g.lu.get(), &lu));
  check(PCSetType(lu, PCLU));
  check(PCFactorSetMatOrderingType(lu, MATORDERINGNATURAL));
}

PetscErrorCode setup(PC pc) {
  PetscFunctionBegin;
  Gathered* g = nullptr;
  PetscCall(PCShellGetContext(pc, &g));
  Mat A = nullptr;
  PetscCall(PCGetOperators(pc, nullptr, &A));
  if (!g->whole.get()) find_pattern(A, PetscObjectComm(reinterpret_cast<PetscObject>(A)), *g);
  const Parts parts(A);
  double* out = g->sent.data();
  for (Mat part : {parts.own, parts.other}) {
    PetscScalar* values = nullptr;
    PetscCall(MatSeqBAIJGetArray(part, &values));
    out = std::copy(values, values + kEntries * blocks_of(part), out);
    PetscCall(MatSeqBAIJRestoreArray(part, &values));
  }
  if (out != g->sent.data() + g->sent.size()) PetscFunctionReturn(PETSC_ERR_PLIB);
  g->values.gather(g->sent.data(), g->come);
  PetscScalar* whole = nullptr;
  PetscCall(MatSeqBAIJGetArray(g->whole.get(), &whole));
  for (size_t i = 0; i < g->target.size(); ++i)
    std::copy_n(g->come.data() + static_cast<size_t>(kEntries) * i, kEntries, whole + g->target[i]);
  PetscCall(MatSeqBAIJRestoreArray(g->whole.get(), &whole));
  PetscCall(MatAssemblyBegin(g->whole.get(), MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(g->whole.get(), MAT_FINAL_ASSEMBLY));
  PetscCall(KSPSetOperators(g->lu.get(), g->whole.get(), g->whole.get()));
  PetscCall(KSPSetUp(g->lu.get()));
  PetscFunctionReturn(0);
}

PetscErrorCode apply(PC pc, Vec b, Vec x) {
  PetscFunctionBegin;
  Gathered* g = nullptr;
  PetscCall(PCShellGetContext(pc, &g));
  const PetscScalar* in = nullptr;
  PetscInt n = 0;
  PetscCall(VecGetLocalSize(b, &n));
  PetscCall(VecGetArrayRead(b, &in));
  g->rows.gather(in, g->b);
  PetscCall(VecRestoreArrayRead(b, &in));
  PetscScalar *y = nullptr, *out = nullptr;
  PetscCall(VecGetArray(g->y.get(), &y));
  for (size_t i = 0; i < g->place.size(); ++i)
    std::copy_n(g->b.data() + kBlock * i, kBlock, y + kBlock * g->place[i]);
  PetscCall(VecRestoreArray(g->y.get(), &y));
  PetscCall(KSPSolve(g->lu.get(), g->y.get(), g->x.get()));
  PetscCall(VecGetArrayRead(g->x.get(), &in));
  PetscCall(VecGetArray(x, &out));
  const int* place = g->place.data() + g->rows.first() / kBlock;
  for (PetscInt i = 0; i < n / kBlock; ++i) std::copy_n(in + kBlock * place[i], kBlock, out + kBlock * i);
  PetscCall(VecRestoreArray(x, &out));
  PetscCall(VecRestoreArrayRead(g->x.get(), &in));
  PetscFunctionReturn(0);
}

}  // namespace

BlockGraph gather_graph(const System& system) {
  const LocalMesh& mesh = system.mesh();
  const std::vector<int> number = file_order(mesh);
  std::vector<int> mine;
  for (const auto& [row, column] : system.pattern()) {
    if (row == column) continue;
    mine.push_back(number[static_cast<size_t>(mesh.global_block[static_cast<size_t>(row)])]);
    mine.push_back(number[static_cast<size_t>(mesh.global_block[static_cast<size_t>(column)])]);
  }
  const GatherPlan shares(system.comm(), static_cast<int>(mine.size()));
  std::vector<int> all(shares.all());
  shares.gather(mine.data(), all);
  std::vector<std::pair<int, int>> edges;
  for (size_t i = 0; i < all.size(); i += 2) {
    edges.emplace_back(all[i], all[i + 1]);
    edges.emplace_back(all[i + 1], all[i]);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  BlockGraph g;
  g.start.assign(number.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++g.start[static_cast<size_t>(from) + 1];
    g.next.push_back(to);
  }
  std::partial_sum(g.start.begin(), g.start.end(), g.start.begin());
  return g;
}

void use_gathered(PC pc, const LocalMesh& mesh, const std::vector<int>& order) {
  auto g = std::make_unique<Gathered>();
  std::vector<int> position(order.size());
  for (size_t k = 0; k < order.size(); ++k) position[static_cast<size_t>(order[k])] = static_cast<int>(k);
  g->place = file_order(mesh);
  for (int& p : g->place) p = position[static_cast<size_t>(p)];
  use_shell(pc, "gathered on every rank", std::move(g), setup, apply);
}

}  // namespace hawser
