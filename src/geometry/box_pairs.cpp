#include "hawser/geometry/box_pairs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace hawser {
namespace {

constexpr int kLevels = 16, kBits = 20;  // of a cell's key: level and three coordinates
constexpr int kLast = (1 << kBits) - 1;

struct Cell {
  std::array<int, 3> at;
  int level;
  std::uint64_t key() const {
    std::uint64_t k = static_cast<std::uint64_t>(level);
    for (int c : at) k = k << kBits | static_cast<std::uint64_t>(c);
    return k;
  }
};

// Keys to cells, open addressing.
class Table {
 public:
  explicit Table(size_t n)
      : shift_(64 - static_cast<int>(std::bit_width(2 * n + 1))),
        slots_(size_t{1} << (64 - shift_), Slot{0, -1}) {}
  // The number of the cell, `fresh` when it is new.
  int insert(std::uint64_t key, int fresh) {
    size_t i = start(key);
    while (slots_[i].cell >= 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    if (slots_[i].cell < 0) slots_[i] = {key, fresh};
    return slots_[i].cell;
  }
  int find(std::uint64_t key) const {
    size_t i = start(key);
    while (slots_[i].cell >= 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return slots_[i].cell;
  }

 private:
  struct Slot {
    std::uint64_t key;
    int cell;
  };
  size_t start(std::uint64_t key) const { return static_cast<size_t>(key * 0x9E3779B97F4A7C15u >> shift_); }
  int shift_;
  std::vector<Slot> slots_;
};

bool usable(const Box& b) { return b.lo.allFinite() && b.hi.allFinite() && !b.empty(); }

}  // namespace

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes) {
  std::vector<std::pair<int, int>> out;
  Box all;
  double largest = 0;
  for (const Box& b : boxes) {
    if (!usable(b)) continue;
    all.add(b);
    largest = std::max(largest, b.extent().maxCoeff());
  }
  if (all.empty()) return out;

  // Cells of level l are coarsest / 2^l; a box is at the finest level whose cells are not smaller than it.
  const double across = std::max(all.extent().maxCoeff(), 1e-300);
  const double coarsest = std::max(largest, across / kLast);
  int finest = 0;
  while (finest + 1 < kLevels && across / std::ldexp(coarsest, -(finest + 1)) < kLast) ++finest;

  Table table(boxes.size());
  std::vector<Cell> cells;
  std::vector<int> cell_of(boxes.size(), -1), start;
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (!usable(boxes[i])) continue;
    const double size = boxes[i].extent().maxCoeff();
    int level = 0;
    while (level < finest && std::ldexp(coarsest, -(level + 1)) >= size) ++level;
    const Vec3 p = (boxes[i].centre() - all.lo) / coarsest;
    Cell c{{}, level};
    // Nested cells: those of a coarser level are found by halving.
    for (int k = 0; k < 3; ++k)
      c.at[static_cast<size_t>(k)] = std::clamp(static_cast<int>(std::ldexp(p[k], level)), 0, kLast);
    cell_of[i] = table.insert(c.key(), static_cast<int>(cells.size()));
    if (cell_of[i] == static_cast<int>(cells.size())) cells.push_back(c);
  }
  // Boxes by cell.
  start.assign(cells.size() + 1, 0);
  for (int c : cell_of)
    if (c >= 0) ++start[static_cast<size_t>(c) + 1];
  for (size_t c = 0; c < cells.size(); ++c) start[c + 1] += start[c];
  struct Entry {
    Box box;
    int number;
  };
  std::vector<Entry> entries(static_cast<size_t>(start.back()));
  std::vector<int> next(start.begin(), start.end() - 1);
  unsigned occupied = 0;
  for (size_t i = 0; i < boxes.size(); ++i)
    if (const int c = cell_of[i]; c >= 0)
      entries[static_cast<size_t>(next[static_cast<size_t>(c)]++)] = {boxes[i], static_cast<int>(i)};
  for (const Cell& c : cells) occupied |= 1u << c.level;

  const auto between = [&](size_t a, size_t b) {
    for (int i = start[a]; i < start[a + 1]; ++i)
      for (int j = a == b ? i + 1 : start[b]; j < start[b + 1]; ++j) {
        const Entry &p = entries[static_cast<size_t>(i)], &q = entries[static_cast<size_t>(j)];
        if (p.box.overlaps(q.box)) out.emplace_back(std::minmax(p.number, q.number));
      }
  };
  for (size_t a = 0; a < cells.size(); ++a) {
    between(a, a);
    for (int level = cells[a].level; level >= 0; --level) {
      if (!(occupied >> level & 1)) continue;
      const int up = cells[a].level - level;
      for (int n = 0; n < 27; ++n) {
        if (up == 0 && n <= 13) continue;  // each two cells of a level once
        Cell c{{}, level};
        bool inside = true;
        for (size_t k = 0, m = static_cast<size_t>(n); k < 3; ++k, m /= 3) {
          c.at[k] = (cells[a].at[k] >> up) + static_cast<int>(m % 3) - 1;
          inside &= c.at[k] >= 0 && c.at[k] <= kLast;
        }
        if (!inside) continue;
        if (const int b = table.find(c.key()); b >= 0) between(a, static_cast<size_t>(b));
      }
    }
  }
  return out;
}

}  // namespace hawser
