// Orders of elimination: permutations, their work counted against elimination carried out, never worse than
// the order as it is.
#include "hawser/solve/elimination_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace hawser::elimination_order_test {
namespace {

using Rows = std::vector<std::set<int>>;

BlockGraph graph(const Rows& rows) {
  BlockGraph g;
  g.start.push_back(0);
  for (const auto& r : rows) {
    g.next.insert(g.next.end(), r.begin(), r.end());
    g.start.push_back(static_cast<int>(g.next.size()));
  }
  return g;
}

void couple(Rows& rows, int a, int b) {
  const int n = static_cast<int>(rows.size());
  if (a == b || std::min(a, b) < 0 || std::max(a, b) >= n) return;
  rows[static_cast<size_t>(a)].insert(b), rows[static_cast<size_t>(b)].insert(a);
}

// A chain; with turns of `turn` nodes, each touches the next turn.
Rows coil(int n, int turn) {
  Rows rows(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i) {
    couple(rows, i, i + 1);
    if (turn > 0)
      for (int k = -1; k <= 1; ++k) couple(rows, i, i + turn + k);
  }
  return rows;
}

// Eliminates.
double work(Rows rows, const std::vector<int>& order) {
  double sum = 0;
  for (int i : order) {
    const std::set<int> near = rows[static_cast<size_t>(i)];
    sum += (static_cast<double>(near.size()) + 1) * (static_cast<double>(near.size()) + 1);
    for (int a : near) {
      rows[static_cast<size_t>(a)].erase(i);
      for (int b : near) couple(rows, a, b);
    }
  }
  return sum;
}

std::vector<int> as_it_is(int n) {
  std::vector<int> order(static_cast<size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

TEST(EliminationOrder, AChainStaysAsItIs) { EXPECT_EQ(cheapest_order(graph(coil(50, 0))), as_it_is(50)); }

TEST(EliminationOrder, WorkIsThatOfElimination) {
  for (int turn : {0, 7, 13}) {
    const Rows rows = coil(80, turn);
    std::vector<int> odd;
    for (int i = 0; i < 80; ++i) odd.push_back(37 * i % 80);
    EXPECT_EQ(factorisation_work(graph(rows), odd), work(rows, odd)) << turn;
    EXPECT_EQ(factorisation_work(graph(rows), as_it_is(80)), work(rows, as_it_is(80))) << turn;
  }
}

TEST(EliminationOrder, ACoilIsCheaperInAnotherOrder) {
  Rows rows = coil(400, 40);
  rows.emplace_back();  // and a node of its own
  const BlockGraph g = graph(rows);
  std::vector<int> order = cheapest_order(g);
  EXPECT_LT(factorisation_work(g, order), 0.5 * factorisation_work(g, as_it_is(401)));
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, as_it_is(401));
  EXPECT_TRUE(cheapest_order(graph(Rows{})).empty());
}

}  // namespace
}  // namespace hawser::elimination_order_test
