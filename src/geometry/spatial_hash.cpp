#include "hawser/geometry/spatial_hash.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "hawser/geometry/closest_point.hpp"
#include "spatial_hash_keys.hpp"

namespace hawser {
namespace {

// Side of the cells a search starts from over its radius, at least.
constexpr double kRoom = 8;

using detail::kMaxLevels;
using detail::morton;
using detail::scramble;

void prefetch(const void* at, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(static_cast<const char*>(at) + i);
}

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

double SpatialHash::test(std::uint32_t slot, const Vec3& p) const {
  const double* v = corners_[slot].v;
  const Vec3 a(v[0], v[1], v[2]), b(v[3], v[4], v[5]), c(v[6], v[7], v[8]);
  if (corners_[slot].id < 0) return closest_point_on_triangle(p, a, b, c).squared_distance;
  return squared_distance_to(a - p, b - p, c - p);
}

namespace {

// Eight lanes of single precision.
constexpr int kLanes = 8;
using Lanes [[gnu::vector_size(4 * kLanes)]] = float;
using LaneInts [[gnu::vector_size(4 * kLanes)]] = std::int32_t;
using LaneShorts [[gnu::vector_size(2 * kLanes)]] = std::uint16_t;

using LaneBytes [[gnu::vector_size(kLanes)]] = std::uint8_t;

struct Lanes3 {
  Lanes x, y, z;
  Lanes3 operator-(const Lanes3& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Lanes dot(const Lanes3& o) const { return x * o.x + y * o.y + z * o.z; }
  Lanes3 cross(const Lanes3& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
};

Lanes load(const std::uint16_t* at) {
  LaneShorts s;
  std::memcpy(&s, at, sizeof s);
  return __builtin_convertvector(__builtin_convertvector(s, LaneInts), Lanes);
}

Lanes load(const std::uint8_t* at) {
  LaneBytes s;
  std::memcpy(&s, at, sizeof s);
  return __builtin_convertvector(__builtin_convertvector(s, LaneInts), Lanes);
}

Lanes lesser(Lanes a, Lanes b) { return a < b ? a : b; }
Lanes greater(Lanes a, Lanes b) { return a > b ? a : b; }

Lanes root(Lanes a) {
  for (int i = 0; i < kLanes; ++i) a[i] = std::sqrt(a[i]);
  return a;
}

// Squared distance from 0 to the segments from a along e, of squared length e2.
Lanes squared_distance_to_segment(const Lanes3& a, const Lanes3& e, Lanes e2) {
  const Lanes zero = {}, one = zero + 1;
  const Lanes t = lesser(greater(-a.dot(e) / greater(e2, zero + FLT_MIN), zero), one);
  const Lanes3 r = {a.x + t * e.x, a.y + t * e.y, a.z + t * e.z};
  return r.dot(r);
}

// A triangle whose height over its longest side is less than this much of it is taken for its edges.
constexpr float kFlat = 0.1f;

// Errors of bounds in single precision over the size of what is computed with. The normal of a triangle
// that is not flat is right to 3 u / kFlat (u = 6e-8), its inside to that over the sine of half its sharpest
// angle, kFlat / 2: 4e-5.
constexpr float kBoundError = 1e-4f;

}  // namespace

struct SpatialHash::Search {
  Vec3 p, from_centre;
  float x[3];              // p from centre_
  double rounding;         // m, of x and of what is computed with it in float
  double rounding_double;  // m, of p from centre_ in double
  double best;             // m², of slot, at first the square of the distance asked for
  std::uint32_t slot = kNone;
  double reach = std::numeric_limits<double>::infinity();  // m, the nearest is not farther than this
  float limit = 0;  // m², what is farther than this in float is farther than reach
  struct Item {
    float squared;
    std::uint32_t own, children;  // of its entry
    std::uint32_t frame;          // the block it is in
  };
  Item stack[8 * (kMaxLevels + 12) + 32];
  int depth = 0;
  struct Candidate {
    float at_least;  // m
    std::uint32_t slot;
  };
  static constexpr int kMostCandidates = 32;
  Candidate candidates[kMostCandidates];
  int waiting = 0;
  bool hinted = false;  // the only candidate is the hint, being fetched
  Counters count;

