// Many searches of the spatial hash at a time.
//
// A search waits for memory at every step down, and what it does next is hard to foresee. So a group of
// searches goes down together, breadth first: all cells of all of them, then all runs, then all triangles.
// Each is fetched some places before its turn (group prefetching: Chen, Ailamaki, Gibbons & Mowry 2007,
// "Improving hash join performance through prefetching", ACM TODS 32(3)), and what is found is put on lists
// without branches. That is little more work than the nearest first where a hint tells the distance closely
// from the start; the others go one by one.
#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <tuple>

#include "spatial_hash_lanes.hpp"
#include "spatial_hash_search.hpp"

namespace hawser {

using detail::BoxLanes;
using detail::BoxWords;
using detail::prefetch;
using detail::scramble;

struct SpatialHash::Group {
  static constexpr std::size_t kMost = 32;
  // How many places ahead in a list it is fetched.
  static constexpr std::size_t kAhead = 8;
  static constexpr std::size_t kLanes = 16;  // written at a time at most, wanted or not

  // Lists of which each member is a place, filled by detail::keep().
  template <class... T>
  struct List {
    std::tuple<std::vector<T>...> of;
    std::size_t size = 0;
    void room() {
      if (std::get<0>(of).size() < size + kLanes)
        std::apply([&](auto&... v) { (v.resize(2 * size + 1024), ...); }, of);
    }
    template <std::size_t k>
    auto* end() {
      return std::get<k>(of).data() + size;
    }
    template <std::size_t k>
    const auto& at(std::size_t i) const {
      return std::get<k>(of)[i];
    }
  };
  const SpatialHash& hash;
  std::span<const Question> questions;
  std::span<const std::uint32_t> order;  // in which they are answered; empty: as they come
  std::span<const std::int32_t> slots;   // of the hints
  std::array<Ball, kMost> balls;
  std::array<bool, kMost> alone;
  // The search a member belongs to is the last of each.
  List<std::uint64_t, std::uint32_t, std::uint32_t> lookups;      // key, table
  List<std::uint64_t, std::uint32_t> blocks;                      // index
  List<std::uint64_t, float, std::uint32_t, std::uint32_t> runs;  // entry, m² to its box, block it is in
  List<float, std::uint32_t, std::uint32_t> finals;               // m at least, triangle
  Counters count;

  std::size_t place(std::size_t i) const { return order.empty() ? i : order[i]; }
  // The question and its hint's place; then what the search will surely look at, step by step.
  void fetch_question(std::size_t i) const {
    asm volatile("");
    if (i >= questions.size()) return;
    prefetch(&questions[place(i)], sizeof(Question));
    prefetch(&slots[place(i)]);
  }
  void fetch_triangle(std::size_t i) const {
    asm volatile("");
    if (i >= questions.size()) return;
    if (const int s = slots[place(i)]; s >= 0) prefetch(&hash.corners_[static_cast<std::size_t>(s)]);
  }
  void fetch_hint(std::size_t i) const {
    asm volatile("");
    if (i >= questions.size()) return;
    const int s = slots[place(i)];
    if (s < 0) return;
    hash.fetch_corners(static_cast<std::uint32_t>(s));
    const std::size_t at = 3 * static_cast<std::size_t>(s);
    prefetch(&hash.rounded_[at > 24 ? at - 24 : 0], 192);
  }
  Entry run(std::size_t k) const {
    const std::uint64_t e = runs.at<0>(k);
    return {static_cast<std::uint32_t>(e), static_cast<std::uint32_t>(e >> 32)};
  }
  void fetch_run(std::size_t k) const {
    asm volatile("");
    if (k < runs.size) prefetch(&hash.rounded_[3 * std::size_t{run(k).first()}], 192);
  }

