#include "patch_tree.hpp"

#include <algorithm>
#include <cfloat>
#include <cstring>
#include <limits>
#include <utility>

namespace hawser::detail {
namespace {

constexpr int kBins = 16;

double area(const Box& b) {
  if (b.empty()) return 0;
  const Vec3 e = b.extent();
  return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

}  // namespace

PatchTree::Range PatchTree::range(const std::vector<Box>& boxes, int from, int to, int depth) const {
  Range r{from, to, depth, {}};
  for (int i = from; i < to; ++i)
    r.box.add(boxes[static_cast<std::size_t>(ids_[static_cast<std::size_t>(i)])]);
  return r;
}

// Reorders the items of a range and returns where its second half begins.
int PatchTree::split(const std::vector<Box>& boxes, const Range& r) {
  const auto box = [&](int item) -> const Box& { return boxes[static_cast<std::size_t>(item)]; };
  const auto begin = ids_.begin() + r.from, end = ids_.begin() + r.to;
  const auto half = begin + (r.to - r.from) / 2;
  Box centres;
  for (auto i = begin; i != end; ++i) centres.add(box(*i).centre());
  int axis = 0;
  const double extent = centres.extent().maxCoeff(&axis);
  // Splits at the median keep the tree shallow where the heuristic would not.
  if (!(extent > 0) || r.depth > 20) {
    std::nth_element(begin, half, end, [&](int a, int b) {
      const double x = box(a).centre()[axis], y = box(b).centre()[axis];
      return x != y ? x < y : a < b;
    });
    return static_cast<int>(half - ids_.begin());
  }
  double best = std::numeric_limits<double>::infinity();
  int best_axis = axis, best_bin = kBins / 2;
  const auto bin = [&](int item, int a) {
    const double f = (box(item).centre()[a] - centres.lo[a]) / centres.extent()[a];
    return std::clamp(static_cast<int>(f * kBins), 0, kBins - 1);
  };
  for (int a = 0; a < 3; ++a) {
    if (!(centres.extent()[a] > 0)) continue;
    Box bins[kBins];
    int count[kBins] = {};
    for (auto i = begin; i != end; ++i) {
      const int b = bin(*i, a);
      bins[b].add(box(*i)), ++count[b];
    }
    double below[kBins];
    Box grown;
    int n = 0;
    for (int b = 0; b < kBins; ++b) {
      below[b] = area(grown) * n;
      grown.add(bins[b]), n += count[b];
    }
    grown = Box{}, n = 0;
    for (int b = kBins - 1; b > 0; --b) {
      grown.add(bins[b]), n += count[b];
      if (n == 0 || n == r.to - r.from) continue;
      const double cost = below[b] + area(grown) * n;
      if (cost < best) best = cost, best_axis = a, best_bin = b;
    }
  }
  const auto middle =
      std::stable_partition(begin, end, [&](int item) { return bin(item, best_axis) < best_bin; });
  return static_cast<int>((middle == begin || middle == end ? half : middle) - ids_.begin());
}

std::int32_t PatchTree::build(const std::vector<Box>& boxes, const Range& whole) {
  std::vector<Range> parts = {whole};
  while (parts.size() < kWide) {
    std::size_t largest = parts.size();
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].to - parts[i].from > kMostInLeaf &&
          (largest == parts.size() || area(parts[i].box) > area(parts[largest].box)))
        largest = i;
    if (largest == parts.size()) break;
    const Range r = parts[largest];
    const int middle = split(boxes, r);
    parts[largest] = range(boxes, r.from, middle, r.depth + 1);
    parts.push_back(range(boxes, middle, r.to, r.depth + 1));
  }
  const std::size_t me = nodes_.size();
  nodes_.emplace_back();
  Node n{};
  n.count = static_cast<std::int32_t>(parts.size());
  const float inf = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < kWide; ++k)
    for (int a = 0; a < 3; ++a) {
      n.lo[a][k] = inf, n.hi[a][k] = -inf;
      if (k >= parts.size()) continue;
      n.lo[a][k] = std::nextafter(static_cast<float>(parts[k].box.lo[a] - centre_[a]), -inf);
      n.hi[a][k] = std::nextafter(static_cast<float>(parts[k].box.hi[a] - centre_[a]), inf);
    }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Range& r = parts[k];
    n.child[k] = r.to - r.from <= kMostInLeaf ? ~(r.from << kBits | (r.to - r.from - 1)) : build(boxes, r);
  }
  nodes_[me] = n;
  return static_cast<std::int32_t>(me);
}

