#include "hawser/geometry/spatial_hash.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "hawser/geometry/closest_point.hpp"
#include "spatial_hash_search.hpp"

namespace hawser {

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

bool SpatialHash::begin(Ball& q, const Vec3& p, double max_distance) const {
  q.slot = kNone;
  if (corners_.empty() || !(max_distance >= 0)) return false;
  q.p = p;
  const Vec3 x = q.from_centre = p - centre_;
  if (!x.allFinite()) return false;
  for (int a = 0; a < 3; ++a) q.x[a] = static_cast<float>(x[a]);
  q.rounding = 3e-7 * (x.cwiseAbs().maxCoeff() + 0.5 * box_.extent().maxCoeff());
  q.rounding_double = 1e-15 * (p.cwiseAbs().maxCoeff() + centre_.cwiseAbs().maxCoeff());
  q.best = max_distance * max_distance;
  q.set_reach(max_distance);
  return true;
}

SpatialHash::Start SpatialHash::start(const Ball& q) const {
  Start s;
  const double radius = q.reach * (1 + 1e-9) + q.rounding;
  // The exponent of the ratio is the level; the finest in the table is no finer than the coarsest triangles.
  const double ratio = Start::kRoom * radius / side_;
  const int level = static_cast<int>(std::bit_cast<std::uint64_t>(ratio) >> 52) - 1022;
  s.level = std::max(level, least_);
  if ((s.root = s.level >= top_)) return s;
  const double side = side_ * (1 << s.level), margin = margin_[static_cast<std::size_t>(s.level)];
  const double last = static_cast<double>((1 << (top_ - s.level)) - 1), reach = (radius + margin) / side;
  for (unsigned a = 0; a < 3; ++a) {
    const double x = (q.p[a] - origin_[a]) / side;
    if (x + reach < 0 || x - reach > last + 1) s.none = true;
    // Centres on the far face of the box were put in the last cell.
    const double own = std::clamp(std::floor(x), 0.0, last);
    const double lower = std::floor(x - reach), upper = std::floor(x + reach);
    const double other = lower < own ? own - 1 : upper > own ? own + 1 : own;
    const bool second = other != own && other >= 0 && other <= last;
    s.ways |= (second ? 1u : 0u) << a;
    const double away = std::max(std::abs(x - std::max(own, other)) * side - margin, 0.0);
    s.squared[a] = away * away;
    s.code[0][a] = detail::spread(static_cast<std::uint64_t>(own));
    s.code[1][a] = detail::spread(static_cast<std::uint64_t>(second ? other : own));
  }
  return s;
}

SpatialHash::Nearest SpatialHash::answer(const Ball& q) const {
  if (q.slot == kNone) return {};
  return {corners_[q.slot].index(), q.best};
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

SpatialHash::Nearest SpatialHash::search(const Question& ask, Counters& count) const {
  Search q;
  if (!begin(q, ask.point, ask.max_distance)) return {};
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
      ++q.count.exact;
    }
  }
  const Start from = start(q);
  if (q.hinted) fetch_corners(q.candidates[0]);
  if (from.root) {
    q.push(0, 0, root_, kNone);
  } else if (!from.none) {
    for (unsigned which = 0; which < 8; ++which) {
      if (which & ~from.ways) continue;
      const float d = from.squared_distance(which);
      if (d > q.limit) continue;
      ++q.count.lookups;
      if (const Entry* entry = find(from.level, from.key(which))) q.push(0, d, *entry, kNone);
    }
  }
  while (q.depth > 0) {
    // Field by field: the processor is slow to read as a whole what was just written in parts.
    const Item& top = q.stack[--q.depth];
    const float away = top.squared;
    const Entry entry = top.entry();
    const std::uint32_t frame = top.frame;
    if (away > q.limit) continue;
    ++q.count.cells;
    if (const auto n = entry.count(); n > 0) {
      if (q.hinted) {
        settle(q);
        q.hinted = false;
        if (away > q.limit) continue;
      }
      if (q.waiting + n > Search::kMostCandidates) settle(q);
      q.count.triangles += n;
      q.waiting += bound(q, entry, frame, q.at_least + q.waiting, q.candidates + q.waiting);
    }
    if (entry.children == kNone) continue;
    float squared[8];
    const int base = q.depth;
    for (unsigned near = expand(q, entry.children, squared); near; near &= near - 1) {
      const int k = __builtin_ctz(near);
      const Entry& e = children_[entry.children].entry[k];
      fetch(e);
      q.push(base, squared[k], e, entry.children);
    }
  }
  settle(q);
  ++q.count.queries;
  count += q.count;
  return answer(q);
}

SpatialHash::Nearest SpatialHash::nearest(const Vec3& p, double max_distance, int hint,
                                          Counters* counters) const {
  Counters count;
  const Nearest found = search({p, max_distance, hint}, count);
  if (counters) *counters += count;
  return found;
}

std::size_t SpatialHash::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(corners_) + bytes(vertices_) + bytes(rounded_) + bytes(slot_) + bytes(children_) +
         bytes(hash_);
}

}  // namespace hawser
