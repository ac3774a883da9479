// Grouping of the facets of a mesh near a place, and the nearest point of one facet group.
#include "mesh_facet_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/geometry/segment_distance.hpp"
#include "hawser/math/disjoint_sets.hpp"
#include "hawser/math/segment.hpp"

namespace hawser::detail {
namespace {

constexpr double kParallel = 0.9;    // cosine: nearer directions belong to one facet group
constexpr double kCone = 0.974;      // cosine of half that angle
constexpr double kConcave = 0.2;     // rad, total: less does not create a second facet group
constexpr double kFlatEdge = 1e-10;  // 1 - cosine of an edge that counts as flat

// True if this holds for any chord of a polyline; a single point has one chord of zero length.
template <class Is>
bool any_chord(std::span<const Vec3> axis, Is&& is) {
  for (std::size_t i = 0; i + 1 < axis.size() || i == 0; ++i)
    if (is(axis[i], axis[std::min(i + 1, axis.size() - 1)])) return true;
  return false;
}

// Corner of u that is not on edge `edge` of t.
const Vec3& beyond(const Facets& facets, int u, int t, int edge) {
  const auto& triangles = facets.mesh().triangles;
  const auto& corners = triangles[static_cast<std::size_t>(t)];
  const int a = corners[static_cast<std::size_t>(edge)];
  const int b = corners[static_cast<std::size_t>((edge + 1) % 3)];
  int k = 0;
  while (k < 2 && (triangles[static_cast<std::size_t>(u)][static_cast<std::size_t>(k)] == a ||
                   triangles[static_cast<std::size_t>(u)][static_cast<std::size_t>(k)] == b))
    ++k;
  return facets.corner(u, k);
}

// True if the facet u rises in front of t with the normal n.
bool rises(const Facets& facets, const Vec3& n, int t, int edge, int u) {
  return n.dot(beyond(facets, u, t, edge) - facets.corner(t, edge)) > 0;
}

// Index of a facet in a list sorted by triangle; -1: none.
template <class F>
int place_of(const std::vector<F>& facets, int triangle) {
  const auto at = std::ranges::lower_bound(facets, triangle, {}, &F::triangle);
  return at != facets.end() && at->triangle == triangle ? static_cast<int>(at - facets.begin()) : -1;
}

}  // namespace

bool MeshFacetGroups::convex(const Facets& facets, const Pseudonormals& normals, int components) {
  if (components != 1) return false;
  // Computed only as far as needed, because most meshes prove not convex within a few facets.
  std::vector<Vec3> known;
  const auto normal = [&](int t) {
    while (static_cast<int>(known.size()) <= t)
      known.push_back(normals.face(facets, static_cast<int>(known.size())));
    return known[static_cast<std::size_t>(t)];
  };
  for (int t = 0; t < static_cast<int>(facets.mesh().triangles.size()); ++t)
    for (int i = 0; i < 3; ++i) {
      const int u = normals.neighbour(t, i);
      if (u < 0) return false;
      if (u < t) continue;
      const Vec3 n = normal(t);
      if (n.dot(normal(u)) < 1 - kFlatEdge && rises(facets, n, t, i, u)) return false;
    }
  return true;
}

FacetGroup::Facet MeshFacetGroups::ball(int t) const {
  FacetGroup::Facet f;
  f.triangle = t;
  Box box;
  for (int i = 0; i < 3; ++i) box.add(facets_.corner(t, i));
  f.centre = box.centre();
  for (int i = 0; i < 3; ++i) f.radius = std::max(f.radius, (facets_.corner(t, i) - f.centre).norm());
  f.radius += bulge(t);
  return f;
}

// Collects the facets that may come within reach of the axis, with their normals; returns whether all normals
// are similar.
bool MeshFacetGroups::parallel(std::span<const Vec3> axis, double reach, std::vector<Near>& out) const {
  out.clear();
  Vec3 mean = Vec3::Zero();
  Box around;
  for (const Vec3& p : axis) around.add(p);
  around = around.grown(reach);
  const auto near_axis = [&](std::size_t node) {
    const Box& box = tree_.nodes()[node].box;
    if (!box.overlaps(around)) return false;
    const Vec3 centre = box.centre();
    const double far = 0.5 * box.diagonal() + reach;
    return any_chord(axis, [&](const Vec3& p, const Vec3& q) {
      return squared_distance_to_segment(centre, p, q) <= far * far;
    });
  };
  tree_.walk(near_axis, [&](int t) {
    const FacetGroup::Facet f = ball(t);
    const double far = f.radius + reach;
    const double off = bulge(t) + reach;
    any_chord(axis, [&](const Vec3& p, const Vec3& q) {
      if (squared_distance_to_segment(f.centre, p, q) > far * far) return false;
      const Vec3 n = normals_.quick_face(facets_, t);
      const double from = n.dot(p - facets_.corner(t, 0));
      const double to = n.dot(q - facets_.corner(t, 0));
      if (std::min(from, to) > off || std::max(from, to) < -off) return false;  // beyond its plane
      // Long facets have large balls, most of which meet the axis although the facet is far from it.
      if (!facets_.may_reach(t, 0.5 * (p + q), reach + 0.5 * (q - p).norm())) return false;
      out.push_back({f, n});
      mean += n;
      return true;
    });
  });
  mean.normalize();
  return std::all_of(out.begin(), out.end(), [&](const Near& f) { return f.normal.dot(mean) > kCone; });
}

// True if facets are connected and nearly convex. Sorts them.
bool MeshFacetGroups::bulging(std::vector<Near>& near) const {
  thread_local DisjointSets sets;
  if (near.size() < 2) return true;
  std::ranges::sort(near, {}, &Near::triangle);
  sets.reset(near.size());
  double concave = 0;
  for (int k = 0; k < static_cast<int>(near.size()); ++k) {
    const Near& f = near[static_cast<std::size_t>(k)];
    const int t = f.triangle;
    for (int i = 0; i < 3; ++i) {
      const int u = normals_.neighbour(t, i);
      const int l = u > t ? place_of(near, u) : -1;
      if (l < 0) continue;
      sets.unite(k, l);
      const double off = 1 - f.normal.dot(near[static_cast<std::size_t>(l)].normal);
      if (off <= kFlatEdge || !rises(facets_, f.normal, t, i, u)) continue;
      concave += std::acos(std::clamp(1 - off, -1.0, 1.0));
      if (concave > kConcave) return false;
    }
  }
  const int first = sets.smallest(0);
  for (int k = 1; k < static_cast<int>(near.size()); ++k)
    if (sets.smallest(k) != first) return false;
  return true;
}

bool MeshFacetGroups::one(std::span<const Vec3> axis, double reach) const {
  thread_local std::vector<Near> near;
  return parallel(axis, reach, near) || bulging(near);
}

// True if the edge is reentrant and sharp. Curved patches may meet smoothly where their facets do not.
bool MeshFacetGroups::cut(int t, int edge, int other) const {
  const Vec3 n = normals_.quick_face(facets_, t);
  const Vec3 m = normals_.quick_face(facets_, other);
  if (n.isZero(0) || m.isZero(0) || n.dot(m) > kParallel || !rises(facets_, n, t, edge, other)) return false;
  if (!facets_.curved(t) && !facets_.curved(other)) return true;
  int k = 0;
  while (k < 2 && normals_.neighbour(other, k) != t) ++k;
  const auto a = on_edge(edge, 0.5);
  const auto b = on_edge(k, 0.5);
  return facets_.patch(t)
             .normal(a[0], a[1])
             .normalized()
             .dot(facets_.patch(other).normal(b[0], b[1]).normalized()) <= kParallel;
}

// Nearest points of a flat facet and a chord.
struct MeshFacetGroups::Approach {
  double distance = std::numeric_limits<double>::infinity();  // m
  Vec3 from = Vec3::Zero();                                   // on the chord
};

MeshFacetGroups::Approach MeshFacetGroups::approach(int t, const Vec3& a, const Vec3& b) const {
  Approach best;
  const Vec3& p = facets_.corner(t, 0);
  const Vec3& q = facets_.corner(t, 1);
  const Vec3& r = facets_.corner(t, 2);
  const auto offer = [&](double distance, const Vec3& from) {
    if (distance < best.distance) best = {distance, from};
  };
  offer(std::sqrt(closest_point_on_triangle(a, p, q, r).squared_distance), a);
  if (a == b) return best;
  offer(std::sqrt(closest_point_on_triangle(b, p, q, r).squared_distance), b);
  const Vec3 n = normals_.quick_face(facets_, t);
  const double above = n.dot(a - p);
  const double below = n.dot(b - p);
  if (above * below < 0) {
    const Vec3 x = a + above / (above - below) * (b - a);
    offer(std::sqrt(closest_point_on_triangle(x, p, q, r).squared_distance), x);
  }
  for (int i = 0; i < 3; ++i) {
    const SegmentPair s =
        closest_points_of_segments(a, b, facets_.corner(t, i), facets_.corner(t, (i + 1) % 3));
    offer(s.distance, s.on_a);
  }
  return best;
}

bool MeshFacetGroups::holds(const FacetGroup& group, int triangle) {
  return place_of(group.facets, triangle) >= 0;
}

Vec3 MeshFacetGroups::pseudonormal(const FacetGroup& group, const FacetSearch::Foot& foot) const {
  const int t = foot.triangle;
  const int i = feature_index(foot.feature);
  if (foot.feature == Feature::face) return normals_.at(facets_, t, foot);
  if (is_edge(foot.feature)) {
    const int u = normals_.neighbour(t, i);
    if (u >= 0 && holds(group, u)) return normals_.at(facets_, t, foot);
    return facets_.curved(t) ? Vec3(facets_.patch(t).normal(foot.u, foot.v).normalized())
                             : normals_.face(facets_, t);
  }
  const int v = triangle(t)[static_cast<std::size_t>(i)];
  Vec3 sum = Vec3::Zero();
  for (const FacetGroup::Facet& f : group.facets) {
    const auto& corners = triangle(f.triangle);
    const auto at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    if (at == 3) continue;
    const SmoothPatch q = facets_.patch(f.triangle);
    const std::size_t j = (at + 1) % 3;
    const std::size_t k = (at + 2) % 3;
    const Vec3 e = q.p[j] - q.p[at] + q.c[at];
    const Vec3 g = q.p[k] - q.p[at] + q.c[k];
    const Vec3 m = e.cross(g);
    const double angle = std::atan2(m.norm(), e.dot(g));
    sum += angle * (q.flat() ? normals_.face(facets_, f.triangle) : Vec3(m.normalized()));
  }
  return sum;
}

bool MeshFacetGroups::through(const FacetGroup& group, const FacetSearch::Foot& foot, const Vec3& y) const {
  const int i = feature_index(foot.feature);
  const auto back = [&](int t, int edge) {
    const int u = normals_.neighbour(t, edge);
    return u >= 0 && !holds(group, u) && normals_.face(facets_, u).dot(y - foot.point) < 0;
  };
  if (foot.feature == Feature::face) return false;
  if (is_edge(foot.feature)) return back(foot.triangle, i);
  const int v = triangle(foot.triangle)[static_cast<std::size_t>(i)];
  for (const FacetGroup::Facet& f : group.facets) {
    const auto& corners = triangle(f.triangle);
    const int k = static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    if (k < 3 && (back(f.triangle, k) || back(f.triangle, (k + 2) % 3))) return true;
  }
  return false;
}

std::optional<MeshFacetGroups::Foot> MeshFacetGroups::nearest(const FacetGroup& group, const Vec3& y,
                                                              double within) const {
  NearestFacet best(facets_, tree_, y, within);
  // Start with the most promising facet, so that most others are out of reach.
  const FacetGroup::Facet* first = nullptr;
  double nearest_squared = std::numeric_limits<double>::infinity();
  for (const FacetGroup::Facet& f : group.facets)
    if (const double squared = (f.centre - y).squaredNorm(); squared < nearest_squared) {
      nearest_squared = squared;
      first = &f;
    }
  if (first) best.visit(first->triangle);
  for (const FacetGroup::Facet& f : group.facets) {
    const double far = best.reach + f.radius;
    if (&f != first && (f.centre - y).squaredNorm() <= far * far) best.offer(f.triangle);
  }
  const auto foot = best.foot();
  if (!foot) return std::nullopt;
  const Vec3 normal = pseudonormal(group, *foot);
  const bool flat = foot->feature == Feature::face && !facets_.curved(foot->triangle);
  const Vec3& on_facet = flat ? facets_.corner(foot->triangle, 0) : foot->point;
  return Foot{*foot, normal, normal.dot(y - on_facet) >= 0};
}

// Facets that may come within reach of the axis, sorted by triangle; empty if there is certainly one facet
// group.
std::vector<FacetGroup::Facet> MeshFacetGroups::around(std::span<const Vec3> axis, double reach) const {
  thread_local std::vector<Near> near;
  std::vector<FacetGroup::Facet> out;
  if (parallel(axis, reach, near) || bulging(near)) return out;
  for (const Near& f : near)
    if (!f.normal.isZero(0)) out.push_back(f);
  return out;
}

// True if the segment from p to q comes within reach of the axis.
bool MeshFacetGroups::within_reach(std::span<const Vec3> axis, double reach, const Vec3& p, const Vec3& q) {
  const Vec3 middle = 0.5 * (p + q);
  const double far = reach + 0.5 * (p - q).norm();
  return any_chord(axis, [&](const Vec3& a, const Vec3& b) {
    return squared_distance_to_segment(middle, a, b) <= far * far &&
           (squared_distance_to_segment(p, a, b) <= reach * reach ||
            squared_distance_to_segment(q, a, b) <= reach * reach ||
            closest_points_of_segments(a, b, p, q).distance <= reach);
  });
}

void MeshFacetGroups::join(std::span<const Vec3> axis, double reach,
                           const std::vector<FacetGroup::Facet>& facets, DisjointSets& sets) const {
  sets.reset(facets.size());
  for (int k = 0; k < static_cast<int>(facets.size()); ++k) {
    const int t = facets[static_cast<std::size_t>(k)].triangle;
    for (int e = 0; e < 3; ++e) {
      const int u = normals_.neighbour(t, e);
      const int l = u > t ? place_of(facets, u) : -1;
      if (l < 0 || sets.smallest(k) == sets.smallest(l) || cut(t, e, u)) continue;
      const Vec3& p = facets_.corner(t, e);
      const Vec3& q = facets_.corner(t, (e + 1) % 3);
      const double bent =
          facets_.curved(t) ? 0.25 * facets_.patch(t).c[static_cast<std::size_t>(e)].norm() : 0;
      if (within_reach(axis, reach + bent, p, q)) sets.unite(k, l);
    }
  }
}

struct MeshFacetGroups::Part {
  FacetGroup group;
  double distance = 0;  // m
  Vec3 direction;       // towards the nearest point of the axis
  bool back = false;    // the whole axis is behind it
};

// nearest: triangle of the nearest facet; from: the nearest point on the axis.
MeshFacetGroups::Part MeshFacetGroups::describe(FacetGroup group, int nearest, const Vec3& from,
                                                std::span<const Vec3> axis) const {
  Part part;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const auto foot = this->nearest(group, from, kFar);
  part.distance = std::sqrt(foot->foot.squared_distance);
  const Vec3 r = from - foot->foot.point;
  part.direction =
      foot->front && part.distance > 0 ? Vec3(r / part.distance) : foot->pseudonormal.normalized();
  if (part.direction.isZero(0)) part.direction = normals_.face(facets_, nearest);
  part.back = !foot->front;
  for (const Vec3& p : axis) part.back = part.back && !this->nearest(group, p, kFar)->front;
  part.group = std::move(group);
  return part;
}

// Facets that are connected within reach of the axis, and the nearest of them.
struct MeshFacetGroups::Connected {
  FacetGroup group;
  int nearest = -1;
  Approach at;
};

void MeshFacetGroups::find_nearest(std::span<const Vec3> axis, Connected& c) const {
  for (const FacetGroup::Facet& facet : c.group.facets)
    any_chord(axis, [&](const Vec3& p, const Vec3& q) {
      const double far = c.at.distance + facet.radius;
      if (squared_distance_to_segment(facet.centre, p, q) > far * far) return false;  // others are nearer
      const Approach a = approach(facet.triangle, p, q);
      if (a.distance < c.at.distance) {
        c.at = a;
        c.nearest = facet.triangle;
      }
      return c.at.distance == 0;  // none is nearer
    });
}

// Empty if all facets are connected.
std::vector<MeshFacetGroups::Connected> MeshFacetGroups::connected(std::span<const Vec3> axis,
                                                                   double reach) const {
  const std::vector<FacetGroup::Facet> facets = around(axis, reach);
  if (facets.size() < 2) return {};
  DisjointSets sets;
  join(axis, reach, facets, sets);
  int count = 0;
  const std::vector<int> number = sets.numbered(count);
  if (count < 2) return {};
  std::vector<Connected> out(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < facets.size(); ++k)
    out[static_cast<std::size_t>(number[k])].group.facets.push_back(facets[k]);
  for (Connected& c : out) find_nearest(axis, c);
  // Groups contain whole connected facets; groups that are out of reach are removed.
  std::erase_if(out, [&](const Connected& c) { return c.at.distance - bulge(c.nearest) > reach; });
  return out;
}

// Joins parts with nearly the same direction, and those behind which the whole axis is. parts: nearest first.
void MeshFacetGroups::merge_parallel(std::vector<Part> parts, FacetGroups& out) {
  const auto add = [](FacetGroup& to, const FacetGroup& from) {
    to.facets.insert(to.facets.end(), from.facets.begin(), from.facets.end());
  };
  std::vector<Part> facet_groups;
  FacetGroup backs;
  for (Part& p : parts) {
    if (p.back) {
      add(backs, p.group);
      continue;
    }
    const auto parallel =
        std::max_element(facet_groups.begin(), facet_groups.end(), [&](const Part& a, const Part& b) {
          return a.direction.dot(p.direction) < b.direction.dot(p.direction);
        });
    if (parallel != facet_groups.end() &&
        (parallel->direction.dot(p.direction) > kParallel ||
         static_cast<int>(facet_groups.size()) == FacetGroups::kMaxGroups - 1))
      add(parallel->group, p.group);
    else
      facet_groups.push_back(std::move(p));
  }
  if (facet_groups.size() < 2) return;
  for (Part& p : facet_groups) out.list.push_back(std::move(p.group));
  if (!backs.facets.empty()) out.list.push_back(std::move(backs));
  for (FacetGroup& w : out.list) std::ranges::sort(w.facets, {}, &FacetGroup::Facet::triangle);
}

void MeshFacetGroups::find(std::span<const Vec3> axis, double reach, FacetGroups& out) const {
  out.list.clear();
  std::vector<Connected> candidates = connected(axis, reach);
  if (candidates.size() < 2) return;
  std::vector<Part> parts;
  for (Connected& c : candidates) parts.push_back(describe(std::move(c.group), c.nearest, c.at.from, axis));
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.distance < b.distance; });
  parts.front().back = false;  // the nearest one can be touched from both sides
  merge_parallel(std::move(parts), out);
}

}  // namespace hawser::detail
