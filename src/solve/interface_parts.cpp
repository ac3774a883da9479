// Finds the parts of the interface between ranks by labels that spread over the pattern of the matrix, and
// numbers the unknowns of each part at the rank that solves it.
#include "hawser/solve/interface_parts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "hawser/base/gather.hpp"

namespace hawser {
namespace {

using Blocks = std::vector<PetscInt>;

// Local rows of A: own columns, columns of other ranks and the global numbers of the latter, in blocks.
struct LocalRows {
  explicit LocalRows(Mat A) {
    check(MatMPIBAIJGetSeqBAIJ(A, &own, &other, &ghosts));
    PetscInt n = 0;
    check(MatGetLocalSize(A, &n, nullptr));
    owned = n / 3;
    check(MatGetSize(other, nullptr, &n));
    others = n / 3;
    check(MatGetOwnershipRange(A, &first, nullptr));
    first /= 3;
  }
  Mat own = nullptr, other = nullptr;
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

// Group of each local block (own ones, then ghosts) that the pattern connects: its first block.
Blocks connected(const LocalRows& local) {
  Blocks group(static_cast<size_t>(local.owned + local.others));
  std::iota(group.begin(), group.end(), 0);
  const auto first_of = [&group](PetscInt i) {
    while (group[i] != i) {
      group[i] = group[group[i]];
      i = group[i];
    }
    return i;
  };
  const auto join = [&](PetscInt a, PetscInt b) {
    a = first_of(a);
    b = first_of(b);
    group[std::max(a, b)] = std::min(a, b);
  };
  for_each_block(local.own, join);
  for_each_block(local.other, [&](PetscInt row, PetscInt column) { join(row, local.owned + column); });
  for (size_t i = 0; i < group.size(); ++i) group[i] = first_of(static_cast<PetscInt>(i));
  return group;
}

// Smallest global number connected with each local block, over all ranks. blocks: from each block to its
// ghosts. Collective.
Blocks labels(MPI_Comm comm, const LocalRows& local, PetscSF blocks) {
  const Blocks group = connected(local);
  Blocks least(group.size());
  for (PetscInt i = 0; i < local.owned; ++i) least[i] = local.first + i;
  for (PetscInt i = 0; i < local.others; ++i) least[local.owned + i] = local.ghosts[i];
  bool changed = true;
  while (changed) {
    Blocks of_group = least;
    for (size_t i = 0; i < group.size(); ++i) of_group[group[i]] = std::min(of_group[group[i]], least[i]);
    for (size_t i = 0; i < group.size(); ++i) least[i] = of_group[group[i]];
    const Blocks before = least;
    PetscInt* ghosts = least.data() + local.owned;
    check(PetscSFReduceBegin(blocks, MPIU_INT, ghosts, least.data(), MPI_MIN));
    check(PetscSFReduceEnd(blocks, MPIU_INT, ghosts, least.data(), MPI_MIN));
    check(PetscSFBcastBegin(blocks, MPIU_INT, least.data(), ghosts, MPI_REPLACE));
    check(PetscSFBcastEnd(blocks, MPIU_INT, least.data(), ghosts, MPI_REPLACE));
    changed = on_any_rank(comm, least != before);
  }
  return least;
}

// Place of an unknown block at the rank that solves its part: its index among all blocks solved there, the
// first index and size of its part, and the offset of the part's matrix.
struct Place {
  PetscInt at = 0, first = 0, size = 0, matrix = 0;
};
constexpr int kPlace = sizeof(Place) / sizeof(PetscInt);

// A committed MPI type of n contiguous values.
class Row {
 public:
  Row(int n, MPI_Datatype of) {
    MPI_Type_contiguous(n, of, &type_);
    MPI_Type_commit(&type_);
  }
  ~Row() { MPI_Type_free(&type_); }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

// Sends lists of blocks to other ranks, and returns a Place for each block. Collective.
class Questions {
 public:
  // lists: by rank; each consists of the label of a part, the number of its blocks, the blocks, and so on.
  Questions(MPI_Comm comm, PetscMPIInt tag, const std::map<int, Blocks>& lists) : comm_(comm), tag_(tag) {
    std::vector<PetscMPIInt> to;
    Blocks lengths;
    for (const auto& [rank, list] : lists) {
      to.push_back(rank);
      lengths.push_back(static_cast<PetscInt>(list.size()));
    }
    PetscMPIInt count = 0, *from = nullptr;
    PetscInt* received = nullptr;
    check(PetscCommBuildTwoSided(comm, 1, MPIU_INT, static_cast<PetscMPIInt>(to.size()), to.data(),
                                 lengths.data(), &count, &from, &received));
    for (int i = 0; i < count; ++i) received_[from[i]].resize(static_cast<size_t>(received[i]));
    check(PetscFree(from));
    check(PetscFree(received));
    exchange(lists, received_, MPIU_INT);
  }
  const std::map<int, Blocks>& received() const { return received_; }
  // answers: to the ranks of `received`; out: from the ranks that were asked, of the right size.
  void answer(const std::map<int, std::vector<Place>>& answers,
              std::map<int, std::vector<Place>>& out) const {
    const Row place(kPlace, MPIU_INT);
    exchange(answers, out, place);
  }