// A quadratic patch lies in the hull of its corners and of the middles of its edges bent by c / 2.
Box box_of(const SmoothPatch& q) {
  Box b;
  for (std::size_t i = 0; i < 3; ++i) {
    b.add(q.p[i]);
    b.add(Vec3(0.5 * (q.p[i] + q.p[(i + 1) % 3] + q.c[i])));
  }
  return b;
}

PatchTree::PatchTree(const std::vector<Item>& items) {
  if (items.empty()) return;
  std::vector<Box> boxes;
  for (const Item& i : items) {
    ids_.push_back(static_cast<int>(ids_.size()));
    boxes.push_back(box_of(i.patch));
  }
  const Range all = range(boxes, 0, static_cast<int>(ids_.size()), 0);
  box_ = all.box;
  centre_ = box_.centre();
  size_ = 0.5 * box_.extent().maxCoeff();
  build(boxes, all);
  nodes_.shrink_to_fit();
  corners_.assign(9 * ids_.size() + kWide, 0);
  for (const Node& n : nodes_)
    for (int k = 0; k < n.count; ++k) {
      if (n.child[k] >= 0) continue;
      const auto run = static_cast<std::uint32_t>(~n.child[k]);
      const std::size_t first = run >> kBits, count = (run & (kMostInLeaf - 1)) + 1;
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 9; ++c)
          corners_[9 * first + c * count + i] = static_cast<float>(
              items[static_cast<std::size_t>(ids_[first + i])].patch.p[c / 3][static_cast<int>(c % 3)] -
              centre_[static_cast<int>(c % 3)]);
    }
  for (int& id : ids_) {
    const Item& i = items[static_cast<std::size_t>(id)];
    bulges_.push_back(static_cast<float>(i.patch.bulge() * (1 + 1e-6)));
    id = i.triangle;
  }
}

