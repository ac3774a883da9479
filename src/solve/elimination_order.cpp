#include "hawser/solve/elimination_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>

#include "hawser/base/handle.hpp"

namespace hawser {
namespace {

// Entries below the diagonal in each column of L: walks up the elimination tree row by row (Liu 1990, SIAM J.
// Matrix Anal. Appl. 11, section 3 and 5).
std::vector<int> column_counts(const BlockGraph& g, const std::vector<int>& order) {
  const size_t n = order.size();
  std::vector<int> place(n), parent(n, -1), mark(n, -1), count(n, 0);
  for (size_t k = 0; k < n; ++k) place[static_cast<size_t>(order[k])] = static_cast<int>(k);
  for (size_t k = 0; k < n; ++k) {
    const int row = static_cast<int>(k);
    mark[k] = row;
    const size_t node = static_cast<size_t>(order[k]);
    for (int e = g.start[node]; e < g.start[node + 1]; ++e) {
      int c = place[static_cast<size_t>(g.next[static_cast<size_t>(e)])];
      for (; c < row && mark[static_cast<size_t>(c)] != row; c = parent[static_cast<size_t>(c)]) {
        const size_t i = static_cast<size_t>(c);
        if (parent[i] < 0) parent[i] = row;
        ++count[i];
        mark[i] = row;
      }
    }
  }
  return count;
}

// A node at the end of a long shortest path, then breadth first, neighbours of few neighbours first.
std::vector<int> reverse_cuthill_mckee(const BlockGraph& g) {
  const int n = g.size();
  std::vector<int> order;
  order.reserve(static_cast<size_t>(n));
  std::vector<int> seen(static_cast<size_t>(n), 0);
  const auto degree = [&](int i) {
    return g.start[static_cast<size_t>(i) + 1] - g.start[static_cast<size_t>(i)];
  };
  const auto sweep = [&](int from, int mark, std::vector<int>& out) {
    const size_t first = out.size();
    out.push_back(from);
    seen[static_cast<size_t>(from)] = mark;
    for (size_t i = first; i < out.size(); ++i) {
      const size_t begin = out.size(), node = static_cast<size_t>(out[i]);
      for (int e = g.start[node]; e < g.start[node + 1]; ++e) {
        const int other = g.next[static_cast<size_t>(e)];
        int& s = seen[static_cast<size_t>(other)];
        if (s != mark) s = mark, out.push_back(other);
      }
      std::sort(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                [&](int a, int b) { return std::pair(degree(a), a) < std::pair(degree(b), b); });
    }
  };
  std::vector<int> trial;
  for (int root = 0; root < n; ++root) {
    if (seen[static_cast<size_t>(root)] == 3) continue;
    int from = root;
    for (int mark = 1; mark <= 2; ++mark) {
      trial.clear();
      sweep(from, mark, trial);
      from = trial.back();
    }
    sweep(from, 3, order);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<int> minimum_degree(const BlockGraph& g) {
  const int n = g.size();
  Eigen::SparseMatrix<double> pattern(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(g.next.size());
  for (int i = 0; i < n; ++i)
    for (int e = g.start[static_cast<size_t>(i)]; e < g.start[static_cast<size_t>(i) + 1]; ++e)
      entries.emplace_back(i, g.next[static_cast<size_t>(e)], 1.0);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().data(), order.indices().data() + n};
}

PetscErrorCode order_matrix(Mat A, MatOrderingType, IS* rows, IS* columns) {
  PetscFunctionBegin;
  PetscInt n = 0;
  const PetscInt *start = nullptr, *next = nullptr;
  PetscBool done = PETSC_FALSE;
  PetscCall(MatGetRowIJ(A, 0, PETSC_TRUE, PETSC_TRUE, &n, &start, &next, &done));
  if (!done) PetscFunctionReturn(PETSC_ERR_SUP);
  BlockGraph g;
  g.start.push_back(0);
  for (PetscInt i = 0; i < n; ++i) {
    for (PetscInt e = start[i]; e < start[i + 1]; ++e)
      if (next[e] != i) g.next.push_back(static_cast<int>(next[e]));
    g.start.push_back(static_cast<int>(g.next.size()));
  }
  PetscCall(MatRestoreRowIJ(A, 0, PETSC_TRUE, PETSC_TRUE, &n, &start, &next, &done));
  const std::vector<int> order = cheapest_order(g);
  const std::vector<PetscInt> p(order.begin(), order.end());
  PetscCall(
      ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(p.size()), p.data(), PETSC_COPY_VALUES, rows));
  PetscCall(ISSetPermutation(*rows));
  PetscCall(ISDuplicate(*rows, columns));
  PetscCall(ISSetPermutation(*columns));
  PetscFunctionReturn(0);
}

}  // namespace

double factorisation_work(const BlockGraph& graph, const std::vector<int>& order) {
  double work = 0;
  for (const int c : column_counts(graph, order)) work += (c + 1.0) * (c + 1.0);
  return work;
}

double factor_blocks(const BlockGraph& graph, const std::vector<int>& order) {
  const std::vector<int> count = column_counts(graph, order);
  return std::accumulate(count.begin(), count.end(), static_cast<double>(count.size()));
}

std::vector<int> cheapest_order(const BlockGraph& graph) {
  std::vector<int> best(static_cast<size_t>(graph.size()));
  std::iota(best.begin(), best.end(), 0);
  std::vector<int> count = column_counts(graph, best);
  if (2 * std::accumulate(count.begin(), count.end(), 0L) <= static_cast<long>(graph.next.size()))
    return best;
  double least = factorisation_work(graph, best);
  for (auto* make : {minimum_degree, reverse_cuthill_mckee}) {
    std::vector<int> order = make(graph);
    const double work = factorisation_work(graph, order);
    if (work < least) least = work, best = std::move(order);
  }
  return best;
}

MatOrderingType cheapest_ordering() {
  static const char* const kName = "hawser_cheapest";
  static bool done = false;
  if (!done) check(MatOrderingRegister(kName, order_matrix));
  done = true;
  return kName;
}

}  // namespace hawser
