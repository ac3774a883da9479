// A row of weights cut into parts: the parts are as even as possible, and the cuts have the smallest loss,
// against an exhaustive search.
#include "hawser/mesh/even_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace hawser::test::even_parts_test {
namespace {

constexpr CutKind kNothing = CutKind::between_components;
constexpr CutKind kLittle = CutKind::between_lines;
constexpr CutKind kMuch = CutKind::within_line;

std::vector<EqualItems> row(const std::vector<double>& weight, const std::vector<CutKind>& before) {
  std::vector<EqualItems> out;
  for (size_t i = 0; i < weight.size(); ++i) out.push_back({1, weight[i], before[i]});
  return out;
}

double heaviest(const std::vector<double>& weight, const std::vector<int>& first) {
  double most = 0;
  for (size_t k = 0; k + 1 < first.size(); ++k)
    most = std::max(most, std::accumulate(weight.begin() + first[k], weight.begin() + first[k + 1], 0.0));
  return most;
}

// Most even cut of the items from `first` on, by exhaustive search.
double most_even(const std::vector<double>& weight, size_t first, int parts) {
  if (parts == 1) return std::accumulate(weight.begin() + static_cast<long>(first), weight.end(), 0.0);
  double least = HUGE_VAL, sum = 0;
  for (size_t i = first; i <= weight.size(); ++i) {
    least = std::min(least, std::max(sum, most_even(weight, i, parts - 1)));
    if (i < weight.size()) sum += weight[i];
  }
  return least;
}

TEST(EvenParts, AsEvenAsTheItemsAllow) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const int items = 1 + static_cast<int>(random() % 8);
    const int parts = 1 + static_cast<int>(random() % 5);
    std::vector<double> weight;
    for (int i = 0; i < items; ++i) weight.push_back(static_cast<double>(random() % 10));
    weight.back() += 1;
    const std::vector<CutKind> before(weight.size(), kMuch);
    const std::vector<int> first = cut_into_even_parts(row(weight, before), parts, 1);
    EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
    ASSERT_EQ(first.size(), static_cast<size_t>(parts) + 1);
    EXPECT_EQ(first.front(), 0);
    EXPECT_EQ(first.back(), items);
    EXPECT_NEAR(heaviest(weight, first), most_even(weight, 0, parts), 1e-9) << trial;
  }
}

TEST(EvenParts, CutsWhereLeastIsLost) {
  const std::vector<double> weight(8, 1);
  using Cuts = std::vector<int>;
  // All kinds of cut are equal, so the even one before item 4 is chosen.
  EXPECT_EQ(cut_into_even_parts(row(weight, std::vector<CutKind>(8, kMuch)), 2, 1.3), (Cuts{0, 4, 8}));
  std::vector<CutKind> before(8, kMuch);
  before[5] = kNothing;
  EXPECT_EQ(cut_into_even_parts(row(weight, before), 2, 1.3), (Cuts{0, 5, 8}));
  EXPECT_EQ(cut_into_even_parts(row(weight, before), 2, 1.2), (Cuts{0, 4, 8}));
  before[3] = kLittle;
  EXPECT_EQ(cut_into_even_parts(row(weight, before), 2, 1.3), (Cuts{0, 5, 8}));
  before[5] = kMuch;
  EXPECT_EQ(cut_into_even_parts(row(weight, before), 2, 1.3), (Cuts{0, 3, 8}));
}

// Items given as runs of equal ones are cut like the same items given one by one.
TEST(EvenParts, RunsOfEqualItems) {
  std::mt19937 random(3);
  const CutKind kinds[] = {kNothing, kLittle, kMuch};
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<EqualItems> runs, one_by_one;
    for (auto r = 1 + random() % 6; r > 0; --r) {
      const EqualItems run{1 + static_cast<int>(random() % 9), 1 + static_cast<double>(random() % 5),
                           kinds[random() % 3]};
      runs.push_back(run);
      for (int i = 0; i < run.items; ++i) one_by_one.push_back({1, run.weight, i > 0 ? kMuch : run.before});
    }
    const int parts = 1 + static_cast<int>(random() % 5);
    for (const double most : {1.0, 1.07, 1.5})
      EXPECT_EQ(cut_into_even_parts(runs, parts, most), cut_into_even_parts(one_by_one, parts, most))
          << trial;
  }
}

TEST(EvenParts, NoItemsAndMorePartsThanItems) {
  EXPECT_EQ(cut_into_even_parts({}, 2, 1.07), std::vector<int>(3, 0));
  const std::vector<double> weight{3, 1};
  const std::vector<CutKind> before(2, kMuch);
  const std::vector<int> first = cut_into_even_parts(row(weight, before), 4, 1.07);
  EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
  EXPECT_EQ(heaviest(weight, first), 3);
  EXPECT_EQ(first.back(), 2);
}

}  // namespace
}  // namespace hawser::test::even_parts_test
