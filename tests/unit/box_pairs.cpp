// Overlapping pairs of boxes against every pair tried.
#include "hawser/geometry/box_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hawser {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs sorted(Pairs p) {
  std::sort(p.begin(), p.end());
  return p;
}

Pairs every_pair(const std::vector<Box>& boxes) {
  Pairs out;
  for (size_t i = 0; i < boxes.size(); ++i)
    for (size_t j = i + 1; j < boxes.size(); ++j)
      if (!boxes[i].empty() && !boxes[j].empty() && boxes[i].overlaps(boxes[j]))
        out.emplace_back(static_cast<int>(i), static_cast<int>(j));
  return out;
}

// Sizes over `decades` powers of ten, in a room that makes each overlap a few others.
std::vector<Box> random_boxes(int n, double decades, double room, unsigned seed) {
  std::mt19937_64 rng(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < n; ++i) {
    const Vec3 c = room * Vec3(unit(rng), unit(rng), unit(rng));
    const double size = std::pow(10, -decades * unit(rng));
    const Vec3 half = 0.5 * size * Vec3(unit(rng), unit(rng), unit(rng));
    boxes.push_back({c - half, c + half});
  }
  return boxes;
}

TEST(BoxPairs, RandomBoxesOfOneSizeAndOfMany) {
  for (const double decades : {0.0, 1.0, 4.0, 9.0}) {
    const auto boxes = random_boxes(700, decades, 3, 1 + static_cast<unsigned>(decades));
    const Pairs expected = every_pair(boxes);
    EXPECT_GT(expected.size(), 20u);
    EXPECT_EQ(sorted(overlapping_pairs(boxes)), expected) << decades;
  }
}

// The room is 10^9 boxes wide: finer cells than the keys have bits for.
TEST(BoxPairs, FarApart) {
  auto boxes = random_boxes(200, 0, 4, 5);
  const auto far = random_boxes(200, 0, 4, 6);
  for (const Box& b : far) boxes.push_back({b.lo + Vec3::Constant(1e9), b.hi + Vec3::Constant(1e9)});
  EXPECT_EQ(sorted(overlapping_pairs(boxes)), every_pair(boxes));
}

TEST(BoxPairs, PointsTouchingFacesAndNothing) {
  const Vec3 o = Vec3::Zero(), e = Vec3::Ones();
  EXPECT_TRUE(overlapping_pairs({}).empty());
  EXPECT_EQ(sorted(overlapping_pairs(std::vector<Box>{{o, o}, {o, o}})), (Pairs{{0, 1}}));
  EXPECT_EQ(sorted(overlapping_pairs(std::vector<Box>{{o, e}, {e, 2 * e}, {2.5 * e, 3 * e}})),
            (Pairs{{0, 1}}));
  const Vec3 nan = Vec3::Constant(std::nan(""));
  EXPECT_EQ(sorted(overlapping_pairs(std::vector<Box>{Box{}, {o, e}, {nan, e}, Box::everything(), {o, e}})),
            (Pairs{{1, 4}}));
}

}  // namespace
}  // namespace hawser
