// Cells are sorted by their coordinates, and neighbours are found by walking along the sorted lists together:
// memory is read in order, and nothing but the last of a row asks for a branch, so that a box costs hardly
// more among many than among few.
#include "hawser/geometry/box_pairs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "box_pairs_lanes.hpp"

namespace hawser {
namespace {

constexpr int kLevels = 24, kBits = 20;           // most of a coordinate
constexpr std::int64_t kLast = (1 << kBits) - 4;  // cells of the finest level across everything
constexpr std::size_t kLanes = detail::kPairLanes;

bool usable(const Box& b) { return b.lo.allFinite() && b.hi.allFinite() && !b.empty(); }

// Memory only ever grows: what was written before may stay.
template <class V>
void at_least(V& v, std::size_t size) {
  if (v.size() < size) v.resize(size);
}

}  // namespace

// Cells of one level: their coordinates as one number, sorted by x, then y, then z.
struct BoxPairs::Grid {
  Box all;
  std::array<double, kLevels> cell{};  // m, of a level: the coarsest / 2^level
  int finest = 0;
  double scale = 1;           // 1/m, of the level in hand
  std::array<int, 3> bits{};  // of a coordinate, so that sorting takes no more rounds than needed

  void take(int level) {
    scale = 1 / cell[static_cast<std::size_t>(level)];
    for (std::size_t k = 0; k < 3; ++k)
      bits[k] = static_cast<int>(
          std::bit_width(static_cast<Key>(scale * all.extent()[static_cast<Eigen::Index>(k)]) + 3));
  }
  Key key(const Box& b) const {
    const Vec3 p = scale * (b.centre() - all.lo);
    const auto c = [&](Eigen::Index k) {
      // One more: neighbours of the first cell have keys too.
      return static_cast<Key>(std::clamp(static_cast<std::int64_t>(p[k]), std::int64_t{0}, kLast) + 1);
    };
    return (c(0) << bits[1] | c(1)) << bits[2] | c(2);
  }
  Key shift(int dx, int dy) const {
    return static_cast<Key>(((static_cast<std::int64_t>(dx) << bits[1]) + static_cast<std::int64_t>(dy)) *
                            (1 << bits[2]));
  }
  int key_bits() const { return bits[0] + bits[1] + bits[2]; }
};

// A column of cells beside that of a box, from one below to one above, as the boxes are gone through in
// order.
struct Column {
  std::uint64_t shift;
  std::size_t first = 0;
};

// Boxes of one list tested against those of another, or of the same.
struct BoxPairs::Walk {
  Walk(const Placed& boxes, LargeVector<std::uint64_t>& pairs, std::size_t found)
      : key(boxes.key.data()), number(boxes.number.data()), out(pairs), to(pairs.data() + found) {
    for (std::size_t f = 0; f < 6; ++f) face[f] = boxes.face[f].data();
  }
  [[gnu::always_inline]] void column(const detail::BoxProbe& p, Column& c, Key of) {
    const Key low = of + c.shift - 1, high = of + c.shift + 1;
    detail::KeyRange in = detail::key_range(key + c.first, low, high);
    while (in.below == kLanes) in = detail::key_range(key + (c.first += kLanes), low, high);
    c.first += in.below;
    if (in.below + in.within < kLanes)
      test(p, c.first, in.within);
    else
      rest(p, c.first, high);
  }
  [[gnu::always_inline]] void row(const detail::BoxProbe& p, std::size_t from, Key high) {
    const detail::KeyRange in = detail::key_range(key + from, 0, high);
    if (in.within < kLanes)
      test(p, from, in.within);
    else
      rest(p, from, high);
  }
  std::size_t found() const { return static_cast<std::size_t>(to - out.data()); }

 private:
  [[gnu::always_inline]] void test(const detail::BoxProbe& p, std::size_t from, std::size_t count) {
    to += p.test(face, number, from, count, to);
  }
  // Of a cell with many.
  [[gnu::noinline]] void rest(const detail::BoxProbe& p, std::size_t from, Key high) {
    for (;; from += kLanes) {
      make_room();
      const std::size_t n = detail::key_range(key + from, 0, high).within;
      test(p, from, n);
      if (n < kLanes) return;
    }
  }

 public:
  // For as many pairs as a box has in its columns and row, where there are few in each.
  void make_room() {
    const std::size_t n = found();
    if (n + 10 * kLanes <= out.size()) return;
    out.resize(2 * out.size() + 64 * kLanes);
    to = out.data() + n;
  }

 private:
  const Key* key;
  const std::uint32_t* number;
  std::array<const float*, 6> face;
  LargeVector<std::uint64_t>& out;
  std::uint64_t* to;
};

// Levels, and the boxes of each: at the finest level whose cells are not smaller than the box.
bool BoxPairs::survey(std::span<const Box> boxes, Grid& grid) {
  sizes_.resize(boxes.size());
  double largest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    sizes_[i] = -1;
    if (!usable(b)) continue;
    grid.all.add(b);
    sizes_[i] = b.extent().maxCoeff();
    largest = std::max(largest, sizes_[i]);
  }
  if (grid.all.empty()) return false;
  const double across = std::max(grid.all.extent().maxCoeff(), 1e-300);
  grid.cell[0] = std::max(largest, across / static_cast<double>(kLast));
  for (std::size_t l = 1; l < grid.cell.size(); ++l) grid.cell[l] = 0.5 * grid.cell[l - 1];
  const auto cell = [&](int level) { return grid.cell[static_cast<std::size_t>(level)]; };
  while (grid.finest + 1 < kLevels && across / cell(grid.finest + 1) < static_cast<double>(kLast))
    ++grid.finest;
  members_.resize(kLevels);
  for (auto& m : members_) m.clear();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (sizes_[i] < 0) continue;
    int level = 0;
    while (level < grid.finest && cell(level + 1) >= sizes_[i]) ++level;
    members_[static_cast<std::size_t>(level)].push_back(static_cast<int>(i));
  }
  return true;
}

