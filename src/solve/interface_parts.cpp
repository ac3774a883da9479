// Finds the parts of the interface between ranks by labels that spread over the pattern of the matrix, and
// numbers the unknowns of each part at the rank that solves it.
#include "hawser/solve/interface_parts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "hawser/base/exchange.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/disjoint_sets.hpp"

namespace hawser {
namespace {

using Blocks = std::vector<PetscInt>;

// Local rows of A: columns of this rank, columns of other ranks and the global numbers of the latter, in
// blocks.
struct LocalRows {
  explicit LocalRows(Mat A) {
    check(MatMPIBAIJGetSeqBAIJ(A, &diagonal, &off_diagonal, &ghosts));
    PetscInt n = 0;
    check(MatGetLocalSize(A, &n, nullptr));
    owned = n / 3;
    check(MatGetSize(off_diagonal, nullptr, &n));
    others = n / 3;
    check(MatGetOwnershipRange(A, &first, nullptr));
    first /= 3;
  }
  Mat diagonal = nullptr, off_diagonal = nullptr;
  const PetscInt* ghosts = nullptr;
  PetscInt owned = 0, others = 0, first = 0;
};

// Calls visit(row, column) for each block of the pattern of a sequential matrix.
template <class Visit>
void for_each_block(Mat m, const Visit& visit) {
  PetscInt rows = 0;
  const PetscInt *starts = nullptr, *columns = nullptr;
  PetscBool done = PETSC_FALSE;
  check(MatGetRowIJ(m, 0, PETSC_FALSE, PETSC_TRUE, &rows, &starts, &columns, &done));
  for (PetscInt row = 0; row < rows; ++row)
    for (PetscInt k = starts[row]; k < starts[row + 1]; ++k) visit(row, columns[k]);
  check(MatRestoreRowIJ(m, 0, PETSC_FALSE, PETSC_TRUE, &rows, &starts, &columns, &done));
}

// Group of each local block (owned ones, then ghosts) that the pattern connects: its first block.
Blocks connected(const LocalRows& local) {
  DisjointSets groups(static_cast<size_t>(local.owned + local.others));
  for_each_block(local.diagonal, [&](PetscInt row, PetscInt column) { groups.unite(row, column); });
  for_each_block(local.off_diagonal,
                 [&](PetscInt row, PetscInt column) { groups.unite(row, local.owned + column); });
  const std::vector<int> first = groups.smallest_of_all();
  return {first.begin(), first.end()};
}

// Smallest global number connected with each local block, over all ranks. blocks: from each block to its
// ghosts. Collective.
Blocks labels(MPI_Comm comm, const LocalRows& local, PetscSF blocks) {
  const Blocks group = connected(local);
  Blocks smallest(group.size());
  for (PetscInt i = 0; i < local.owned; ++i) smallest[i] = local.first + i;
  for (PetscInt i = 0; i < local.others; ++i) smallest[local.owned + i] = local.ghosts[i];
  bool changed = true;
  while (changed) {
    Blocks smallest_of_group = smallest;
    for (size_t i = 0; i < group.size(); ++i)
      smallest_of_group[group[i]] = std::min(smallest_of_group[group[i]], smallest[i]);
    for (size_t i = 0; i < group.size(); ++i) smallest[i] = smallest_of_group[group[i]];
    const Blocks before = smallest;
    PetscInt* ghosts = smallest.data() + local.owned;
    check(PetscSFReduceBegin(blocks, MPIU_INT, ghosts, smallest.data(), MPI_MIN));
    check(PetscSFReduceEnd(blocks, MPIU_INT, ghosts, smallest.data(), MPI_MIN));
    check(PetscSFBcastBegin(blocks, MPIU_INT, smallest.data(), ghosts, MPI_REPLACE));
    check(PetscSFBcastEnd(blocks, MPIU_INT, smallest.data(), ghosts, MPI_REPLACE));
    changed = on_any_rank(comm, smallest != before);
  }
  return smallest;
}

// Index of an unknown block at the rank that solves its part: its index among all blocks solved there, the
// first index and size of its part, and the offset of the part's matrix.
struct SolverIndex {
  PetscInt at = 0, first = 0, size = 0, matrix = 0;
};

// Blocks whose index a rank requests from another one: the label of a part, the number of its blocks, the
// blocks, and so on.
using BlockRequest = Blocks;

// Calls visit(label, block) for each block of a request.
template <class Visit>
void for_each_requested(const BlockRequest& list, const Visit& visit) {
  for (size_t i = 0; i < list.size();) {
    const PetscInt label = list[i];
    const PetscInt n = list[i + 1];
    for (PetscInt k = 0; k < n; ++k) visit(label, list[i + 2 + static_cast<size_t>(k)]);
    i += 2 + static_cast<size_t>(n);
  }
}

// Star forest with contiguous `leaves` and `roots` on this rank. Collective.
SfHandle forest(MPI_Comm comm, PetscInt roots, std::vector<PetscSFNode> leaves) {
  SfHandle sf;
  check(PetscSFCreate(comm, sf.out()));
  check(PetscSFSetGraph(sf.get(), roots, static_cast<PetscInt>(leaves.size()), nullptr, PETSC_COPY_VALUES,
                        leaves.data(), PETSC_COPY_VALUES));
  check(PetscSFSetUp(sf.get()));
  return sf;
}

// `each` numbers for each leaf, set at its root.
template <size_t each>
void send_to_roots(PetscSF sf, const std::vector<double>& leaves, std::vector<double>& roots) {
  const MessageType<std::array<double, each>> row;
  check(PetscSFReduceBegin(sf, row, leaves.data(), roots.data(), MPI_REPLACE));
  check(PetscSFReduceEnd(sf, row, leaves.data(), roots.data(), MPI_REPLACE));
}

// The star forest from blocks of a layout to their copies as ghosts. Collective.
SfHandle ghost_forest(MPI_Comm comm, PetscLayout layout, const LocalRows& local) {
  SfHandle sf;
  check(PetscSFCreate(comm, sf.out()));
  check(PetscSFSetGraphLayout(sf.get(), layout, local.others, nullptr, PETSC_COPY_VALUES, local.ghosts));
  return sf;
}

// This rank's blocks of each part, by label. blocks: ghost_forest(). Collective.
std::map<PetscInt, InterfacePart> find_parts(MPI_Comm comm, PetscLayout layout, const LocalRows& local,
                                             PetscSF blocks) {
  const Blocks label = labels(comm, local, blocks);
  const PetscInt* copies = nullptr;
  check(PetscSFComputeDegreeBegin(blocks, &copies));
  check(PetscSFComputeDegreeEnd(blocks, &copies));
  std::map<PetscInt, InterfacePart> parts;
  for (PetscInt i = 0; i < local.owned; ++i)
    if (copies[i] > 0) parts[label[i]];
  for (PetscInt i = 0; i < local.others; ++i)
    parts[label[local.owned + i]].ghosts.push_back(static_cast<int>(i));
  for (PetscInt i = 0; i < local.owned; ++i) {
    const auto part = parts.find(label[i]);
    if (part == parts.end()) continue;
    if (copies[i] > 0) part->second.shared.push_back(static_cast<int>(part->second.rows.size()));
    part->second.rows.push_back(static_cast<int>(i));
  }
  for (auto& [name, part] : parts) check(PetscLayoutFindOwner(layout, name, &part.solver));
  return parts;
}

// Parts that this rank solves, in the order of their labels; the blocks of a part are in the order of their
// numbers.
class SolvedParts {
 public:
  // requests: those of other ranks, by rank.
  explicit SolvedParts(const std::map<int, BlockRequest>& requests) {
    for (const auto& [rank, list] : requests)
      for_each_requested(list, [&](PetscInt name, PetscInt block) { parts_[name].blocks.push_back(block); });
    for (auto& [name, part] : parts_) {
      std::sort(part.blocks.begin(), part.blocks.end());
      const auto size = static_cast<PetscInt>(part.blocks.size());
      part.first = {unknowns, unknowns, size, entries};
      unknowns += size;
      entries += size * size;
      sizes.push_back(static_cast<int>(size));
    }
  }
  SolverIndex place(PetscInt name, PetscInt block) const {
    const auto& [all, first] = parts_.at(name);
    SolverIndex out = first;
    out.at += static_cast<PetscInt>(std::lower_bound(all.begin(), all.end(), block) - all.begin());
    return out;
  }
  PetscInt unknowns = 0, entries = 0;  // blocks of all parts, and of their matrices
  std::vector<int> sizes;              // blocks of each

