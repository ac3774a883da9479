// Cells are sorted by their coordinates, and neighbours are found by walking along the sorted lists together:
// memory is read in order, so that a box costs hardly more among many than among few.
#include "hawser/geometry/box_pairs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace hawser {
namespace {

constexpr int kLevels = 24, kBits = 20;           // most of a coordinate
constexpr std::int64_t kLast = (1 << kBits) - 4;  // cells of the finest level across everything

using Key = std::uint64_t;

// Coordinates of a level's cells as one number, sorted by x, then y, then z.
struct Keys {
  int bits;  // of a coordinate, so that sorting takes no more rounds than needed
  Key operator()(std::int64_t x, std::int64_t y, std::int64_t z) const {
    // One more: neighbours of the first cell have keys too.
    return static_cast<Key>(((x + 1) << 2 * bits) + ((y + 1) << bits) + z + 1);
  }
  Key shift(int dx, int dy) const {
    return static_cast<Key>((static_cast<std::int64_t>(dx) << 2 * bits) +
                            (static_cast<std::int64_t>(dy) << bits));
  }
};

struct Entry {
  Key key;
  int number;
};

// By key, stable: least significant digits first.
void sort_by_key(std::vector<Entry>& entries, std::vector<Entry>& scratch, int bits) {
  constexpr int kDigit = 8;
  scratch.resize(entries.size());
  for (int shift = 0; shift < bits; shift += kDigit) {
    std::array<size_t, (1 << kDigit) + 1> start{};
    const auto digit = [&](const Entry& e) { return e.key >> shift & ((1 << kDigit) - 1); };
    for (const Entry& e : entries) ++start[digit(e) + 1];
    for (size_t d = 1; d < start.size(); ++d) start[d] += start[d - 1];
    for (const Entry& e : entries) scratch[start[digit(e)]++] = e;
    entries.swap(scratch);
  }
}

struct Placed {
  Box box;
  Key key;
  int number;
};

using Pairs = std::vector<std::pair<int, int>>;

void test(const Placed& p, const Placed& q, Pairs& out) {
  if (p.box.overlaps(q.box)) out.emplace_back(std::min(p.number, q.number), std::max(p.number, q.number));
}

// A column of cells beside that of a box, from one below to one above, as the boxes are gone through in
// order.
struct Column {
  Key shift;
  size_t first = 0;
  void test_with(const Placed& a, const std::vector<Placed>& q, Pairs& out) {
    const Key low = a.key + shift - 1, high = a.key + shift + 1;
    while (first < q.size() && q[first].key < low) ++first;
    for (size_t i = first; i < q.size() && q[i].key <= high; ++i) test(a, q[i], out);
  }
};

bool usable(const Box& b) { return b.lo.allFinite() && b.hi.allFinite() && !b.empty(); }

}  // namespace

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes) {
  Pairs out;
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
  const double coarsest = std::max(largest, across / static_cast<double>(kLast));
  const auto cell = [&](int level) { return std::ldexp(coarsest, -level); };
  int finest = 0;
  while (finest + 1 < kLevels && across / cell(finest + 1) < static_cast<double>(kLast)) ++finest;
  std::vector<std::vector<int>> members(static_cast<size_t>(finest) + 1);
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (!usable(boxes[i])) continue;
    const double size = boxes[i].extent().maxCoeff();
    int level = 0;
    while (level < finest && cell(level + 1) >= size) ++level;
    members[static_cast<size_t>(level)].push_back(static_cast<int>(i));
  }

  std::vector<Entry> entries, scratch;
  const auto place = [&](const std::vector<int>& numbers, int level, const Keys& keys) {
    entries.clear();
    const double scale = 1 / cell(level);
    for (int i : numbers) {
      const Vec3 p = scale * (boxes[static_cast<size_t>(i)].centre() - all.lo);
      std::array<std::int64_t, 3> c;
      for (size_t k = 0; k < 3; ++k)
        c[k] = std::clamp(static_cast<std::int64_t>(p[static_cast<Eigen::Index>(k)]), std::int64_t{0}, kLast);
      entries.push_back({keys(c[0], c[1], c[2]), i});
    }
    sort_by_key(entries, scratch, 3 * keys.bits);
    std::vector<Placed> placed;
    placed.reserve(entries.size());
    for (const Entry& e : entries) placed.push_back({boxes[static_cast<size_t>(e.number)], e.key, e.number});
    return placed;
  };
  // Boxes of a finer level are looked for from the cells of the coarser that hold their centres.
  for (int level = 0; level <= finest; ++level) {
    const auto& here = members[static_cast<size_t>(level)];
    if (here.empty()) continue;
    const Keys keys{static_cast<int>(std::bit_width(static_cast<Key>(across / cell(level)) + 3))};
    const std::vector<Placed> own = place(here, level, keys);
    // Each two cells of a level once.
    std::array<Column, 4> beside{
        {{keys.shift(0, 1)}, {keys.shift(1, -1)}, {keys.shift(1, 0)}, {keys.shift(1, 1)}}};
    for (size_t i = 0; i < own.size(); ++i) {
      for (size_t j = i + 1; j < own.size() && own[j].key <= own[i].key + 1; ++j) test(own[i], own[j], out);
      for (Column& c : beside) c.test_with(own[i], own, out);
    }
    for (int finer = level + 1; finer <= finest; ++finer) {
      const auto& others = members[static_cast<size_t>(finer)];
      if (others.empty()) continue;
      std::vector<Column> around;
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) around.push_back({keys.shift(dx, dy)});
      for (const Placed& a : place(others, level, keys))
        for (Column& c : around) c.test_with(a, own, out);
    }
  }
  return out;
}

}  // namespace hawser
