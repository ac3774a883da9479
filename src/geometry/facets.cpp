// Nearest points of single facets, and search among many by the spatial hash or the tree of boxes.
#include "facets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace hawser::detail {
namespace {

// Search distance in cube sides beyond which the hash visits too many cubes.
constexpr double kNearBy = 3;

// True if a triangle is too flat for the short formula of the squared distance.
bool thin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double l2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > 1e-4 * l2);
}

// Barycentric coordinates (u, v) of the nearest point to the origin of a well-shaped triangle (Ericson 2005,
// 5.1.5), corners relative to the point.
std::array<double, 2> nearest_to_origin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = -ab.dot(a);
  const double d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return {0, 0};
  const double d3 = -ab.dot(b);
  const double d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
  const double d5 = -ab.dot(c);
  const double d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double v = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - v, v};
  }
  const double f = 1 / (va + vb + vc);
  return {vb * f, vc * f};
}

}  // namespace

Facets::Facets(const TriangleMesh& mesh, std::vector<std::array<Eigen::Vector3f, 3>> bends)
    : vertices_(mesh.vertices), triangles_(mesh.triangles), bends_(std::move(bends)) {
  std::vector<float> bulges;
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    thin_.push_back(thin(corner(t, 0), corner(t, 1), corner(t, 2)));
    if (any_curved()) bulges.push_back(static_cast<float>(patch(t).bulge() * (1 + 1e-6)));
  }
  bulges_ = std::move(bulges);
}

// A quadratic patch lies in the convex hull of its corners and of the edge midpoints moved by c / 2.
Box Facets::box(int t) const {
  Box b;
  const SmoothPatch q = patch(t);
  for (std::size_t i = 0; i < 3; ++i) {
    b.add(q.p[i]);
    if (any_curved()) b.add(Vec3(0.5 * (q.p[i] + q.p[(i + 1) % 3] + q.c[i])));
  }
  return b;
}

PatchPoint Facets::closest(int t, const Vec3& y) const {
  if (!bends_.empty()) {
    const SmoothPatch q = patch(t);
    if (!q.flat()) return closest_point_on_patch(y, q);
  }
  PatchPoint best;
  static_cast<ClosestPoint&>(best) = closest_point_on_triangle(y, corner(t, 0), corner(t, 1), corner(t, 2));
  return best;
}

// The direction r from the surface above the nearest point of the flat facet is nearly that to the nearest
// point of the facet, which makes the lower bound sharp.
DistanceBounds Facets::bounds(int t, const Vec3& y, double reach) const {
  const Vec3& a = corner(t, 0);
  const Vec3& b = corner(t, 1);
  const Vec3& c = corner(t, 2);
  if (thin_[static_cast<std::size_t>(t)]) {
    const double flat = std::sqrt(closest_point_on_triangle(y, a, b, c).squared_distance);
    return {flat - bulge(t), flat + bulge(t)};
  }
  const auto [u, v] = nearest_to_origin(a - y, b - y, c - y);
  const double flat = (y - a - u * (b - a) - v * (c - a)).norm();
  if (!any_curved()) return {flat, flat};
  if (flat - bulge(t) > reach) return {flat - bulge(t), flat + bulge(t)};
  const SmoothPatch q = patch(t);
  const Vec3 r = y - q.point(u, v);
  const double upper = r.norm();
  return {upper > 0 ? q.least(y, r) / upper : 0, upper};
}

FacetSearch::FacetSearch(const Facets& facets, const std::vector<bool>& chosen) : chosen_(chosen) {
  std::vector<Box> boxes;
  for (int t = 0; facets.has(t); ++t) boxes.push_back(facets.box(t));
  tree_ = BoxTree(boxes, chosen);
  if (!facets.any_curved()) hash_ = SpatialHash(boxes, chosen);
}

NearestFacet::NearestFacet(const Facets& facets, const BoxTree& tree, const Vec3& y, double max_distance)
    : facets_(facets),
      y_(y),
      rounding_(1e-12 * (y.cwiseAbs().maxCoeff() + tree.box().diagonal())),
      squared_(max_distance * max_distance) {
  limit(max_distance);
}

void NearestFacet::limit(double distance) {
  const double padded = (1 + 1e-9) * distance + rounding_;
  if (!(padded < reach)) return;
  reach = padded;
  squared_reach = reach * reach;
}

void NearestFacet::visit(int t) {
  const PatchPoint p = facets_.closest(t, y_);
  if (!(p.squared_distance <= squared_)) return;
  if (p.squared_distance == squared_ && foot_ && t > foot_->triangle) return;
  foot_ = Foot{p, t};
  squared_ = p.squared_distance;
  limit(std::sqrt(squared_));
}

void NearestFacet::offer(int t) {
  const DistanceBounds bounds = facets_.bounds(t, y_, reach);
  if (bounds.lower > reach) return;
  if (count_ == waiting_.size()) settle();
  waiting_[count_++] = {t, bounds};
  limit(bounds.upper);
}

// The facet that is probably the nearest comes first, because then most others are out of reach.
void NearestFacet::settle() {
  const auto waiting = std::span(waiting_).first(count_);
  count_ = 0;
  const auto first = std::ranges::min_element(waiting, {}, [](const Waiting& w) { return w.bounds.upper; });
  if (first != waiting.end()) std::swap(*first, waiting.front());
  for (const Waiting& w : waiting)
    if (!(w.bounds.lower > reach)) visit(w.triangle);
}

std::optional<NearestFacet::Foot> NearestFacet::foot() {
  settle();
  return foot_;
}

std::optional<FacetSearch::Foot> FacetSearch::nearest(const Facets& facets, const Vec3& y,
                                                      double max_distance, int hint) const {
  if (!y.allFinite() || !(max_distance >= 0)) return std::nullopt;
  NearestFacet best(facets, tree_, y, max_distance);
  const bool hinted = facets.has(hint) && (chosen_.empty() || chosen_[static_cast<std::size_t>(hint)]);
  if (hinted) best.visit(hint);
  const auto offer = [&](int t) {
    if (!hinted || t != hint) best.offer(t);
  };
  if (!hash_.empty() && best.squared_reach <= std::pow(kNearBy * hash_.side(), 2))
    hash_.nearest(y, best.squared_reach, offer);
  else
    tree_.nearest(y, best.squared_reach, offer);
  return best.foot();
}

std::optional<FacetSearch::Foot> FacetSearch::nearest(const Facets& facets, const Vec3& y,
                                                      const NearFacets& near) const {
  const double moved = (y - near.place).norm();
  NearestFacet best(facets, tree_, y, std::numeric_limits<double>::infinity());
  if (near.count > 0) best.visit(near.facets[0].triangle);
  for (std::size_t i = 1; i < near.count; ++i) {
    if (near.facets[i].lower_bound - moved > best.reach) return best.foot();
    best.offer(near.facets[i].triangle);
  }
  const auto foot = best.foot();
  return near.others - moved > best.reach ? foot : std::nullopt;
}

NearFacets FacetSearch::about(const Facets& facets, const Vec3& place) const {
  NearFacets near(place);
  double squared = std::numeric_limits<double>::infinity();
  tree_.nearest(place, squared, [&](int t) {
    const double lower = facets.bounds(t, place, near.others).lower;
    if (lower > near.others) return;
    near.add({t, lower});
    squared = near.others * near.others;
  });
  return near;
}

}  // namespace hawser::detail