 private:
  struct Part {
    Blocks blocks;
    SolverIndex first;
  };
  std::map<PetscInt, Part> parts_;
};

// Place of each shared block, as assigned by the rank that solves its part. requests: those of other ranks.
// Collective.
std::vector<SolverIndex> places_of_shared(MPI_Comm comm, PetscMPIInt tag, const LocalRows& local,
                                          const std::map<PetscInt, InterfacePart>& parts,
                                          const std::map<int, BlockRequest>& requests,
                                          const SolvedParts& solved) {
  std::map<int, std::vector<SolverIndex>> replies, places;
  for (const auto& [rank, list] : requests)
    for_each_requested(
        list, [&](PetscInt name, PetscInt block) { replies[rank].push_back(solved.place(name, block)); });
  std::map<int, std::vector<int>> rows;  // owned blocks requested from each rank
  for (const auto& [name, part] : parts)
    for (const int k : part.shared) rows[part.solver].push_back(part.rows[k]);
  for (const auto& [rank, blocks] : rows) places[rank].resize(blocks.size());
  exchange_lists(comm, tag, replies, places);
  std::vector<SolverIndex> out(static_cast<size_t>(local.owned));
  for (const auto& [rank, blocks] : rows)
    for (size_t k = 0; k < blocks.size(); ++k) out[blocks[k]] = places[rank][k];
  return out;
}

// Requests to the ranks that solve the parts.
std::map<int, BlockRequest> requests_for(const LocalRows& local,
                                         const std::map<PetscInt, InterfacePart>& parts) {
  std::map<int, BlockRequest> out;
  for (const auto& [name, part] : parts) {
    if (part.shared.empty()) continue;
    BlockRequest& list = out[part.solver];
    list.insert(list.end(), {name, static_cast<PetscInt>(part.shared.size())});
    for (const int k : part.shared) list.push_back(local.first + part.rows[k]);
  }
  return out;
}

// Places of the ghosts, sent by their owners. Collective.
std::vector<SolverIndex> places_of_ghosts(const LocalRows& local, PetscSF blocks,
                                          const std::vector<SolverIndex>& owned) {
  std::vector<SolverIndex> out(static_cast<size_t>(local.others));
  const MessageType<SolverIndex> place;
  check(PetscSFBcastBegin(blocks, place, owned.data(), out.data(), MPI_REPLACE));
  check(PetscSFBcastEnd(blocks, place, owned.data(), out.data(), MPI_REPLACE));
  return out;
}

// Star forests from this rank's blocks of each part to the rank that solves it.
struct Forests {
  SfHandle shared, ghosts, matrices;
};
// owned, others: places of owned blocks that are shared, and of ghosts. Collective.
Forests build_forests(MPI_Comm comm, const std::vector<InterfacePart>& parts,
                      const std::vector<SolverIndex>& owned, const std::vector<SolverIndex>& others,
                      const SolvedParts& solved) {
  std::vector<PetscSFNode> shared, ghosts, matrices;
  for (const InterfacePart& part : parts) {
    for (const int j : part.ghosts) ghosts.push_back({part.solver, others[j].at});
    for (const int k : part.shared) {
      const SolverIndex& row = owned[part.rows[k]];
      shared.push_back({part.solver, row.at});
      for (const int j : part.ghosts) {
        const PetscInt column = others[j].at - others[j].first;
        matrices.push_back({part.solver, row.matrix + (row.at - row.first) * row.size + column});
      }
    }
  }
  return {forest(comm, solved.unknowns, shared), forest(comm, solved.unknowns, ghosts),
          forest(comm, solved.entries, matrices)};
}

}  // namespace

InterfaceParts::InterfaceParts(Mat A) {
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(A));
  const LocalRows local(A);
  PetscLayout layout = nullptr;
  check(PetscLayoutCreateFromSizes(comm, local.owned, PETSC_DETERMINE, 1, &layout));
  const Handle<PetscLayout, PetscLayoutDestroy> block_layout(layout);
  const SfHandle blocks = ghost_forest(comm, layout, local);
  std::map<PetscInt, InterfacePart> parts = find_parts(comm, layout, local, blocks.get());

