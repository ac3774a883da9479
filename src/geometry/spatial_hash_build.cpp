// Building the spatial hash.
#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "spatial_hash_search.hpp"

namespace hawser {
namespace {

using detail::morton;
using detail::scramble;

// Side of the cell over the longest side of the box of a triangle in it, at least.
constexpr double kFineness = 0.75;

// Triangles of a run, and of a cell that is cut into up to eight runs whatever cells there are in it.
constexpr std::size_t kRun = 15, kBlock = 8 * kRun;

constexpr int kMaxLevels = detail::kMaxLevels;

float below(double x) { return std::nextafter(static_cast<float>(x), -FLT_MAX); }
float above(double x) { return std::nextafter(static_cast<float>(x), FLT_MAX); }

// Too flat for the short formula of the squared distance.
bool thin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double l2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > 1e-4 * l2);
}

}  // namespace

SpatialHash::SpatialHash(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles,
                         const std::vector<bool>& active) {
  std::vector<int> which;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (active.empty() || active[t]) which.push_back(static_cast<int>(t));
  slot_.assign(triangles.size(), -1);
  if (which.empty()) return;
  std::vector<std::uint64_t> keys;
  std::vector<int> levels;
  vertices_.assign(vertices.begin(), vertices.end());
  sort_triangles(vertices, triangles, which, keys, levels);
  build_cells(keys, levels);
  sort_vertices();
}

void SpatialHash::sort_vertices() {
  LargeVector<Vec3> sorted;
  std::vector<std::uint32_t> place(vertices_.size(), kNone);
  for (Corners& t : corners_)
    for (std::uint32_t& v : t.v) {
      if (place[v] == kNone) {
        place[v] = static_cast<std::uint32_t>(sorted.size());
        sorted.push_back(vertices_[v]);
      }
      v = place[v];
    }
  sorted.shrink_to_fit();
  vertices_ = std::move(sorted);
}

void SpatialHash::sort_triangles(std::span<const Vec3> vertices,
                                 std::span<const std::array<int, 3>> triangles, const std::vector<int>& which,
                                 std::vector<std::uint64_t>& keys, std::vector<int>& levels) {
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
  half_ = 0.5 * box_.extent().maxCoeff();
  away_ = centre_.cwiseAbs().maxCoeff();
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
    start_ = std::max(start_, std::min(l + 2, top_));
    double& m = margin_[static_cast<std::size_t>(l)];
    m = std::max(m, 0.5 * size[i] + 1e-9 * extent);
  }
  for (std::size_t l = 1; l < margin_.size(); ++l) margin_[l] = std::max(margin_[l], margin_[l - 1]);

  least_ = start_;
  while (least_ < top_ && side_ * (1 << least_) < Start::kRoom * margin_[static_cast<std::size_t>(least_)])
    ++least_;

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
    corners_[s] = {{static_cast<std::uint32_t>(tri[0]), static_cast<std::uint32_t>(tri[1]),
                    static_cast<std::uint32_t>(tri[2])},
                   thin(a, b, c) ? ~t : t};
    slot_[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(s);
    keys[s] = key[i];
    levels[s] = level[i];
  }
}

