#include "hawser/geometry/spatial_hash.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "hawser/geometry/closest_point.hpp"
#include "spatial_hash_search.hpp"

namespace hawser {

using detail::least;
using detail::Least;
using detail::Order;
using detail::prefetch;
using detail::scramble;

namespace {

// Squared distance to a triangle of sound shape (Ericson 2005, 5.1.5), corners seen from the point.
double squared_distance_to(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return a.squaredNorm();
  const double d3 = -ab.dot(b), d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return b.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (a + d1 / (d1 - d3) * ab).squaredNorm();
  const double d5 = -ab.dot(c), d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return c.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (a + d2 / (d2 - d6) * ac).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return (b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
  const double f = 1 / (va + vb + vc);
  return (a + vb * f * ab + vc * f * ac).squaredNorm();
}

}  // namespace

const SpatialHash::Entry* SpatialHash::find(int level, std::uint64_t key) const {
  const Table& t = tables_[static_cast<std::size_t>(level - start_)];
  std::size_t h = scramble(key) & t.mask;
  while (hash_[t.first + h].key != key) {
    if (hash_[t.first + h].key == kFree) return nullptr;
    h = (h + 1) & t.mask;
  }
  return &hash_[t.first + h].entry;
}

int SpatialHash::slot_of(int triangle) const {
  return triangle >= 0 && static_cast<std::size_t>(triangle) < slot_.size()
             ? slot_[static_cast<std::size_t>(triangle)]
             : -1;
}

void SpatialHash::test(Ball& q, std::uint32_t slot) const {
  const Corners& t = corners_[slot];
  const Vec3 &a = vertices_[t.v[0]], &b = vertices_[t.v[1]], &c = vertices_[t.v[2]];
  q.offer(slot, t.id < 0 ? closest_point_on_triangle(q.p, a, b, c).squared_distance
                         : squared_distance_to(a - q.p, b - q.p, c - q.p));
}

std::optional<SpatialHash::Nearest> SpatialHash::answer(const Ball& q) const {
  if (q.slot == kNone) return std::nullopt;
  return Nearest{corners_[q.slot].index(), q.best};
}

// Exact distances of the triangles that still could be the nearest, the most promising first.
void SpatialHash::settle(Search& q) const {
  if (q.waiting == 0) return;
  unsigned first = 0;
  for (unsigned i = 1; i < q.waiting; ++i)
    if (q.at_least[i] < q.at_least[first]) first = i;
  std::swap(q.at_least[0], q.at_least[first]);
  std::swap(q.candidates[0], q.candidates[first]);
  for (unsigned i = 0; i < q.waiting; ++i) {
    const std::uint32_t s = q.candidates[i];
    if (q.at_least[i] > q.reach || s == q.slot) continue;
    ++q.count.exact;
    test(q, s);
  }
  q.waiting = 0;
}

// A block and what is below it, the nearest box first.
void SpatialHash::descend(Search& q, std::uint32_t block) const {
  struct Left {
    Order order;
    std::uint32_t block;
  };
  constexpr std::uint16_t kDone = detail::kNoBox;
  constexpr Order kLane[8] = {{kDone},
                              {0, kDone},
                              {0, 0, kDone},
                              {0, 0, 0, kDone},
                              {0, 0, 0, 0, kDone},
                              {0, 0, 0, 0, 0, kDone},
                              {0, 0, 0, 0, 0, 0, kDone},
                              {0, 0, 0, 0, 0, 0, 0, kDone}};
  // On each level a cell and, if it holds more than eight runs, blocks of blocks of them.
  Left stack[10 * (detail::kMaxLevels + 1)];
  int depth = 0;
  Order order = q.order(children_[block]);
  Least next = least(order);
  for (;;) {
    if (next.value > std::bit_cast<std::uint32_t>(q.limit) >> 16) {
      if (depth == 0) return;
      --depth;
      order = stack[depth].order;
      block = stack[depth].block;
      next = least(order);
      continue;
    }
    const Entry entry = children_[block].entry[next.lane];
    order |= kLane[next.lane];
    next = least(order);
    fetch(children_[block].entry[next.lane]);
    ++q.count.cells;
    if (const auto n = entry.count(); n > 0) {
      if (q.hinted) {
        settle(q);
        q.hinted = false;
      }
      if (q.waiting + n > Search::kMostCandidates) settle(q);
      q.count.triangles += n;
      q.waiting += bound(q, entry, block, q.at_least + q.waiting, q.candidates + q.waiting);
    }
    if (entry.children == kNone) continue;
    stack[depth] = {order, block};
    depth += next.value != kDone;
    block = entry.children;
    order = q.order(children_[block]);
    next = least(order);
  }
}

std::optional<SpatialHash::Nearest> SpatialHash::search(const Question& ask, Counters& count) const {
  Search q(count);
  if (!begin(q, ask.point, ask.max_distance)) return std::nullopt;
  ++count.queries;
  if (const int hint = slot_of(ask.hint); hint >= 0) {
    const auto s = static_cast<std::uint32_t>(hint);
    if (ask.max_distance < Start::kRoom * side_ * (1 << start_)) {
      // Its distance would spare little of so short a search, and waiting for it costs more: it is fetched,
      // with what is kept of its neighbours, while the search goes down to them.
      prefetch(&corners_[s]);
      const std::size_t from = 3 * std::size_t{s};
      prefetch(&rounded_[from > 24 ? from - 24 : 0], 192);
      q.at_least[0] = 0;
      q.candidates[0] = s;
      q.waiting = 1;
      q.hinted = true;
    } else {
      test(q, s);
      ++count.exact;
    }
  }
  const Start from = start(q);
  if (q.hinted) fetch_corners(q.candidates[0]);
  if (from.root) {
    descend(q, root_.children);
  } else if (!from.none) {
    detail::BoxLanes d;
    unsigned cells = from.within(q.limit, d);
    float squared[8];
    std::memcpy(squared, &d, sizeof d);
    for (; cells; cells &= cells - 1) {
      const auto which = static_cast<unsigned>(__builtin_ctz(cells));
      if (squared[which] > q.limit) continue;
      ++count.lookups;
      if (const Entry* entry = find(from.level, from.key(which))) descend(q, entry->children);
    }
  }
  settle(q);
  return answer(q);
}

std::optional<SpatialHash::Nearest> SpatialHash::nearest(const Vec3& p, double max_distance, int hint,
                                                         Counters* counters) const {
  Counters unused;
  return search({p, max_distance, hint}, counters ? *counters : unused);
}

}  // namespace hawser
