// Many searches of the spatial hash at a time.
//
// A search waits for memory at every step down, and what it does next is hard to foresee. So a group of
// searches goes down together, breadth first: all cells of all of them, then all runs, then all triangles.
// Each is fetched when it is found and looked at when its turn comes (group prefetching: Chen, Ailamaki,
// Gibbons & Mowry 2007, "Improving hash join performance through prefetching", ACM TODS 32(3)). That is
// little more work than the nearest first where a hint tells the distance closely from the start; the
// others go one by one.
#include <array>
#include <cmath>
#include <stdexcept>

#include "spatial_hash_search.hpp"

namespace hawser {

using detail::prefetch;
using detail::scramble;

struct SpatialHash::Group {
  static constexpr std::size_t kMost = 32;
  struct Lookup {
    float squared;
    std::uint32_t which;  // the search it belongs to
    int level;
    std::uint64_t key;
  };
  struct Place {
    Item item;
    std::uint32_t which;
  };
  struct Final {
    Candidate candidate;
    std::uint32_t which;
  };

  const SpatialHash& hash;
  std::span<const Question> questions;
  std::array<Ball, kMost> balls;
  std::array<bool, kMost> alone;
  std::vector<Lookup> lookups;
  std::vector<Place> blocks, runs;
  std::vector<Final> finals;
  Counters count;

  void fetch_slot(std::size_t i) const {
    asm volatile("");
    if (i >= questions.size()) return;
    const int h = questions[i].hint;
    if (h >= 0 && static_cast<std::size_t>(h) < hash.slot_.size())
      prefetch(&hash.slot_[static_cast<std::size_t>(h)]);
  }
  void fetch_corners(std::size_t i) const {
    asm volatile("");
    if (i >= questions.size()) return;
    if (const int s = hash.slot_of(questions[i].hint); s >= 0)
      prefetch(&hash.corners_[static_cast<std::size_t>(s)], sizeof(Corners));
  }
  void add(float squared, const Entry& e, std::uint32_t frame, std::uint32_t which) {
    hash.fetch(e);
    if (e.children != kNone) blocks.push_back({{squared, e.own, e.children, frame}, which});
    if (e.count() > 0) runs.push_back({{squared, e.own, e.children, frame}, which});
  }

  void begin(std::size_t from, std::uint32_t n);
  void go_down();
  void settle();
};

// The distances of the hints, and the cells to begin with. Hints' places are fetched two groups ahead, their
// corners one.
void SpatialHash::Group::begin(std::size_t from, std::uint32_t n) {
  const double short_reach = 0.5 * hash.side_ * (1 << hash.start_);
  lookups.clear();
  std::array<int, kMost> hints;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Question& ask = questions[from + i];
    fetch_slot(from + i + 2 * kMost);
    hints[i] = hash.slot_of(ask.hint);
    alone[i] = !hash.begin(balls[i], ask.point, ask.max_distance) || hints[i] < 0;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    fetch_corners(from + i + kMost);
    if (alone[i]) continue;
    Ball& q = balls[i];
    ++count.exact;
    hash.test(q, static_cast<std::uint32_t>(hints[i]));
    const Start s = hash.start(q);
    alone[i] = s.root || q.reach > short_reach;
    if (alone[i]) continue;
    ++count.queries;
    if (s.none) continue;
    const Table& t = hash.tables_[static_cast<std::size_t>(s.level - hash.start_)];
    for (unsigned cell = 0; cell < 8; ++cell) {
      if (cell & ~s.ways) continue;
      const float d = s.squared_distance(cell);
      if (d > q.limit) continue;
      const std::uint64_t key = s.key(cell);
      prefetch(&hash.hash_[t.first + (scramble(key) & t.mask)]);
      lookups.push_back({d, i, s.level, key});
    }
  }
  count.lookups += static_cast<long>(lookups.size());
}

void SpatialHash::Group::go_down() {
  blocks.clear();
  runs.clear();
  for (const Lookup& l : lookups)
    if (const Entry* e = hash.find(l.level, l.key)) add(l.squared, *e, kNone, l.which);
  // What is found on the way comes behind.
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const std::uint32_t block = blocks[k].item.children, which = blocks[k].which;
    ++count.cells;
    float squared[8];
    for (unsigned near = hash.expand(balls[which], block, squared); near; near &= near - 1) {
      const int j = __builtin_ctz(near);
      add(squared[j], hash.children_[block].entry[j], block, which);
    }
  }
}

void SpatialHash::Group::settle() {
  finals.clear();
  for (const Place& at : runs) {
    Ball& q = balls[at.which];
    if (at.item.squared > q.limit) continue;
    ++count.cells;
    count.triangles += at.item.entry().count();
    Candidate c[Entry::kMost];
    const int found = hash.bound(q, at.item.entry(), at.item.frame, c);
    for (int j = 0; j < found; ++j) finals.push_back({c[j], at.which});
  }
  for (const Final& f : finals) {
    Ball& q = balls[f.which];
    if (f.candidate.at_least > q.reach || f.candidate.slot == q.slot) continue;
    ++count.exact;
    hash.test(q, f.candidate.slot);
  }
}

void SpatialHash::nearest(std::span<const Question> questions, std::span<Nearest> answers,
                          Counters* counters) const {
  if (answers.size() != questions.size())
    throw std::invalid_argument("a spatial hash was asked " + std::to_string(questions.size()) +
                                " questions with room for " + std::to_string(answers.size()) + " answers");
  Group g{*this, questions, {}, {}, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < 2 * Group::kMost; ++i) g.fetch_slot(i);
  for (std::size_t i = 0; i < Group::kMost; ++i) g.fetch_corners(i);
  for (std::size_t from = 0; from < questions.size(); from += Group::kMost) {
    const auto n = static_cast<std::uint32_t>(std::min(Group::kMost, questions.size() - from));
    g.begin(from, n);
    g.go_down();
    g.settle();
    for (std::uint32_t i = 0; i < n; ++i)
      answers[from + i] = g.alone[i] ? search(questions[from + i], g.count) : answer(g.balls[i]);
  }
  if (counters) *counters += g.count;
}

}  // namespace hawser