// A cell, or a part of one, on its way into the tree.
struct SpatialHash::Made {
  std::uint64_t key = 0;
  std::uint32_t first = 0;
  std::size_t total = 0;  // triangles in it and below it: first, first + 1, ...
  Entry entry;
  std::vector<Made> parts;  // children not yet in a block
  bool uncut = false;       // few triangles, not yet in runs
  float lo[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, hi[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};

  void add(const Vec3& x) {
    for (int a = 0; a < 3; ++a) {
      lo[a] = std::min(lo[a], below(x[a]));
      hi[a] = std::max(hi[a], above(x[a]));
    }
  }
  void add(const Made& o) {
    first = total ? std::min(first, o.first) : o.first;
    total += o.total;
    for (int a = 0; a < 3; ++a) {
      lo[a] = std::min(lo[a], o.lo[a]);
      hi[a] = std::max(hi[a], o.hi[a]);
    }
  }
};

// Puts the parts, up to eight, in a block.
SpatialHash::Made SpatialHash::bundle(Made* first, Made* last) {
  Made out;
  for (Made* m = first; m < last; ++m) {
    if (!m->parts.empty()) *m = bundle(m->parts.data(), m->parts.data() + m->parts.size());
    out.add(*m);
  }
  Children c{};
  c.count = static_cast<std::uint8_t>(last - first);
  for (int a = 0; a < 3; ++a) {
    c.origin[a] = out.lo[a];
    const double extent = static_cast<double>(out.hi[a]) - out.lo[a];
    const int e =
        extent > 0 ? std::clamp(static_cast<int>(std::ceil(std::log2(extent / 254))), -110, 120) : -110;
    c.exponent[a] = static_cast<std::uint8_t>(e + 127);
    for (std::ptrdiff_t k = 0; k < last - first; ++k) {
      c.box[a][k] = static_cast<std::uint8_t>(
          std::floor(std::ldexp(static_cast<double>(first[k].lo[a]) - out.lo[a], -e)));
      c.box[a][k + 8] = static_cast<std::uint8_t>(
          std::ceil(std::ldexp(static_cast<double>(first[k].hi[a]) - out.lo[a], -e)));
    }
  }
  std::transform(first, last, c.entry, [](const Made& m) { return m.entry; });
  for (Made* m = first; m < last; ++m) round_corners(c, m->entry);
  out.entry.children = static_cast<std::uint32_t>(children_.size());
  children_.push_back(c);
  return out;
}

// Corners of a run to the grid of the block it is in: at most half a step off in each coordinate.
void SpatialHash::round_corners(const Children& frame, const Entry& run) {
  const std::size_t n = run.count();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 9; ++k) {
      const auto a = static_cast<int>(k % 3);
      const double x = corner(run.first() + i, k / 3)[a] - centre_[a] - frame.origin[a];
      const double steps = std::round(std::ldexp(x, 127 - frame.exponent[a] + 2));
      rounded_[3 * run.first() + k / 3 * n + i] |= static_cast<std::uint32_t>(std::clamp(steps, 0.0, 1023.0))
                                                   << 10 * a;
    }
}

SpatialHash::Made SpatialHash::run_of(std::uint32_t first, std::size_t total) const {
  Made run;
  run.first = first;
  run.total = total;
  run.entry.own = first << 4 | static_cast<std::uint32_t>(total);
  for (std::uint32_t s = first; s < first + total; ++s)
    for (std::size_t k = 0; k < 3; ++k) run.add(Vec3(corner(s, k) - centre_));
  return run;
}

// Triangles of a cell into runs as full as can be, so that few are looked at: cut in two where the boxes
// of the halves, times their runs, have the least area, and again.
void SpatialHash::cut(std::uint32_t first, std::size_t total, std::size_t runs, std::vector<Made>& out) {
  if (runs == 1) {
    out.push_back(run_of(first, total));
    return;
  }
  const std::size_t left_runs = runs / 2, right_runs = runs - left_runs;
  const std::size_t least = total - std::min(total - left_runs, right_runs * kRun),
                    most = std::min(total - right_runs, left_runs * kRun);
  // By their centres.
  std::array<std::pair<double, Corners>, kBlock> sorted;
  const auto order = [&](int axis) {
    for (std::size_t i = 0; i < total; ++i) {
      const std::uint32_t s = first + static_cast<std::uint32_t>(i);
      sorted[i] = {corner(s, 0)[axis] + corner(s, 1)[axis] + corner(s, 2)[axis], corners_[s]};
    }
    std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(total),
              [](const auto& a, const auto& b) {
                return a.first != b.first ? a.first < b.first : a.second.index() < b.second.index();
              });
    for (std::size_t i = 0; i < total; ++i) corners_[first + i] = sorted[i].second;
  };
  const auto area = [](const Box& b) {
    const Vec3 e = b.extent();
    return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
  };
  double best = std::numeric_limits<double>::infinity();
  std::size_t at = least;
  int along = 0;
  std::array<double, kBlock> left;
  for (int axis = 0; axis < 3; ++axis) {
    order(axis);
    const auto box = [&](std::size_t i, Box& b) {
      for (std::size_t k = 0; k < 3; ++k) b.add(corner(first + i, k));
    };
    Box b;
    for (std::size_t i = 0; i < most; ++i) {
      box(i, b);
      left[i] = area(b);
    }
    b = Box();
    for (std::size_t i = total; i-- > least;) {
      box(i, b);
      if (i > most) continue;
      const double cost =
          left[i - 1] * static_cast<double>(left_runs) + area(b) * static_cast<double>(right_runs);
      if (cost < best) best = cost, at = i, along = axis;
    }
  }
  order(along);
  cut(first, at, left_runs, out);
  cut(first + static_cast<std::uint32_t>(at), total - at, right_runs, out);
}