  void bring_in(double r) {
    if (!(r < reach) && limit > 0) return;
    reach = r;
    const double far = r * (1 + 1e-6) + rounding;
    limit = static_cast<float>(std::min(far * far, static_cast<double>(FLT_MAX) / 2));
  }
  void offer(std::uint32_t s, double squared) {
    if (squared > best || (squared == best && s >= slot)) return;
    best = squared;
    slot = s;
  }
  // Onto the stack above `base`, farthest first.
  void push(int base, float squared, const Entry& entry, std::uint32_t frame) {
    int i = depth++;
    while (i > base && stack[i - 1].squared < squared) {
      stack[i] = stack[i - 1];
      --i;
    }
    stack[i] = {squared, entry.own, entry.children, frame};
  }
};

// Exact distances of the triangles that still could be the nearest, the most promising first.
void SpatialHash::settle(Search& q) const {
  int first = 0;
  for (int i = 1; i < q.waiting; ++i)
    if (q.candidates[i].at_least < q.candidates[first].at_least) first = i;
  if (q.waiting > 0) std::swap(q.candidates[0], q.candidates[first]);
  for (int i = 0; i < q.waiting; ++i) {
    if (q.candidates[i].at_least > q.reach) continue;
    const std::uint32_t s = q.candidates[i].slot;
    ++q.count.exact;
    q.offer(s, test(s, q.p));
    if (q.slot == s) q.bring_in(std::sqrt(q.best) * (1 + 1e-12));
  }
  q.waiting = 0;
}

// Bounds of the distances of a run, from corners rounded to a grid.
void SpatialHash::bound(Search& q, const Children& frame, const Entry& run) const {
  const std::size_t n = run.count();
  q.count.triangles += static_cast<long>(n);
  float step[3], x[3], size = 0, off = 0;
  for (int a = 0; a < 3; ++a) {
    step[a] = std::bit_cast<float>(static_cast<std::uint32_t>(frame.exponent[a] - 8) << 23);
    x[a] = static_cast<float>(q.from_centre[a] - static_cast<double>(frame.origin[a]));
    size += std::abs(x[a]) + 65536 * step[a];
    off += step[a] * step[a];
  }
  const float error = 0.501f * std::sqrt(off) + kBoundError * size + static_cast<float>(q.rounding_double);
  const Lanes zero = {};
  for (std::size_t g = 0; g < n; g += kLanes) {
    const std::uint16_t* v = &rounded_[9 * run.first() + g];
    const auto corner = [&](std::size_t k) {
      return Lanes3{step[0] * load(v + 3 * k * n), step[1] * load(v + (3 * k + 1) * n),
                    step[2] * load(v + (3 * k + 2) * n)};
    };
    Lanes3 a = corner(0), b = corner(1), c = corner(2);
    const Lanes3 ab = b - a, bc = c - b, ca = a - c;  // exact
    const Lanes3 p = {zero + x[0], zero + x[1], zero + x[2]};
    a = a - p;
    b = b - p;
    c = c - p;
    const Lanes ab2 = ab.dot(ab), bc2 = bc.dot(bc), ca2 = ca.dot(ca);
    const Lanes edges =
        lesser(squared_distance_to_segment(a, ab, ab2),
               lesser(squared_distance_to_segment(b, bc, bc2), squared_distance_to_segment(c, ca, ca2)));
    const Lanes3 normal = ca.cross(ab);
    const Lanes normal2 = normal.dot(normal), longest2 = greater(ab2, greater(bc2, ca2));
    const Lanes height = a.dot(normal), plane = height * height / greater(normal2, zero + FLT_MIN);
    const Lanes inside =
        lesser(ab.cross(normal).dot(a), lesser(bc.cross(normal).dot(b), ca.cross(normal).dot(c)));
    const LaneInts flat = normal2 <= kFlat * kFlat * longest2 * longest2;
    // No point of a triangle is farther from its edges than half its least height.
    const Lanes within = flat ? 0.5f * root(normal2 / greater(longest2, zero + FLT_MIN)) : zero;
    const Lanes distance = root((inside >= zero) & ~flat ? plane : edges);
    const Lanes at_least = distance - within - error, at_most = distance + error;
    float nearest = FLT_MAX;
    const int lanes = static_cast<int>(std::min<std::size_t>(kLanes, n - g));
    for (int i = 0; i < lanes; ++i) nearest = std::min(nearest, at_most[i]);
    q.bring_in(nearest);
    for (int i = 0; i < lanes; ++i) {
      if (at_least[i] > q.reach) continue;
      if (q.waiting == Search::kMostCandidates) settle(q);
      const std::uint32_t s = run.first() + static_cast<std::uint32_t>(g) + static_cast<std::uint32_t>(i);
      prefetch(&corners_[s], sizeof(Corners));
      q.candidates[q.waiting++] = {at_least[i], s};
    }
  }
}

void SpatialHash::descend(Search& q) const {
  const Lanes zero = {};
  while (q.depth > 0) {
    const Search::Item item = q.stack[--q.depth];
    if (item.squared > q.limit) continue;
    ++q.count.cells;
    if (const Entry run{item.own, kNone}; run.count() > 0) {
      if (q.hinted) {
        settle(q);
        q.hinted = false;
        if (item.squared > q.limit) continue;
      }
      bound(q, children_[item.frame], run);
    }
    if (item.children == kNone) continue;
    const Children& c = children_[item.children];
    Lanes squared = zero;
    for (int a = 0; a < 3; ++a) {
      const float step = std::bit_cast<float>(static_cast<std::uint32_t>(c.exponent[a]) << 23);
      const float x = q.x[a] - c.origin[a];
      const Lanes out = greater(greater(step * load(c.lo[a]) - x, x - step * load(c.hi[a])), zero);
      squared += out * out;
    }
    float d[kLanes];
    std::memcpy(d, &squared, sizeof d);
    int near[kLanes], n = 0;
    for (int k = 0; k < kLanes; ++k) {
      near[n] = k;
      n += k < c.count && d[k] <= q.limit;
    }
    const int base = q.depth;
    for (int i = 0; i < n; ++i) {
      const int k = near[i];
      const Entry& e = c.entry[k];
      // Fetch while the others are looked at.
      if (e.children != kNone) prefetch(&children_[e.children], sizeof(Children));
      if (e.count() > 0) prefetch(&rounded_[9 * std::size_t{e.first()}], 18 * e.count());
      q.push(base, d[k], e, item.children);
    }
  }
}

SpatialHash::Nearest SpatialHash::nearest(const Vec3& p, double max_distance, int hint,
                                          Counters* counters) const {
  if (corners_.empty() || !(max_distance >= 0)) return {};
  Search q;
  q.p = p;
  const Vec3 x = q.from_centre = p - centre_;
  if (!x.allFinite()) return {};
  for (int a = 0; a < 3; ++a) q.x[a] = static_cast<float>(x[a]);
  q.rounding = 3e-7 * (x.cwiseAbs().maxCoeff() + 0.5 * box_.extent().maxCoeff());
  q.rounding_double = 1e-15 * (p.cwiseAbs().maxCoeff() + centre_.cwiseAbs().maxCoeff());
  q.best = max_distance * max_distance;
  q.bring_in(max_distance);
  if (hint >= 0 && static_cast<std::size_t>(hint) < slot_.size() &&
      slot_[static_cast<std::size_t>(hint)] >= 0) {
    const auto s = static_cast<std::uint32_t>(slot_[static_cast<std::size_t>(hint)]);
    if (max_distance < kRoom * side_ * (1 << start_)) {
      // Its distance would spare little of so short a search, and waiting for it costs more: it is fetched,
      // with what is kept of its neighbours, while the search goes down to them.
      prefetch(&corners_[s], sizeof(Corners));
      const std::size_t from = 9 * std::size_t{s};
      prefetch(&rounded_[from > 64 ? from - 64 : 0], 256);
      q.candidates[q.waiting++] = {0, s};
      q.hinted = true;
    } else {
      q.offer(s, test(s, p));
      ++q.count.exact;
      q.bring_in(std::sqrt(q.best) * (1 + 1e-12));
    }
  }

  // The level to start from: cells about as large as the ball, no finer than the coarsest triangles.
  const double radius = q.reach * (1 + 1e-9) + q.rounding;
  int level = start_;
  while (level < top_ &&
         side_ * (1 << level) < kRoom * std::max(radius, margin_[static_cast<std::size_t>(level)]))
    ++level;
  if (level >= top_) {
    q.push(0, 0, root_, kNone);
    descend(q);
  } else {
    const double side = side_ * (1 << level), reach = radius + margin_[static_cast<std::size_t>(level)];
    const double last = static_cast<double>((1 << (top_ - level)) - 1);
    int lo[3], hi[3];
    for (int a = 0; a < 3; ++a) {
      const double from = std::floor((p[a] - origin_[a] - reach) / side),
                   to = std::floor((p[a] - origin_[a] + reach) / side);
      // Out of the grid: an empty range. Centres on the far face of the box were put in the last cell.
      if (to < 0 || from > last + 1) return {};
      lo[a] = static_cast<int>(std::clamp(from, 0.0, last));
      hi[a] = static_cast<int>(std::clamp(to, 0.0, last));
    }
    // Distance to the cell grown by its margin, to take the nearest first.
    const double m = margin_[static_cast<std::size_t>(level)];
    for (int k = lo[2]; k <= hi[2]; ++k)
      for (int j = lo[1]; j <= hi[1]; ++j)
        for (int i = lo[0]; i <= hi[0]; ++i) {
          const Vec3 from = origin_ + side * Vec3(i, j, k) - Vec3::Constant(m);
          const float d = static_cast<float>(
              (1 - 1e-6) * squared_distance(Box{from, from + Vec3::Constant(side + 2 * m)}, p));
          if (d > q.limit) continue;
          ++q.count.lookups;
          const Entry* entry =
              find(level, morton(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j),
                                 static_cast<std::uint64_t>(k)));
          if (entry) q.push(0, d, *entry, kNone);
        }
    descend(q);
  }
  settle(q);
  if (counters) {
    ++counters->queries;
    counters->lookups += q.count.lookups;
    counters->cells += q.count.cells;
    counters->triangles += q.count.triangles;
    counters->exact += q.count.exact;
  }
  if (q.slot == kNone) return {};
  const std::int32_t id = corners_[q.slot].id;
  return {id < 0 ? ~id : id, q.best};
}

std::size_t SpatialHash::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(corners_) + bytes(rounded_) + bytes(slot_) + bytes(children_) + bytes(hash_);
}

}  // namespace hawser
