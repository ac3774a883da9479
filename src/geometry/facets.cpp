// Nearest points of single facets, and search among many by the spatial hash or the tree of boxes.
#include "facets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

// Squared distance of the origin from a well-shaped triangle (Ericson 2005, 5.1.5), corners relative to the
// point.
double squared_distance_to(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = -ab.dot(a);
  const double d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return a.squaredNorm();
  const double d3 = -ab.dot(b);
  const double d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return b.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (a + d1 / (d1 - d3) * ab).squaredNorm();
  const double d5 = -ab.dot(c);
  const double d6 = -ac.dot(c);
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

double Facets::squared_distance(int t, const Vec3& y) const {
  const Vec3& a = corner(t, 0);
  const Vec3& b = corner(t, 1);
  const Vec3& c = corner(t, 2);
  return thin_[static_cast<std::size_t>(t)] ? closest_point_on_triangle(y, a, b, c).squared_distance
                                            : squared_distance_to(a - y, b - y, c - y);
}

// Beyond a centre of curvature of a patch the point found may be a local minimum.
double Facets::least_distance(int t, const Vec3& y) const {
  if (!curved(t) || one_nearest_point(y, patch(t))) return std::sqrt(closest(t, y).squared_distance);
  return distance_less_bulge(t, y);
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
      squared(max_distance * max_distance),
      reach(padded()) {}

void NearestFacet::visit(int t) {
  if ((foot && t == foot->triangle) || !facets_.may_reach(t, y_, reach)) return;
  const PatchPoint p = facets_.closest(t, y_);
  if (!(p.squared_distance <= squared)) return;
  if (p.squared_distance == squared && foot && t > foot->triangle) return;
  foot = Foot{p, t};
  squared = p.squared_distance;
  reach = padded();
}

double NearestFacet::padded() const { return (1 + 1e-9) * std::sqrt(squared) + rounding_; }

std::optional<FacetSearch::Foot> FacetSearch::nearest(const Facets& facets, const Vec3& y,
                                                      double max_distance, int hint) const {
  if (!y.allFinite() || !(max_distance >= 0)) return std::nullopt;
  NearestFacet best(facets, tree_, y, max_distance);
  const auto visit = [&](int t) { best.visit(t); };
  if (facets.has(hint) && (chosen_.empty() || chosen_[static_cast<std::size_t>(hint)])) visit(hint);
  if (!hash_.empty() && best.squared <= std::pow(kNearBy * hash_.side(), 2))
    hash_.nearest(y, best.squared, visit);
  else
    tree_.nearest(y, best.squared, visit);
  return best.foot;
}

std::optional<FacetSearch::Foot> FacetSearch::nearest(const Facets& facets, const Vec3& y,
                                                      const NearFacets& near) const {
  const double moved = (y - near.place).norm();
  NearestFacet best(facets, tree_, y, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < near.count; ++i) {
    if (near.facets[i].lower_bound - moved > best.reach) return best.foot;
    best.visit(near.facets[i].triangle);
  }
  return near.others - moved > best.reach ? best.foot : std::nullopt;
}

NearFacets FacetSearch::about(const Facets& facets, const Vec3& place) const {
  NearFacets near(place);
  double squared = std::numeric_limits<double>::infinity();
  tree_.nearest(place, squared, [&](int t) {
    if (!facets.may_reach(t, place, near.others)) return;
    near.add({t, facets.least_distance(t, place)});
    squared = near.others * near.others;
  });
  return near;
}

}  // namespace hawser::detail