  void begin(std::size_t from, std::uint32_t n);
  void look_up(const Ball& ball, const Start& start, std::uint32_t which);
  void go_down();
  void settle(std::size_t next);
};

// The distances of the hints, and the cells to begin with.
void SpatialHash::Group::begin(std::size_t from, std::uint32_t n) {
  const double short_reach = 0.5 * hash.side_ * (1 << hash.start_);
  lookups.size = 0;
  std::array<int, kMost> hints;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::size_t at = place(from + i);
    const Question& ask = questions[at];
    fetch_question(from + i + 3 * kMost);
    fetch_triangle(from + i + 2 * kMost);
    hints[i] = slots[at];
    alone[i] = !hash.begin(balls[i], ask.point, ask.max_distance) || hints[i] < 0;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (alone[i]) continue;
    Ball& q = balls[i];
    ++count.exact;
    hash.test(q, static_cast<std::uint32_t>(hints[i]));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (alone[i]) continue;
    const Ball& q = balls[i];
    const Start s = hash.start(q);
    alone[i] = s.root || q.reach > short_reach;
    if (alone[i]) continue;
    ++count.queries;
    if (!s.none) look_up(q, s, i);
  }
  count.lookups += static_cast<long>(lookups.size);
}

// All eight cells are written, those there are and within reach are kept.
void SpatialHash::Group::look_up(const Ball& q, const Start& s, std::uint32_t which) {
  constexpr BoxWords kIs[3] = {{0, ~0ul, 0, ~0ul, 0, ~0ul, 0, ~0ul},
                               {0, 0, ~0ul, ~0ul, 0, 0, ~0ul, ~0ul},
                               {0, 0, 0, 0, ~0ul, ~0ul, ~0ul, ~0ul}};
  BoxLanes squared;
  const unsigned cells = s.within(q.limit, squared);
  BoxWords key = BoxWords{} + s.own;
  for (int a = 0; a < 3; ++a) key ^= s.change[a] & kIs[a];
  lookups.room();
  detail::keep(cells, key, lookups.end<0>());
  const auto level = static_cast<std::uint32_t>(s.level - hash.start_);
  detail::fill8(level, lookups.end<1>());
  detail::fill8(which, lookups.end<2>());
  const Table& t = hash.tables_[level];
  const std::size_t before = lookups.size;
  lookups.size += detail::count_bits(cells);
  for (std::size_t i = before; i < lookups.size; ++i)
    prefetch(&hash.hash_[t.first + (scramble(lookups.at<0>(i)) & t.mask)]);
}

void SpatialHash::Group::go_down() {
  blocks.size = runs.size = 0;
  for (std::size_t i = 0; i < lookups.size; ++i) {
    const std::uint64_t key = lookups.at<0>(i);
    const Table& t = hash.tables_[lookups.at<1>(i)];
    std::size_t h = scramble(key) & t.mask;
    while (hash.hash_[t.first + h].key != key && hash.hash_[t.first + h].key != kFree) h = (h + 1) & t.mask;
    const Slot& s = hash.hash_[t.first + h];
    blocks.room();
    *blocks.end<0>() = s.entry.children;  // what is in the table has a block
    *blocks.end<1>() = lookups.at<2>(i);
    const bool found = s.key == key;
    prefetch(&hash.children_[found ? s.entry.children : 0], sizeof(Children));
    blocks.size += found;
  }
  // What is found on the way comes behind.
  for (std::size_t k = 0; k < blocks.size; ++k) {
    if (k + kAhead < blocks.size) prefetch(&hash.children_[blocks.at<0>(k + kAhead)], sizeof(Children));
    blocks.room();
    runs.room();
    const auto block = static_cast<std::uint32_t>(blocks.at<0>(k));
    const std::uint32_t which = blocks.at<1>(k);
    BoxLanes squared;
    const unsigned near = hash.expand(balls[which], block, reinterpret_cast<float*>(&squared));
    BoxWords entries;
    static_assert(sizeof entries == sizeof(Children::entry));
    std::memcpy(&entries, hash.children_[block].entry, sizeof entries);
    const BoxWords below = entries >> 32;
    const unsigned cells = near & detail::not_zero(below ^ kNone);
    const unsigned own = near & detail::not_zero(entries & Entry::kMost);
    detail::keep(own, entries, runs.end<0>());
    detail::keep(own, squared, runs.end<1>());
    detail::fill8(block, runs.end<2>());
    detail::fill8(which, runs.end<3>());
    runs.size += detail::count_bits(own);
    detail::keep(cells, below, blocks.end<0>());
    detail::fill8(which, blocks.end<1>());
    blocks.size += detail::count_bits(cells);
  }
  count.cells += static_cast<long>(blocks.size);
}