namespace {

using Lanes [[gnu::vector_size(32)]] = float;
using LaneInts [[gnu::vector_size(32)]] = std::int32_t;

struct Lanes3 {
  Lanes x, y, z;
  Lanes3 operator-(const Lanes3& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Lanes dot(const Lanes3& o) const { return x * o.x + y * o.y + z * o.z; }
  Lanes3 cross(const Lanes3& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
};

Lanes load(const float* at) {
  Lanes a;
  std::memcpy(&a, at, sizeof a);
  return a;
}
Lanes lesser(Lanes a, Lanes b) { return a < b ? a : b; }
Lanes greater(Lanes a, Lanes b) { return a > b ? a : b; }
Lanes root(Lanes a) {
  for (int i = 0; i < 8; ++i) a[i] = std::sqrt(a[i]);
  return a;
}

Lanes squared_distance_to_segment(const Lanes3& a, const Lanes3& e, Lanes e2) {
  const Lanes zero = {}, one = zero + 1;
  const Lanes t = lesser(greater(-a.dot(e) / greater(e2, zero + FLT_MIN), zero), one);
  const Lanes3 r = {a.x + t * e.x, a.y + t * e.y, a.z + t * e.z};
  return r.dot(r);
}

// As in the spatial hash: a triangle lower than kFlat of its longest side is taken for its edges; errors of
// single precision over the size of what is computed with, sin of half the sharpest angle included.
constexpr float kFlat = 0.1f, kBoundError = 1e-4f;

}  // namespace

PatchTree::Search::Search(const PatchTree& tree, const Vec3& p, double best) {
  const Vec3 from_centre = p - tree.centre_;
  for (int a = 0; a < 3; ++a) x[a] = static_cast<float>(from_centre[a]);
  rounding = 3e-7 * (from_centre.cwiseAbs().maxCoeff() + tree.size_);
  reach = std::numeric_limits<double>::infinity();
  bring_in(std::sqrt(best) * (1 + 1e-12));
  stack[depth++] = {0, 0};
}

void PatchTree::Search::bring_in(double r) {
  if (!(r < reach) && limit > 0) return;
  reach = r;
  const double far = r * (1 + 1e-6) + rounding;
  limit = static_cast<float>(std::min(far * far, 1e38));
}

// Bounds of the distances of a leaf.
void PatchTree::bound(Search& s, std::size_t first, std::size_t n) const {
  const Lanes zero = {};
  const float* v = &corners_[9 * first];
  const auto corner = [&](std::size_t k) {
    return Lanes3{load(v + 3 * k * n) - s.x[0], load(v + (3 * k + 1) * n) - s.x[1],
                  load(v + (3 * k + 2) * n) - s.x[2]};
  };
  const Lanes3 a = corner(0), b = corner(1), c = corner(2);
  const Lanes3 ab = b - a, bc = c - b, ca = a - c;
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
  const Lanes error = kBoundError * (distance + root(longest2)) + 2 * static_cast<float>(s.rounding);
  float at_least[kWide], at_most[kWide];
  const Lanes low = distance - within - error, high = distance + error;
  std::memcpy(at_least, &low, sizeof low);
  std::memcpy(at_most, &high, sizeof high);
  float nearest = FLT_MAX;
  for (std::size_t i = 0; i < n; ++i) nearest = std::min(nearest, at_most[i] + bulges_[first + i]);
  s.bring_in(static_cast<double>(nearest));
  for (std::size_t i = 0; i < n; ++i) {
    const double least = static_cast<double>(at_least[i] - bulges_[first + i]);
    if (!(least > s.reach)) s.candidates[s.waiting++] = {least, ids_[first + i]};
  }
}

bool PatchTree::collect(Search& s) const {
  while (s.depth > 0) {
    const Search::Waiting item = s.stack[--s.depth];
    if (item.squared > s.limit) continue;
    if (item.child < 0) {
      const auto run = static_cast<std::uint32_t>(~item.child);
      bound(s, run >> kBits, (run & (kMostInLeaf - 1)) + 1);
      if (s.waiting > Search::kMostCandidates - kMostInLeaf) return true;
      continue;
    }
    const Node& n = nodes_[static_cast<std::size_t>(item.child)];
    Lanes squared = {};
    const Lanes zero = {};
    for (int a = 0; a < 3; ++a) {
      const Lanes out = greater(greater(load(n.lo[a]) - s.x[a], s.x[a] - load(n.hi[a])), zero);
      squared += out * out;
    }
    float d[kWide];
    std::memcpy(d, &squared, sizeof d);
    const int base = s.depth;
    for (int k = 0; k < n.count; ++k) {
      if (!(d[k] <= s.limit)) continue;
      int i = s.depth++;
      for (; i > base && s.stack[i - 1].squared < d[k]; --i) s.stack[i] = s.stack[i - 1];
      s.stack[i] = {d[k], n.child[k]};
      if (n.child[k] >= 0) {
        const char* at = reinterpret_cast<const char*>(&nodes_[static_cast<std::size_t>(n.child[k])]);
        for (std::size_t line = 0; line < sizeof(Node); line += 64) __builtin_prefetch(at + line);
      } else {
        const std::size_t first = static_cast<std::uint32_t>(~n.child[k]) >> kBits;
        for (std::size_t line = 0; line < 9 * 4 * kWide; line += 64)
          __builtin_prefetch(reinterpret_cast<const char*>(&corners_[9 * first]) + line);
      }
    }
  }
  return false;
}

}  // namespace hawser::detail
