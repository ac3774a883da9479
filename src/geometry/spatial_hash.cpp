#include "hawser/geometry/spatial_hash.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <numeric>

#include "hawser/geometry/closest_point.hpp"

namespace hawser {
namespace {

// Side of the cell over the longest side of the box of a triangle in it, at least.
constexpr double kFineness = 0.75;

// Side of the cells a search starts from over its radius, at least.
constexpr double kRoom = 8;

constexpr int kMaxLevels = 20;  // 3 x 20 bits of key and a leading one fit 64

// Spread the lowest 21 bits of x to every third bit.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

std::uint64_t morton(std::uint64_t i, std::uint64_t j, std::uint64_t k) {
  return spread(i) | spread(j) << 1 | spread(k) << 2;
}

std::uint64_t scramble(std::uint64_t k) {
  k ^= k >> 31;
  k *= 0x7fb5d329728ea185ull;
  k ^= k >> 27;
  return k;
}

void prefetch(const void* at, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(static_cast<const char*>(at) + i);
}

float below(double x) { return std::nextafter(static_cast<float>(x), -FLT_MAX); }
float above(double x) { return std::nextafter(static_cast<float>(x), FLT_MAX); }

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

// Too flat for the formula above.
bool thin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double l2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > 1e-4 * l2);
}

}  // namespace

SpatialHash::SpatialHash(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles,
                         const std::vector<bool>& active) {
  std::vector<int> which;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (active.empty() || active[t]) which.push_back(static_cast<int>(t));
  slot_.assign(triangles.size(), -1);
  if (which.empty()) return;
  std::vector<std::uint64_t> keys;
  std::vector<int> levels;
  sort_triangles(vertices, triangles, which, keys, levels);
  build_cells(keys, levels);
}

void SpatialHash::sort_triangles(const std::vector<Vec3>& vertices,
                                 const std::vector<std::array<int, 3>>& triangles,
                                 const std::vector<int>& which, std::vector<std::uint64_t>& keys,
                                 std::vector<int>& levels) {
  const std::size_t n = which.size();
  const auto box_of = [&](int t) {
    Box b;
    for (const int v : triangles[static_cast<std::size_t>(t)]) b.add(vertices[static_cast<std::size_t>(v)]);
    return b;
  };
  std::vector<double> size(n);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const Box b = box_of(which[i]);
    box_.add(b);
    size[i] = b.extent().maxCoeff();
    if (size[i] > 0) smallest = std::min(smallest, size[i]);
  }
  origin_ = box_.lo;
  centre_ = box_.centre();
  const double extent = std::max(box_.extent().maxCoeff() * (1 + 1e-9), DBL_MIN * 1e30);
  top_ = static_cast<int>(
      std::clamp(std::floor(std::log2(extent / (kFineness * smallest))), 0.0, double{kMaxLevels}));
  side_ = std::ldexp(extent, -top_);

  std::vector<std::uint64_t> key(n);
  std::vector<int> level(n);
  const double cells = std::ldexp(1.0, top_) - 1;
  margin_.assign(static_cast<std::size_t>(top_) + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Box b = box_of(which[i]);
    int l = 0;
    while (l < top_ && std::ldexp(side_, l) < kFineness * size[i]) ++l;
    const Vec3 q = ((b.centre() - origin_) / side_).cwiseMax(0.0).cwiseMin(cells);
    key[i] = morton(static_cast<std::uint64_t>(q.x()), static_cast<std::uint64_t>(q.y()),
                    static_cast<std::uint64_t>(q.z())) >>
             (3 * l);
    level[i] = l;
    own_top_ = std::max(own_top_, l);
    double& m = margin_[static_cast<std::size_t>(l)];
    m = std::max(m, 0.5 * size[i] + 1e-9 * extent);
  }
  for (std::size_t l = 1; l < margin_.size(); ++l) margin_[l] = std::max(margin_[l], margin_[l - 1]);

  // The order of a walk down the tree: a cell's own triangles, then those of its children.
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t ka = key[a] << (3 * level[a]), kb = key[b] << (3 * level[b]);
    return ka != kb ? ka < kb : level[a] != level[b] ? level[a] > level[b] : a < b;
  });
  corners_.resize(n);
  keys.resize(n);
  levels.resize(n);
  for (std::size_t s = 0; s < n; ++s) {
    const std::uint32_t i = order[s];
    const int t = which[i];
    const auto& tri = triangles[static_cast<std::size_t>(t)];
    const Vec3 &a = vertices[static_cast<std::size_t>(tri[0])],
               &b = vertices[static_cast<std::size_t>(tri[1])],
               &c = vertices[static_cast<std::size_t>(tri[2])];
    corners_[s] = {
        {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()}, thin(a, b, c) ? ~t : t, 0};
    slot_[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(s);
    keys[s] = key[i];
    levels[s] = level[i];
  }
}