// What the group from `next` on will read of its hints is fetched on the way: this takes longest.
void SpatialHash::Group::settle(std::size_t next) {
  finals.size = 0;
  for (std::size_t k = 0; k < kAhead; ++k) fetch_run(k);
  for (std::size_t k = 0; k < runs.size; ++k) {
    fetch_run(k + kAhead);
    if (k < kMost) fetch_hint(next + k);
    const std::uint32_t which = runs.at<3>(k);
    Ball& q = balls[which];
    if (runs.at<1>(k) > q.limit) continue;
    ++count.cells;
    count.triangles += run(k).count();
    finals.room();
    const unsigned found = hash.bound(q, run(k), runs.at<2>(k), finals.end<0>(), finals.end<1>());
    for (unsigned i = 0; i < found; ++i) finals.end<2>()[i] = which;
    finals.size += found;
  }
  for (std::size_t k = runs.size; k < kMost; ++k) fetch_hint(next + k);
  for (std::size_t k = 0; k < finals.size; ++k) hash.fetch_corners(finals.at<1>(k));
  for (std::size_t k = 0; k < finals.size; ++k) {
    Ball& q = balls[finals.at<2>(k)];
    const std::uint32_t slot = finals.at<1>(k);
    if (finals.at<0>(k) > q.reach || slot == q.slot) continue;
    ++count.exact;
    hash.test(q, slot);
  }
}

void SpatialHash::nearest(std::span<const Question> questions, std::span<std::optional<Nearest>> answers,
                          Counters* counters) const {
  const std::size_t n = questions.size();
  if (answers.size() != n)
    throw std::invalid_argument("a spatial hash was asked " + std::to_string(n) +
                                " questions with room for " + std::to_string(answers.size()) + " answers");
  if (n == 0) return;
  constexpr std::size_t kFetch = 16;
  std::vector<std::int32_t> slots(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i + kFetch < n) {
      const int h = questions[i + kFetch].hint;
      if (h >= 0 && static_cast<std::size_t>(h) < slot_.size()) prefetch(&slot_[static_cast<std::size_t>(h)]);
    }
    slots[i] = slot_of(questions[i].hint);
  }
  const std::vector<std::uint32_t> order = order_of(slots);
  Group g{*this, questions, order, slots, {}, {}, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < 3 * Group::kMost; ++i) g.fetch_question(i);
  for (std::size_t i = 0; i < 2 * Group::kMost; ++i) g.fetch_triangle(i);
  for (std::size_t i = 0; i < Group::kMost; ++i) g.fetch_hint(i);
  for (std::size_t from = 0; from < n; from += Group::kMost) {
    const auto m = static_cast<std::uint32_t>(std::min(Group::kMost, n - from));
    for (std::uint32_t i = 0; i < m; ++i) __builtin_prefetch(&answers[g.place(from + i)], 1);  // to write
    g.begin(from, m);
    g.go_down();
    g.settle(from + Group::kMost);
    for (std::uint32_t i = 0; i < m; ++i) {
      const std::size_t at = g.place(from + i);
      answers[at] = g.alone[i] ? search(questions[at], g.count) : answer(g.balls[i]);
    }
  }
  if (counters) *counters += g.count;
}

// Of many questions to a mesh that no cache holds: along the curve its triangles are sorted by, so that what
// one search reads is there for the next ones. Those without a hint first.
std::vector<std::uint32_t> SpatialHash::order_of(std::span<const std::int32_t> slots) const {
  constexpr std::size_t kMany = 4096, kLarge = 20000, kMostHeaps = 65536;
  std::vector<std::uint32_t> order;
  if (slots.size() < kMany || corners_.size() < kLarge) return order;
  const std::size_t heaps = std::min(slots.size(), kMostHeaps);
  int shift = 0;
  while (corners_.size() >> shift >= heaps) ++shift;
  const auto heap = [&](std::int32_t s) { return s < 0 ? 0 : 1 + (static_cast<std::size_t>(s) >> shift); };
  std::vector<std::uint32_t> first(heaps + 2, 0u);
  for (const std::int32_t s : slots) ++first[heap(s) + 1];
  for (std::size_t b = 1; b < first.size(); ++b) first[b] += first[b - 1];
  order.resize(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i)
    order[first[heap(slots[i])]++] = static_cast<std::uint32_t>(i);
  return order;
}

}  // namespace hawser