void SpatialHash::settle(Made& cell) {
  if (!cell.uncut) return;
  cell.uncut = false;
  if (cell.total <= kRun) {
    cell.entry.own = cell.first << 4 | static_cast<std::uint32_t>(cell.total);
    return;
  }
  cut(cell.first, cell.total, (cell.total + kRun - 1) / kRun, cell.parts);
  for (std::uint32_t s = cell.first; s < cell.first + cell.total; ++s)
    slot_[static_cast<std::size_t>(corners_[s].index())] = static_cast<std::int32_t>(s);
}

// One cell of its runs and children. Children of few parts give way to their parts, so that blocks are full
// and ways down are short.
SpatialHash::Made SpatialHash::join(std::vector<Made>& parts, bool below_hash) {
  Made out;
  for (const Made& m : parts) out.add(m);
  if (below_hash && out.total <= kBlock) {
    out.uncut = true;
    return out;
  }
  for (Made& m : parts) settle(m);
  while (parts.size() > 8) {
    std::vector<Made> packed;
    for (std::size_t k = 0; k < parts.size(); k += 8)
      packed.push_back(bundle(&parts[k], parts.data() + std::min(k + 8, parts.size())));
    parts.swap(packed);
  }
  for (;;) {
    std::size_t most = parts.size();
    double area = -1;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Made& m = parts[k];
      if (m.parts.empty() || parts.size() - 1 + m.parts.size() > 8) continue;
      const double x = m.hi[0] - m.lo[0], y = m.hi[1] - m.lo[1], z = m.hi[2] - m.lo[2];
      if (x * y + y * z + z * x > area) {
        area = x * y + y * z + z * x;
        most = k;
      }
    }
    if (most == parts.size()) break;
    std::vector<Made> inner = std::move(parts[most].parts);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(most));
    parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(most), std::make_move_iterator(inner.begin()),
                 std::make_move_iterator(inner.end()));
  }
  if (parts.size() == 1) return parts.front();
  out.parts = std::move(parts);
  return out;
}

void SpatialHash::add_table(const Made* first, const Made* last) {
  std::size_t capacity = 4;
  while (capacity < 2 * static_cast<std::size_t>(last - first)) capacity *= 2;
  const Table t{hash_.size(), capacity - 1};
  tables_.push_back(t);
  hash_.resize(t.first + capacity);
  for (const Made* m = first; m < last; ++m) {
    std::size_t h = scramble(m->key) & t.mask;
    while (hash_[t.first + h].key != kFree) h = (h + 1) & t.mask;
    hash_[t.first + h] = {m->key, m->entry};
  }
}

void SpatialHash::build_cells(const std::vector<std::uint64_t>& keys, const std::vector<int>& levels) {
  rounded_.assign(3 * keys.size() + 16, 0);  // sixteen are read at a time, also at the end
  // Runs of triangles of one cell, no longer than an entry can hold, by level in the order of their keys.
  std::vector<std::vector<Made>> own(static_cast<std::size_t>(top_) + 1);
  for (std::size_t s = 0; s < keys.size(); ++s) {
    auto& list = own[static_cast<std::size_t>(levels[s])];
    if (list.empty() || list.back().key != keys[s] || list.back().entry.count() == Entry::kMost) {
      list.emplace_back();
      list.back().key = keys[s];
      list.back().first = static_cast<std::uint32_t>(s);
      list.back().entry.own = static_cast<std::uint32_t>(s) << 4;
    }
    Made& run = list.back();
    ++run.entry.own;
    ++run.total;
    for (std::size_t k = 0; k < 3; ++k) run.add(Vec3(corner(s, k) - centre_));
  }

  std::vector<Made> finer, level, group;
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
      group.assign(mine.begin() + static_cast<std::ptrdiff_t>(i0),
                   mine.begin() + static_cast<std::ptrdiff_t>(i));
      std::move(finer.begin() + static_cast<std::ptrdiff_t>(j0),
                finer.begin() + static_cast<std::ptrdiff_t>(j), std::back_inserter(group));
      Made cell = join(group, l <= start_);
      if (l >= start_) settle(cell);
      // What is looked up has its block, also a single run.
      if (l >= start_ && !cell.parts.empty())
        cell = bundle(cell.parts.data(), cell.parts.data() + cell.parts.size());
      else if (l == start_ && cell.entry.count() > 0)
        cell = bundle(&cell, &cell + 1);
      cell.key = key;
      level.push_back(std::move(cell));
    }
    if (l >= start_) add_table(level.data(), level.data() + level.size());
    finer.swap(level);
  }
  root_ = finer.front().entry;
  children_.shrink_to_fit();
}

}  // namespace hawser
