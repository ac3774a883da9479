// Pairs of boxes that overlap, by a hierarchical grid: each box in a cell of the level of its own size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hawser/geometry/box.hpp"
#include "hawser/geometry/large_vector.hpp"

namespace hawser {

// Finds them again and again in the same memory.
class BoxPairs {
 public:
  // All pairs i < j of overlapping boxes [m] as i << 32 | j, in no particular order, until the next call;
  // pairs that overlap only when rounded to single precision may be among them. Work and memory grow with the
  // number of boxes and of pairs. Boxes that are empty or not finite overlap nothing.
  std::span<const std::uint64_t> find(std::span<const Box> boxes);

 private:
  using Key = std::uint64_t;  // of a cell
  struct Grid;
  struct Walk;
  struct Entry {
    Key key;
    int number;
  };
  // Boxes in the order of their cells, each coordinate of a face for itself: as the vector unit takes them.
  // Behind the last come some of a cell that there is not.
  struct Placed {
    std::size_t size = 0;
    std::vector<Key> key;
    std::vector<std::uint32_t> number;
    std::array<std::vector<float>, 6> face;  // of the least x, y, z, of the largest
  };

  bool survey(std::span<const Box> boxes, Grid& grid);
  void place(std::span<const Box> boxes, const std::vector<int>& numbers, const Grid& grid, Placed& to);
  void sort(int bits);

  std::vector<double> sizes_;              // m, of the largest side; < 0: overlaps nothing
  std::vector<std::vector<int>> members_;  // of a level
  std::vector<Entry> entries_, scratch_;
  Placed own_, finer_;
  LargeVector<std::uint64_t> pairs_;
};

// Those that overlap to the last bit, for once.
std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes);

}  // namespace hawser
