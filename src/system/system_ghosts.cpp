// The class System: new ghost nodes, vectors and matrices when other pairs of nodes are coupled.
#include <petscvec.h>

#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/system/system.hpp"

namespace hawser {
namespace {

bool all(MPI_Comm comm, bool local) {
  int yes = local;
  all_reduce(comm, MPI_MIN, yes);
  return yes;
}

}  // namespace

// A node that is coupled with a tied node is also coupled with the frame that carries it.
void System::with_frames(Couplings& c) const {
  const auto frame = [this](int n) { return mesh_.mesh->node(n).tied_to; };
  const std::vector<int> nodes = c.nodes;
  for (const int n : nodes)
    if (frame(n) >= 0) c.nodes.push_back(frame(n));
  const std::vector<std::pair<int, int>> pairs = c.pairs;
  const auto join = [&c](int a, int b) {
    if (a >= 0 && b >= 0 && a != b) c.pairs.emplace_back(std::min(a, b), std::max(a, b));
  };
  for (const auto& [a, b] : pairs) {
    join(frame(a), b);
    join(a, frame(b));
    join(frame(a), frame(b));
  }
}

CouplingChange System::update_couplings(const Kinematics& from, double h) {
  bool same = true;
  for (CouplesNodes* t : listed<CouplesNodes>()) same &= !t->refresh_couplings(from, h);
  if (same) return CouplingChange::unchanged;
  Couplings required;
  for (const CouplesNodes* t : listed<CouplesNodes>()) t->list_couplings(required);
  with_frames(required);
  required.sort();
  const bool fits = all(comm_, required.within(couplings_));
  if (!fits) {
    couplings_ = std::move(required);
    coupled_ = !all(comm_, couplings_.pairs.empty());
    set_coupling_ghosts(mesh_, couplings_.nodes);
    exchange_ = GhostExchange(comm_, mesh_);
    size_arrays();
    reghost_ties();
  }
  for (CouplesNodes* t : listed<CouplesNodes>()) t->renumber();
  return fits ? CouplingChange::pattern_changed : CouplingChange::layout_changed;
}

void System::update_ghosts(State& s) const {
  for (auto* values : {&s.x, &s.v, &s.a, &s.w, &s.alpha}) exchange_.update_ghosts(*values);
  exchange_.update_ghosts(s.q);
  if (!s.directors.empty()) exchange_.update_ghosts(s.directors);
}

// Held nodes of other ranks that are ghosts here must move with their ties, and their columns of the tangent
// are zero. Therefore their owners send the ties of new ghosts.
void System::reghost_ties() {
  struct Tie {
    bool tied = false;
    TiedNode at;  // its frame is a node of the mesh
  };
  std::vector<TiedNode> kept;
  std::vector<Tie> ties(mesh_.global.size());
  for (const TiedNode& s : tied_nodes_.nodes()) {
    if (s.node >= mesh_.element_ghosts_end) continue;
    kept.push_back(s);
    Tie& tie = ties[s.node];
    tie = {true, s};
    if (s.frame >= 0) tie.at.frame = mesh_.global[s.frame];
  }
  exchange_.update_ghosts(ties);
  for (int node = mesh_.element_ghosts_end; node < static_cast<int>(mesh_.global.size()); ++node) {
    if (!ties[node].tied) continue;
    TiedNode& s = kept.emplace_back(ties[node].at);
    s.node = node;
    s.frame = mesh_.find(s.frame);
  }
  tied_nodes_ = TiedNodes(mesh_, std::move(kept), BodyMotion(tied_nodes_.motion()));
  ties_ = TiedNodeForces(mesh_, tied_nodes_);
}

VecHandle System::create_vector() const {
  std::vector<PetscInt> ghosts(mesh_.global_block.begin() + mesh_.owned_blocks, mesh_.global_block.end());
  VecHandle v;
  check(VecCreateGhostBlock(comm_, 3, 3 * mesh_.owned_blocks, PETSC_DETERMINE,
                            static_cast<PetscInt>(ghosts.size()), ghosts.data(), v.out()));
  return v;
}

std::vector<std::pair<int, int>> System::pattern() const {
  std::vector<std::pair<int, int>> entries;
  auto couple = [&](int a, int b) {
    for (int i = 0; i <= mesh_.rotates(a); ++i)
      for (int j = 0; j <= mesh_.rotates(b); ++j) {
        const int row = mesh_.block[a] + i;
        if (row < mesh_.owned_blocks) entries.emplace_back(row, mesh_.block[b] + j);
      }
  };
  for (int n = 0; n < mesh_.owned; ++n) couple(n, n);
  const auto join = [&](int a, int b) {
    couple(a, b);
    couple(b, a);
  };
  for (const LocalElement& e : mesh_.elements) {
    join(e.first, e.second);
    const int first = mesh_.frame_of(e.first);
    const int second = mesh_.frame_of(e.second);
    if (first >= 0) {
      join(first, e.second);
      join(first, e.first);
    }
    if (second >= 0) {
      join(e.first, second);
      join(e.second, second);
    }
    if (first >= 0 && second >= 0 && first != second) join(first, second);
  }
  for (const auto& [m, n] : couplings_.pairs) {
    const int a = mesh_.find(m);
    const int b = mesh_.find(n);
    couple(a, b);
    couple(b, a);
  }
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  return entries;
}

MatHandle System::create_matrix() const {
  const std::vector<std::pair<int, int>> entries = pattern();
  const size_t rows = mesh_.owned_blocks;
  std::vector<PetscInt> diagonal(rows, 0);
  std::vector<PetscInt> off_diagonal(rows, 0);
  for (const auto& [row, column] : entries) ++(column < mesh_.owned_blocks ? diagonal : off_diagonal)[row];

  MatHandle A;
  check(MatCreate(comm_, A.out()));
  const PetscInt n = 3 * mesh_.owned_blocks;
  check(MatSetSizes(A.get(), n, n, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(A.get(), MATBAIJ));
  check(MatSetBlockSize(A.get(), 3));
  check(MatXAIJSetPreallocation(A.get(), 3, diagonal.data(), off_diagonal.data(), nullptr, nullptr));
  if (!sends()) check(MatSetOption(A.get(), MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
  // PETSc discards entries that are not written at the first assembly, but candidates may touch later.
  const double zero[9] = {};
  for (const auto& [row, column] : entries) {
    const PetscInt r = mesh_.global_block[row];
    const PetscInt c = mesh_.global_block[column];
    check(MatSetValuesBlocked(A.get(), 1, &r, 1, &c, zero, INSERT_VALUES));
  }
  check(MatAssemblyBegin(A.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A.get(), MAT_FINAL_ASSEMBLY));
  return A;
}

}  // namespace hawser
