// Overlapping pairs of boxes against a test of all pairs.
#include "hawser/geometry/box_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hawser::box_pairs_test {
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

// Sizes over `decades` powers of ten, in a room where each overlaps a few others.
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

// The room is 10^9 boxes wide, which the bits of the keys cannot resolve.
TEST(BoxPairs, FarApart) {
  auto boxes = random_boxes(200, 0, 4, 5);
  const auto far = random_boxes(200, 0, 4, 6);
  for (const Box& b : far) boxes.push_back({b.lo + Vec3::Constant(1e9), b.hi + Vec3::Constant(1e9)});
  EXPECT_EQ(sorted(overlapping_pairs(boxes)), every_pair(boxes));
}

// Strongly uneven distributions of boxes.
TEST(BoxPairs, UnevenSetUps) {
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto moved = [](std::vector<Box> boxes, const Vec3& by) {
    for (Box& b : boxes) {
      b.lo += by;
      b.hi += by;
    }
    return boxes;
  };
  std::vector<std::vector<Box>> set_ups;
  // A wound line: each box has hundreds of neighbours.
  set_ups.push_back(random_boxes(900, 0, 0.7, 21));
  // All at one place, in one cell.
  set_ups.emplace_back(300, Box{Vec3(1, 2, 3), Vec3(1.5, 2.5, 3.5)});
  // Few boxes after many, in the same memory.
  set_ups.push_back(random_boxes(9, 0, 1, 22));
  // A long box among short ones, and one as large as the whole set.
  auto among = random_boxes(600, 0, 5, 23);
  among.push_back({Vec3(-1, 2, 2), Vec3(1000, 2.1, 2.1)});
  among.push_back({Vec3::Constant(-2), Vec3::Constant(6)});
  set_ups.push_back(among);
  // Clusters a kilometre apart, one of them at negative coordinates.
  auto apart = random_boxes(150, 0, 2, 24);
  for (const Vec3& by : {Vec3(1000, 0, 0), Vec3(0, 1000, -1000), Vec3(-1000, -1000, 1000)})
    for (const Box& b : moved(random_boxes(150, 1, 2, 25), by)) apart.push_back(b);
  set_ups.push_back(apart);
  // In a row along each axis with touching corners.
  for (int axis = 0; axis < 3; ++axis) {
    auto& row = set_ups.emplace_back();
    for (int i = 0; i < 200; ++i) {
      const Vec3 lo = i * Vec3::Unit(axis);
      row.push_back({lo, lo + Vec3::Ones()});
    }
    std::shuffle(row.begin(), row.end(), rng);
  }
  // Gaps and overlaps that single precision cannot distinguish from contact.
  auto& close = set_ups.emplace_back();
  for (int i = 0; i < 400; ++i) {
    const Vec3 lo(i + (unit(rng) - 0.5) * 1e-9, 0, 5000);
    close.push_back({lo, lo + Vec3::Ones()});
  }

  for (size_t k = 0; k < set_ups.size(); ++k) {
    const Pairs expected = every_pair(set_ups[k]);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(sorted(overlapping_pairs(set_ups[k])), expected) << k;
  }
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
}  // namespace hawser::box_pairs_test