// A cell, or a part of one, on its way into the tree.
struct SpatialHash::Made {
  std::uint64_t key = 0;
  Entry entry;
  float lo[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, hi[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};

  void add(const Made& o) {
    for (int a = 0; a < 3; ++a) {
      lo[a] = std::min(lo[a], o.lo[a]);
      hi[a] = std::max(hi[a], o.hi[a]);
    }
  }
};

SpatialHash::Made SpatialHash::bundle(const Made* first, const Made* last) {
  Made out;
  for (const Made* m = first; m < last; ++m) out.add(*m);
  Children c{};
  c.count = static_cast<std::uint8_t>(last - first);
  for (int a = 0; a < 3; ++a) {
    c.origin[a] = out.lo[a];
    const double extent = static_cast<double>(out.hi[a]) - out.lo[a];
    const int e =
        extent > 0 ? std::clamp(static_cast<int>(std::ceil(std::log2(extent / 254))), -126, 120) : -126;
    c.exponent[a] = static_cast<std::uint8_t>(e + 127);
    for (std::ptrdiff_t k = 0; k < last - first; ++k) {
      c.lo[a][k] = static_cast<std::uint8_t>(
          std::floor(std::ldexp(static_cast<double>(first[k].lo[a]) - out.lo[a], -e)));
      c.hi[a][k] = static_cast<std::uint8_t>(
          std::ceil(std::ldexp(static_cast<double>(first[k].hi[a]) - out.lo[a], -e)));
    }
  }
  std::transform(first, last, c.entry, [](const Made& m) { return m.entry; });
  out.entry.children = static_cast<std::uint32_t>(children_.size());
  children_.push_back(c);
  return out;
}

void SpatialHash::build_cells(const std::vector<std::uint64_t>& keys, const std::vector<int>& levels) {
  // Runs of triangles of one cell, no longer than an entry can hold, by level in the order of their keys.
  std::vector<std::vector<Made>> own(static_cast<std::size_t>(top_) + 1);
  for (std::size_t s = 0; s < keys.size(); ++s) {
    auto& list = own[static_cast<std::size_t>(levels[s])];
    if (list.empty() || list.back().key != keys[s] || list.back().entry.count() == Entry::kMost) {
      list.emplace_back();
      list.back().key = keys[s];
      list.back().entry.own = static_cast<std::uint32_t>(s) << 4;
    }
    Made& run = list.back();
    ++run.entry.own;
    for (int k = 0; k < 9; ++k) {
      const double x = corners_[s].v[k] - centre_[k % 3];
      run.lo[k % 3] = std::min(run.lo[k % 3], below(x));
      run.hi[k % 3] = std::max(run.hi[k % 3], above(x));
    }
  }
  std::vector<std::pair<std::uint64_t, Entry>> hashed;
  std::vector<Made> finer, level, group, packed;
  for (int l = 0; l <= top_; ++l) {
    level.clear();
    const auto& mine = own[static_cast<std::size_t>(l)];
    std::size_t i = 0, j = 0;
    while (i < mine.size() || j < finer.size()) {
      const std::uint64_t key = std::min(i < mine.size() ? mine[i].key : ~std::uint64_t{0},
                                         j < finer.size() ? finer[j].key >> 3 : ~std::uint64_t{0});
      const std::size_t i0 = i, j0 = j;
      while (i < mine.size() && mine[i].key == key) ++i;
      while (j < finer.size() && finer[j].key >> 3 == key) ++j;
      Made cell;
      if (i - i0 == 1 && j - j0 <= 8) {
        // One run and the children.
        cell = mine[i0];
        if (j > j0) {
          const Made below_it = bundle(&finer[j0], finer.data() + j);
          cell.add(below_it);
          cell.entry.children = below_it.entry.children;
        }
      } else {
        // Several runs, or none: bundles of eight until one is left, which stands for the cell.
        group.assign(mine.begin() + static_cast<std::ptrdiff_t>(i0),
                     mine.begin() + static_cast<std::ptrdiff_t>(i));
        group.insert(group.end(), finer.begin() + static_cast<std::ptrdiff_t>(j0),
                     finer.begin() + static_cast<std::ptrdiff_t>(j));
        while (group.size() > 1) {
          packed.clear();
          for (std::size_t k = 0; k < group.size(); k += 8)
            packed.push_back(bundle(&group[k], group.data() + std::min(k + 8, group.size())));
          group.swap(packed);
        }
        cell = group.front();
      }
      cell.key = key;
      level.push_back(cell);
      ++cells_;
      if (l >= own_top_) hashed.emplace_back(code(l, key), cell.entry);
    }
    finer.swap(level);
  }
  root_ = finer.front().entry;
  std::size_t capacity = 4;
  while (capacity < 2 * hashed.size()) capacity *= 2;
  hash_.assign(capacity, {});
  for (const auto& [k, entry] : hashed) {
    std::size_t h = scramble(k) & (capacity - 1);
    while (hash_[h].code != 0) h = (h + 1) & (capacity - 1);
    hash_[h] = {k, entry};
  }
  children_.shrink_to_fit();
}

const SpatialHash::Entry* SpatialHash::find(std::uint64_t k) const {
  const std::size_t mask = hash_.size() - 1;
  std::size_t h = scramble(k) & mask;
  while (hash_[h].code != k) {
    if (hash_[h].code == 0) return nullptr;
    h = (h + 1) & mask;
  }
  return &hash_[h].entry;
}

double SpatialHash::test(std::uint32_t slot, const Vec3& p) const {
  const double* v = corners_[slot].v;
  const Vec3 a(v[0], v[1], v[2]), b(v[3], v[4], v[5]), c(v[6], v[7], v[8]);
  if (corners_[slot].id < 0) return closest_point_on_triangle(p, a, b, c).squared_distance;
  return squared_distance_to(a - p, b - p, c - p);
}

struct SpatialHash::Search {
  Vec3 p;
  float x[3];       // p from centre_
  double rounding;  // m, of x and of what is computed with it in float
  double best;      // m²
  std::uint32_t slot = kNone;
  float limit = 0;  // m², what is farther than this in float is farther than best
  struct Item {
    float squared;
    Entry entry;
  };
  Item stack[8 * (kMaxLevels + 12) + 32];
  int depth = 0;
  Counters count;