 private:
  template <class T>
  void exchange(const std::map<int, std::vector<T>>& send, std::map<int, std::vector<T>>& receive,
                MPI_Datatype type) const {
    std::vector<MPI_Request> requests;
    for (auto& [rank, list] : receive)
      MPI_Irecv(list.data(), static_cast<int>(list.size()), type, rank, tag_, comm_,
                &requests.emplace_back());
    for (const auto& [rank, list] : send)
      MPI_Isend(list.data(), static_cast<int>(list.size()), type, rank, tag_, comm_,
                &requests.emplace_back());
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  }
  MPI_Comm comm_;
  PetscMPIInt tag_;
  std::map<int, Blocks> received_;
};

// Calls visit(label, block) for each block of a list of Questions.
template <class Visit>
void for_each_asked(const Blocks& list, const Visit& visit) {
  for (size_t i = 0; i < list.size();) {
    const PetscInt label = list[i], n = list[i + 1];
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

void bring(PetscSF sf, int each, const std::vector<double>& leaves, std::vector<double>& roots) {
  const Row row(each, MPI_DOUBLE);
  check(PetscSFReduceBegin(sf, row, leaves.data(), roots.data(), MPI_REPLACE));
  check(PetscSFReduceEnd(sf, row, leaves.data(), roots.data(), MPI_REPLACE));
}

}  // namespace

InterfaceParts::InterfaceParts(Mat A) {
  const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(A));
  const LocalRows local(A);
  PetscLayout layout = nullptr;
  check(PetscLayoutCreateFromSizes(comm, local.owned, PETSC_DETERMINE, 1, &layout));
  const Handle<PetscLayout, PetscLayoutDestroy> of_blocks(layout);
  SfHandle blocks;
  check(PetscSFCreate(comm, blocks.out()));
  check(PetscSFSetGraphLayout(blocks.get(), layout, local.others, nullptr, PETSC_COPY_VALUES, local.ghosts));
  const Blocks label = labels(comm, local, blocks.get());

  const PetscInt* copies = nullptr;
  check(PetscSFComputeDegreeBegin(blocks.get(), &copies));
  check(PetscSFComputeDegreeEnd(blocks.get(), &copies));
  std::map<PetscInt, InterfacePart> found;
  for (PetscInt i = 0; i < local.owned; ++i)
    if (copies[i] > 0) found[label[i]];
  for (PetscInt i = 0; i < local.others; ++i)
    found[label[local.owned + i]].ghosts.push_back(static_cast<int>(i));
  for (PetscInt i = 0; i < local.owned; ++i) {
    const auto part = found.find(label[i]);
    if (part == found.end()) continue;
    if (copies[i] > 0) part->second.shared.push_back(static_cast<int>(part->second.rows.size()));
    part->second.rows.push_back(static_cast<int>(i));
  }

  // The rank that solves a part assigns the places of its blocks, in the order of their numbers.
  std::map<int, Blocks> asked;
  std::map<int, std::vector<Place>> places;
  std::vector<PetscMPIInt> solver;
  for (const auto& [name, part] : found) {
    check(PetscLayoutFindOwner(layout, name, &solver.emplace_back()));
    if (part.shared.empty()) continue;
    Blocks& list = asked[solver.back()];
    list.insert(list.end(), {name, static_cast<PetscInt>(part.shared.size())});
    for (const int k : part.shared) list.push_back(local.first + part.rows[static_cast<size_t>(k)]);
    std::vector<Place>& room = places[solver.back()];
    room.resize(room.size() + part.shared.size());
  }
  PetscMPIInt tag = 0;
  check(PetscObjectGetNewTag(reinterpret_cast<PetscObject>(A), &tag));
  const Questions questions(comm, tag, asked);
  std::map<PetscInt, Blocks> whole;
  for (const auto& [rank, list] : questions.received())
    for_each_asked(list, [&](PetscInt name, PetscInt block) { whole[name].push_back(block); });
  std::map<PetscInt, Place> first_of;
  PetscInt unknowns = 0, entries = 0;
  for (auto& [name, list] : whole) {
    std::sort(list.begin(), list.end());
    const auto size = static_cast<PetscInt>(list.size());
    first_of[name] = {unknowns, unknowns, size, entries};
    unknowns += size;
    entries += size * size;
    solved_.push_back(static_cast<int>(size));
    largest_ = std::max(largest_, 3 * static_cast<int>(size));
  }
  all_reduce(comm, MPI_MAX, largest_);
  std::map<int, std::vector<Place>> answers;
  for (const auto& [rank, list] : questions.received())
    for_each_asked(list, [&](PetscInt name, PetscInt block) {
      const Blocks& all = whole[name];
      Place place = first_of[name];
      place.at += static_cast<PetscInt>(std::lower_bound(all.begin(), all.end(), block) - all.begin());
      answers[rank].push_back(place);
    });
  questions.answer(answers, places);

  // Owners send the places of ghosts.
  std::vector<Place> own(static_cast<size_t>(local.owned)), ghost(static_cast<size_t>(local.others));
  std::map<int, size_t> next;
  size_t p = 0;
  for (const auto& [name, part] : found) {
    for (const int k : part.shared) own[part.rows[k]] = places[solver[p]][next[solver[p]]++];
    ++p;
  }
  const Row place(kPlace, MPIU_INT);
  check(PetscSFBcastBegin(blocks.get(), place, own.data(), ghost.data(), MPI_REPLACE));
  check(PetscSFBcastEnd(blocks.get(), place, own.data(), ghost.data(), MPI_REPLACE));

  std::vector<PetscSFNode> shared, ghosts, matrices;
  p = 0;
  for (auto& [name, part] : found) {
    for (const int j : part.ghosts) ghosts.push_back({solver[p], ghost[j].at});
    for (const int k : part.shared) {
      const Place& row = own[part.rows[k]];
      shared.push_back({solver[p], row.at});
      for (const int j : part.ghosts)
        matrices.push_back(
            {solver[p], row.matrix + (row.at - row.first) * row.size + (ghost[j].at - ghost[j].first)});
    }
    parts_.push_back(std::move(part));
    ++p;
  }
  shared_ = forest(comm, unknowns, shared);
  ghosts_ = forest(comm, unknowns, ghosts);
  matrices_ = forest(comm, entries, matrices);
}

void InterfaceParts::bring_shared(const std::vector<double>& shared, std::vector<double>& solved) const {
  size_t unknowns = 0;
  for (const int size : solved_) unknowns += 3 * static_cast<size_t>(size);
  solved.assign(unknowns, 0);
  bring(shared_.get(), 3, shared, solved);
}

void InterfaceParts::send_ghosts(const std::vector<double>& solved, std::vector<double>& ghosts) const {
  size_t unknowns = 0;
  for (const InterfacePart& part : parts_) unknowns += 3 * part.ghosts.size();
  ghosts.resize(unknowns);
  const Row row(3, MPI_DOUBLE);
  check(PetscSFBcastBegin(ghosts_.get(), row, solved.data(), ghosts.data(), MPI_REPLACE));
  check(PetscSFBcastEnd(ghosts_.get(), row, solved.data(), ghosts.data(), MPI_REPLACE));
}

void InterfaceParts::bring_matrices(const std::vector<double>& shared_ghosts,
                                    std::vector<double>& solved) const {
  size_t entries = 0;
  for (const int size : solved_) entries += 9 * static_cast<size_t>(size) * static_cast<size_t>(size);
  solved.assign(entries, 0);
  bring(matrices_.get(), 9, shared_ghosts, solved);
}

}  // namespace hawser