// By key, stable: least significant digits first.
void BoxPairs::sort(int bits) {
  constexpr int kDigit = 11;
  const int rounds = (bits + kDigit - 1) / kDigit, width = (bits + rounds - 1) / rounds;
  scratch_.resize(entries_.size());
  std::array<std::uint32_t, (1 << kDigit) + 1> start;
  for (int shift = 0; shift < bits; shift += width) {
    const auto digit = [&](const Entry& e) { return e.key >> shift & ((Key{1} << width) - 1); };
    std::fill_n(start.begin(), (std::size_t{1} << width) + 1, 0u);
    for (const Entry& e : entries_) ++start[digit(e) + 1];
    for (std::size_t d = 0; d < std::size_t{1} << width; ++d) start[d + 1] += start[d];
    for (const Entry& e : entries_) scratch_[start[digit(e)]++] = e;
    entries_.swap(scratch_);
  }
}

void BoxPairs::place(std::span<const Box> boxes, const std::vector<int>& numbers, const Grid& grid,
                     Placed& to) {
  entries_.clear();
  for (int i : numbers) entries_.push_back({grid.key(boxes[static_cast<std::size_t>(i)]), i});
  sort(grid.key_bits());
  to.size = entries_.size();
  const std::size_t room = to.size + 2 * kLanes;
  at_least(to.key, room), at_least(to.number, room);
  for (auto& f : to.face) at_least(f, room);
  for (std::size_t i = 0; i < to.size; ++i) {
    const Box& b = boxes[static_cast<std::size_t>(entries_[i].number)];
    to.key[i] = entries_[i].key, to.number[i] = static_cast<std::uint32_t>(entries_[i].number);
    // Rounding keeps the order of numbers: what overlaps overlaps rounded too.
    const Eigen::Vector3f lo = (b.lo - grid.all.lo).cast<float>(), hi = (b.hi - grid.all.lo).cast<float>();
    for (std::size_t k = 0; k < 3; ++k) {
      to.face[k][i] = lo[static_cast<Eigen::Index>(k)];
      to.face[k + 3][i] = hi[static_cast<Eigen::Index>(k)];
    }
  }
  std::fill_n(to.key.begin() + static_cast<std::ptrdiff_t>(to.size), 2 * kLanes, ~Key{0});
}

std::span<const std::uint64_t> BoxPairs::find(std::span<const Box> boxes) {
  Grid grid;
  if (!survey(boxes, grid)) return {};
  std::size_t found = 0;
  const auto probe = [](const Placed& p, std::size_t i) {
    return detail::BoxProbe({p.face[0][i], p.face[1][i], p.face[2][i]},
                            {p.face[3][i], p.face[4][i], p.face[5][i]}, p.number[i]);
  };
  for (int level = 0; level <= grid.finest; ++level) {
    const auto& here = members_[static_cast<std::size_t>(level)];
    if (here.empty()) continue;
    grid.take(level);
    place(boxes, here, grid, own_);
    // Each two cells of a level once.
    std::array<Column, 4> beside{
        {{grid.shift(0, 1)}, {grid.shift(1, -1)}, {grid.shift(1, 0)}, {grid.shift(1, 1)}}};
    Walk walk(own_, pairs_, found);
    for (std::size_t i = 0; i < own_.size; ++i) {
      const auto p = probe(own_, i);
      const Key key = own_.key[i];
      walk.make_room();
      walk.row(p, i + 1, key + 1);
      for (Column& c : beside) walk.column(p, c, key);
    }
    found = walk.found();
    // Boxes of a finer level are looked for from the cells of the coarser that hold their centres.
    for (int finer = level + 1; finer <= grid.finest; ++finer) {
      const auto& others = members_[static_cast<std::size_t>(finer)];
      if (others.empty()) continue;
      place(boxes, others, grid, finer_);
      std::array<Column, 9> around;
      for (int c = 0; c < 9; ++c) around[static_cast<std::size_t>(c)] = {grid.shift(c / 3 - 1, c % 3 - 1)};
      Walk across(own_, pairs_, found);
      for (std::size_t i = 0; i < finer_.size; ++i) {
        const auto p = probe(finer_, i);
        across.make_room();
        for (Column& c : around) across.column(p, c, finer_.key[i]);
      }
      found = across.found();
    }
  }
  return {pairs_.data(), found};
}

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Box> boxes) {
  BoxPairs search;
  std::vector<std::pair<int, int>> out;
  for (const std::uint64_t p : search.find(boxes)) {
    const int i = static_cast<int>(p >> 32), j = static_cast<int>(p & 0xffffffffu);
    if (boxes[static_cast<std::size_t>(i)].overlaps(boxes[static_cast<std::size_t>(j)]))
      out.emplace_back(i, j);
  }
  return out;
}

}  // namespace hawser