  void set_limit() {
    const double r = std::sqrt(best) * (1 + 1e-6) + rounding;
    limit = static_cast<float>(std::min(r * r, static_cast<double>(FLT_MAX) / 2));
  }
  void offer(std::uint32_t s, double squared) {
    if (squared > best || (squared == best && s >= slot)) return;
    const bool closer = squared < best;
    best = squared;
    slot = s;
    if (closer) set_limit();
  }
  // Onto the stack above `base`, farthest first.
  void push(int base, float squared, const Entry& entry) {
    int i = depth++;
    while (i > base && stack[i - 1].squared < squared) {
      stack[i] = stack[i - 1];
      --i;
    }
    stack[i] = {squared, entry};
  }
};

void SpatialHash::descend(Search& q) const {
  while (q.depth > 0) {
    const Search::Item item = q.stack[--q.depth];
    if (item.squared > q.limit) continue;
    const std::uint32_t first = item.entry.first(), count = item.entry.count();
    ++q.count.cells;
    q.count.triangles += count;
    for (std::uint32_t s = first; s < first + count; ++s) q.offer(s, test(s, q.p));
    if (item.entry.children == kNone) continue;
    const Children& c = children_[item.entry.children];
    float d[8] = {};
    for (int a = 0; a < 3; ++a) {
      const float step = std::bit_cast<float>(static_cast<std::uint32_t>(c.exponent[a]) << 23);
      const float x = q.x[a] - c.origin[a];
      for (int k = 0; k < 8; ++k) {
        const float out = std::max(std::max(step * c.lo[a][k] - x, x - step * c.hi[a][k]), 0.0f);
        d[k] += out * out;
      }
    }
    const int base = q.depth;
    for (int k = 0; k < c.count; ++k) {
      if (!(d[k] <= q.limit)) continue;
      // Fetch while the others are looked at.
      if (c.entry[k].children != kNone) prefetch(&children_[c.entry[k].children], sizeof(Children));
      if (c.entry[k].count() > 0) prefetch(&corners_[c.entry[k].first()], sizeof(Corners));
      q.push(base, d[k], c.entry[k]);
    }
  }
}

SpatialHash::Nearest SpatialHash::nearest(const Vec3& p, double max_distance, int hint,
                                          Counters* counters) const {
  if (corners_.empty() || !(max_distance >= 0)) return {};
  Search q;
  q.p = p;
  const Vec3 x = p - centre_;
  if (!x.allFinite()) return {};
  for (int a = 0; a < 3; ++a) q.x[a] = static_cast<float>(x[a]);
  q.rounding = 3e-7 * (x.cwiseAbs().maxCoeff() + 0.5 * box_.extent().maxCoeff());
  q.best = max_distance * max_distance;
  q.set_limit();
  if (hint >= 0 && static_cast<std::size_t>(hint) < slot_.size() &&
      slot_[static_cast<std::size_t>(hint)] >= 0) {
    const auto s = static_cast<std::uint32_t>(slot_[static_cast<std::size_t>(hint)]);
    q.offer(s, test(s, p));
    ++q.count.triangles;
  }

  // The level to start from: cells about as large as the ball, no finer than the coarsest triangles.
  const double radius = std::sqrt(q.best) * (1 + 1e-9) + q.rounding;
  int level = own_top_;
  while (level < top_ &&
         std::ldexp(side_, level) < kRoom * std::max(radius, margin_[static_cast<std::size_t>(level)]))
    ++level;
  if (level >= top_) {
    q.push(0, 0, root_);
    descend(q);
  } else {
    const double side = std::ldexp(side_, level), reach = radius + margin_[static_cast<std::size_t>(level)];
    const double last = std::ldexp(1.0, top_ - level) - 1;
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
          const float d = below(squared_distance(Box{from, from + Vec3::Constant(side + 2 * m)}, p));
          if (d > q.limit) continue;
          ++q.count.lookups;
          const Entry* entry =
              find(code(level, morton(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j),
                                      static_cast<std::uint64_t>(k))));
          if (entry) q.push(0, d, *entry);
        }
    descend(q);
  }
  if (counters) {
    ++counters->queries;
    counters->lookups += q.count.lookups;
    counters->cells += q.count.cells;
    counters->triangles += q.count.triangles;
  }
  if (q.slot == kNone) return {};
  const std::int32_t id = corners_[q.slot].id;
  return {id < 0 ? ~id : id, q.best};
}

std::size_t SpatialHash::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(corners_) + bytes(slot_) + bytes(children_) + bytes(hash_);
}

}  // namespace hawser