  PetscMPIInt tag = 0;
  check(PetscObjectGetNewTag(reinterpret_cast<PetscObject>(A), &tag));
  const std::map<int, BlockRequest> requests = send_lists(comm, tag, requests_for(local, parts));
  const SolvedParts solved(requests);
  const std::vector<SolverIndex> owned = places_of_shared(comm, tag, local, parts, requests, solved);
  const std::vector<SolverIndex> ghosts = places_of_ghosts(local, blocks.get(), owned);

  solved_ = solved.sizes;
  for (const int size : solved_) largest_ = std::max(largest_, 3 * size);
  all_reduce(comm, MPI_MAX, largest_);
  for (auto& [name, part] : parts) parts_.push_back(std::move(part));
  Forests forests = build_forests(comm, parts_, owned, ghosts, solved);
  shared_ = std::move(forests.shared);
  ghosts_ = std::move(forests.ghosts);
  matrices_ = std::move(forests.matrices);
}

void InterfaceParts::send_shared(const std::vector<double>& shared, std::vector<double>& solved) const {
  size_t unknowns = 0;
  for (const int size : solved_) unknowns += 3 * static_cast<size_t>(size);
  solved.assign(unknowns, 0);
  send_to_roots<3>(shared_.get(), shared, solved);
}

void InterfaceParts::send_ghosts(const std::vector<double>& solved, std::vector<double>& ghosts) const {
  size_t unknowns = 0;
  for (const InterfacePart& part : parts_) unknowns += 3 * part.ghosts.size();
  ghosts.resize(unknowns);
  const MessageType<std::array<double, 3>> row;
  check(PetscSFBcastBegin(ghosts_.get(), row, solved.data(), ghosts.data(), MPI_REPLACE));
  check(PetscSFBcastEnd(ghosts_.get(), row, solved.data(), ghosts.data(), MPI_REPLACE));
}

void InterfaceParts::send_matrices(const std::vector<double>& shared_ghosts,
                                   std::vector<double>& solved) const {
  size_t entries = 0;
  for (const int size : solved_) entries += 9 * static_cast<size_t>(size) * static_cast<size_t>(size);
  solved.assign(entries, 0);
  send_to_roots<9>(matrices_.get(), shared_ghosts, solved);
}

}  // namespace hawser
