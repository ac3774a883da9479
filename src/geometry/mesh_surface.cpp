// Signed distance to a mesh: sign by pseudonormals or the winding number, and normal and curvature on facets,
// edges and corners.
#include "hawser/geometry/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "defects.hpp"
#include "hawser/geometry/packing.hpp"
#include "hawser/geometry/winding_tree.hpp"
#include "mesh_facet_groups.hpp"
#include "pseudonormals.hpp"

namespace hawser {

using detail::Facets;
using detail::FacetSearch;

namespace {
// Sine below which directions count as parallel or perpendicular. Smaller kinks come from rounded coordinates
// in files (single precision over facets of a hundredth of the mesh, micrometres over facets of 0.5 m). The
// Hessian 1/d of such an edge would be that of a strip no wider than 1e-5 d.
constexpr double kSquare = 1e-5;
}  // namespace

struct MeshSurface::Data {
  std::shared_ptr<const std::byte> keep;  // owner of the arrays, if external
  Facets facets;
  detail::Pseudonormals normals;
  FacetSearch active, all_facets;  // all_facets: empty if all facets are active
  bool partial = false;
  std::vector<bool> is_active;      // if partial
  std::vector<bool> border_vertex;  // if partial: touches active and inactive triangles
  ConstArray<detail::Defects::Hole> holes;
  BoxTree hole_tree;  // of boxes around them
  Box bounds;
  double small = 0;             // m, 1e-6 of the mesh: shorter lengths count as round-off
  WindingTree winding;          // built only if defects or undefined pseudonormals need it
  std::vector<bool> undecided;  // facets near which the winding number decides; empty: none
  int curved = 0, sharp = 0, internal = 0;
  double bulge = 0;
  bool one_group = false;  // convex: one facet group everywhere

  template <class Self, class P>
  static void pack(Self& self, P& p) {
    Facets::pack(self.facets, p);
    detail::Pseudonormals::pack(self.normals, p);
    FacetSearch::pack(self.active, p);
    FacetSearch::pack(self.all_facets, p);
    p.value(self.partial);
    p.flags(self.is_active);
    p.flags(self.border_vertex);
    p.array(self.holes);
    BoxTree::pack(self.hole_tree, p);
    p.value(self.bounds);
    p.value(self.small);
    WindingTree::pack(self.winding, p);
    p.flags(self.undecided);
    p.value(self.curved);
    p.value(self.sharp);
    p.value(self.internal);
    p.value(self.bulge);
    p.value(self.one_group);
  }
  detail::MeshFacetGroups facet_groups() const { return {facets, normals, active.tree()}; }
  MeshView mesh() const { return facets.mesh(); }
  std::optional<FacetSearch::Foot> nearest(const FacetSearch& among, const Vec3& y, double max_distance,
                                           int hint) const {
    const auto foot = among.nearest(facets, y, max_distance, hint);
    return foot ? std::optional(on_face_or_edge(*foot, y)) : std::nullopt;
  }
  FacetSearch::Foot on_face_or_edge(FacetSearch::Foot best, const Vec3& y) const {
    const int t = best.triangle;
    if (best.feature != Feature::face || normals.has_area(facets, t)) return best;
    // Without area it has no face: the nearest of its edges.
    for (int i = 0; i < 3; ++i) {
      ClosestPoint c = closest_point_on_segment(y, facets.corner(t, i), facets.corner(t, (i + 1) % 3));
      if (i > 0 && !(c.squared_distance < best.squared_distance)) continue;
      c.feature =
          c.feature == Feature::edge0 ? edge_feature(i) : vertex_feature((i + feature_index(c.feature)) % 3);
      static_cast<ClosestPoint&>(best) = c;
    }
    return best;
  }
  // Lower bound, m, of the distance from y to places where the body begins without an active facet: in a
  // hole, or at an inactive part, behind which it is negative. Searches up to `max_distance`.
  double distance_to_closure(const Vec3& y, double max_distance, int hint) const;
  std::optional<SurfacePoint> query_foot(const Vec3& y, double max_distance,
                                         const FacetSearch::Foot& c) const;
  SurfacePoint point_at(const Vec3& y, const FacetSearch::Foot& c, const Vec3& pseudonormal,
                        bool behind) const;
  Mat3 curvature_at_vertex(int triangle, int corner, double length, const SurfacePoint& s) const;
  // True if y is behind the surface at its closest point c with this pseudonormal.
  bool behind(const FacetSearch::Foot& c, const Vec3& y, const Vec3& pseudonormal) const {
    if (!undecided.empty() && undecided[static_cast<std::size_t>(c.triangle)])
      return winding.inside(mesh(), over_flat(c, y));
    if (c.feature == Feature::face && !facets.curved(c.triangle))
      return pseudonormal.dot(y - facets.corner(c.triangle, 0)) < 0;
    if (pseudonormal.isZero(0)) return winding.inside(mesh(), y);
    return pseudonormal.dot(y - c.point) < 0;
  }
  // Moves y by the offset between the curved facet and the flat one, which the winding number uses. Farther
  // away than facets bulge, y is on the same side of both.
  Vec3 over_flat(const FacetSearch::Foot& c, const Vec3& y) const {
    if (!facets.curved(c.triangle) || c.squared_distance > bulge * bulge) return y;
    const Vec3& p0 = facets.corner(c.triangle, 0);
    const Vec3& p1 = facets.corner(c.triangle, 1);
    const Vec3& p2 = facets.corner(c.triangle, 2);
    return y - (c.point - (p0 + c.u * (p1 - p0) + c.v * (p2 - p0)));
  }
  bool inside_all_facets(const Vec3& y, double bound, int hint) const {
    const auto c = nearest(all_facets, y, bound, hint);
    return c && behind(*c, y, normals.at(facets, c->triangle, *c));  // `hint` is within the bound
  }
  // True if a point behind the border of the active part lies below an active face, to within 45 degrees.
  bool under_active(const FacetSearch::Foot& c, const Vec3& y) const;
};

bool MeshSurface::Data::under_active(const FacetSearch::Foot& c, const Vec3& y) const {
  const int t = c.triangle;
  const int i = feature_index(c.feature);
  const auto& tri = mesh().triangles[static_cast<std::size_t>(t)];
  bool border = false;
  if (is_vertex(c.feature)) {
    border = border_vertex[static_cast<std::size_t>(tri[static_cast<std::size_t>(i)])];
  } else if (is_edge(c.feature)) {
    const int other = normals.neighbour(t, i);
    border = other < 0 || !is_active[static_cast<std::size_t>(other)];
  }
  if (!border) return true;
  const Vec3 r = y - c.point;
  return -normals.face(facets, t).dot(r) >= std::sqrt(0.5) * r.norm();
}

MeshSurface::MeshSurface(TriangleMesh mesh, std::vector<bool> active, MeshSurfaceOptions options) {
  const Topology topo = topology(mesh);
  const auto refuse = [](const std::string& why) {
    throw std::invalid_argument("the mesh has no inside: " + why);
  };
  if (mesh.triangles.empty()) refuse("it is empty");
  const bool open = topo.odd_edges > 0 || topo.flipped_edges > 0;
  if (!options.open && topo.odd_edges > 0) refuse(std::to_string(topo.odd_edges) + " edges are open");
  if (!options.open && topo.flipped_edges > 0)
    refuse(std::to_string(topo.flipped_edges) + " edges lie between triangles of opposite orientation");
  if (!active.empty() && active.size() != mesh.triangles.size())
    throw std::invalid_argument("the active part has " + std::to_string(active.size()) + " flags for " +
                                std::to_string(mesh.triangles.size()) + " triangles");
  if (std::find(active.begin(), active.end(), false) == active.end()) active.clear();
  if (!active.empty() && std::find(active.begin(), active.end(), true) == active.end())
    throw std::invalid_argument("no triangle of the mesh is active");

  auto data = std::make_unique<Data>();
  Data& d = *data;
  detail::Defects defects;
  if (open || topo.components > 1) {
    d.winding = WindingTree(mesh);
    defects = detail::find_defects(mesh, topo, d.winding);
    d.internal = defects.internal_facets;
  }
  MeshBends bends;
  if (options.smooth) bends = mesh_bends(mesh, topo, options.crease_angle, defects.straight);
  d.curved = bends.curved;
  d.sharp = bends.sharp;
  d.bulge = bends.bulge;
  d.facets = Facets(mesh, std::move(bends.edge_bends));
  mesh = {};
  d.normals = detail::Pseudonormals(d.facets, topo);
  if (d.winding.empty() && !d.normals.complete()) d.winding = WindingTree(d.mesh());
  d.undecided = std::move(defects.undecided);
  // Internal facets are not part of the surface; `outer_active`: active facets that are.
  std::vector<bool> outer;
  std::vector<bool> outer_active = active;
  if (d.internal > 0) {
    outer = std::move(defects.internal);
    outer.flip();
    if (outer_active.empty()) outer_active.assign(outer.size(), true);
    for (std::size_t t = 0; t < outer_active.size(); ++t) outer_active[t] = outer_active[t] && outer[t];
    if (std::find(outer_active.begin(), outer_active.end(), true) == outer_active.end())
      throw std::invalid_argument("the active part of the mesh lies all within the body");
  }
  d.active = FacetSearch(d.facets, outer_active);
  d.partial = !active.empty();
  d.one_group = detail::MeshFacetGroups::convex(d.facets, d.normals, topo.components);
  if (d.partial) {
    d.all_facets = FacetSearch(d.facets, outer);
    d.border_vertex.assign(d.mesh().vertices.size(), false);
    std::vector<int> touched(d.mesh().vertices.size(), 0);
    for (std::size_t t = 0; t < active.size(); ++t)
      for (const int v : d.mesh().triangles[t]) touched[static_cast<std::size_t>(v)] |= active[t] ? 1 : 2;
    for (std::size_t v = 0; v < touched.size(); ++v) d.border_vertex[v] = touched[v] == 3;
  }
  d.is_active = std::move(active);
  d.bounds = (d.partial ? d.all_facets : d.active).tree().box();
  d.small = 1e-6 * d.bounds.extent().maxCoeff();
  if (!std::isfinite(d.bounds.extent().squaredNorm()))
    throw std::invalid_argument("the mesh is too large: squares of its lengths overflow");
  std::vector<Box> boxes;
  for (const auto& hole : defects.holes) boxes.push_back(hole.box());
  d.hole_tree = BoxTree(boxes);
  d.holes = std::move(defects.holes);
  data_ = std::move(data);
}

MeshSurface::MeshSurface(std::shared_ptr<const std::byte> keep) {
  auto data = std::make_unique<Data>();
  packing::Reader from(keep.get());
  Data::pack(*data, from);
  data->keep = std::move(keep);
  data_ = std::move(data);
}

std::size_t MeshSurface::packed_size() const {
  packing::Measure m;
  Data::pack(*data_, m);
  return m.size();
}

void MeshSurface::write(std::byte* to) const {
  packing::Writer w(to);
  Data::pack(*data_, w);
}

MeshSurface::~MeshSurface() = default;
MeshSurface::MeshSurface(MeshSurface&&) noexcept = default;
MeshSurface& MeshSurface::operator=(MeshSurface&&) noexcept = default;

std::optional<SurfacePoint> MeshSurface::query(const Vec3& y, double max_distance, int hint) const {
  const Data& d = *data_;
  if (distance(d.bounds, y) > max_distance) return std::nullopt;
  auto foot = d.nearest(d.active, y, max_distance, hint);
  // Points inside are found at any depth.
  if (!foot && d.bounds.contains(y) && (d.winding.empty() || d.winding.inside(d.mesh(), y)))
    foot = d.nearest(d.active, y, std::numeric_limits<double>::infinity(), hint);
  return foot ? d.query_foot(y, max_distance, *foot) : std::nullopt;
}

std::optional<SurfacePoint> MeshSurface::query_again(const Vec3& y, double max_distance, int hint,
                                                     NearFacets& near) const {
  const Data& d = *data_;
  if (distance(d.bounds, y) > max_distance) return std::nullopt;
  auto foot = d.active.nearest(d.facets, y, near);
  if (!foot) {
    near = d.active.about(d.facets, y);
    foot = d.active.nearest(d.facets, y, near);
  }
  if (!foot || !(foot->squared_distance <= max_distance * max_distance)) return query(y, max_distance, hint);
  return d.query_foot(y, max_distance, d.on_face_or_edge(*foot, y));
}

// Result of a query for y from its nearest point c.
std::optional<SurfacePoint> MeshSurface::Data::query_foot(const Vec3& y, double max_distance,
                                                          const FacetSearch::Foot& c) const {
  const int t = c.triangle;
  const Vec3 pseudonormal = normals.at(facets, t, c);
  const bool is_behind = behind(c, y, pseudonormal);
  const double length = std::sqrt(c.squared_distance);
  if (!is_behind && length > max_distance) return std::nullopt;
  if (is_behind && partial &&
      (!inside_all_facets(y, length * (1 + 1e-6) + 1e-3 * small, t) || !under_active(c, y)))
    return std::nullopt;
  return point_at(y, c, pseudonormal, is_behind);
}

SurfacePoint MeshSurface::Data::point_at(const Vec3& y, const FacetSearch::Foot& c, const Vec3& pseudonormal,
                                         bool behind) const {
  const Data& d = *this;
  const int t = c.triangle;
  const bool bent = d.facets.curved(t);
  const Vec3 r = y - c.point;
  const double length = std::sqrt(c.squared_distance);
  SurfacePoint s;
  s.point = c.point;
  s.triangle = t;
  s.feature = c.feature;
  if (c.feature == Feature::face) {
    s.normal = pseudonormal;
    s.distance = s.normal.dot(y - (bent ? c.point : d.facets.corner(t, 0)));
    if ((s.distance < 0) != behind && s.distance != 0) {  // a facet that faces the inside, in an invalid mesh
      s.normal = -s.normal;
      s.distance = -s.distance;
    }
    if (bent) s.curvature = curvature_over_patch(d.facets.patch(t), c.u, c.v, s.normal, s.distance);
    return s;
  }
  s.distance = behind ? -length : length;
  // The direction of r is round-off here; any normal between those of the faces is valid.
  if (length > 1e-4 * d.small)
    s.normal = (behind ? -1 : 1) * r.normalized();
  else
    s.normal = pseudonormal.isZero(0) ? d.normals.face(d.facets, t) : pseudonormal.normalized();
  if (is_edge(c.feature)) {
    const int i = feature_index(c.feature);
    const double at = i == 0 ? c.u : i == 1 ? c.v : 1 - c.v;
    const SmoothPatch patch = d.facets.patch(t);
    const auto parallel = [&](const Vec3& v) { return v.cross(s.normal).norm() <= kSquare * v.norm(); };
    // Coplanar facets have no edge: the distance is that from the plane.
    s.curvature = parallel(patch.normal(c.u, c.v)) && parallel(pseudonormal)
                      ? curvature_over_patch(patch, c.u, c.v, s.normal, s.distance)
                      : curvature_over_edge(patch, i, at, s.normal, s.distance, d.small);
  } else {
    s.curvature = curvature_at_vertex(t, feature_index(c.feature), length, s);
  }
  return s;
}

// Hessian of the distance for a nearest point at a vertex. In general the distance is that from the vertex.
// If an edge at the vertex is perpendicular to s.normal, as where the vertex divides a straight edge, it is
// that from the edge; if two such edges are not parallel, that from the facet where the walk around the
// vertex meets the second of them (the same for all flat facets). The walk ends at the border of an open
// mesh.
Mat3 MeshSurface::Data::curvature_at_vertex(int first, int corner, double length,
                                            const SurfacePoint& s) const {
  constexpr int kMaxFacets = 64;  // facets about a vertex
  const auto index = [&](int t, int i) {
    return mesh().triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)];
  };
  const int vertex = index(first, corner);
  std::optional<Vec3> along;
  Mat3 curvature = Mat3::Zero();
  int t = first;
  int v = corner;
  for (int n = 0; n < kMaxFacets; ++n) {
    const SmoothPatch patch = facets.patch(t);
    const auto from = static_cast<std::size_t>(v);
    const auto to = static_cast<std::size_t>((v + 1) % 3);
    const Vec3 tangent = (patch.p[to] - patch.p[from] + patch.c[from]).normalized();
    if (std::abs(tangent.dot(s.normal)) <= kSquare) {
      if (along && along->cross(tangent).norm() > kSquare) {
        const auto at = on_edge(v, 0);
        return curvature_over_patch(patch, at[0], at[1], s.normal, s.distance);
      }
      if (!along) curvature = curvature_over_edge(patch, v, 0, s.normal, s.distance, small);
      along = tangent;
    }
    t = normals.neighbour(t, (v + 2) % 3);
    if (t < 0 || t == first) break;
    v = 0;
    while (v < 2 && index(t, v) != vertex) ++v;
  }
  if (along) return curvature;
  return (Mat3::Identity() - s.normal * s.normal.transpose()) /
         std::copysign(std::max(length, small), s.distance);
}

double MeshSurface::free_radius(const Vec3& y, double distance, int hint) const {
  if (!(distance > 0)) return distance;
  const Facets& facets = data_->facets;
  double squared = distance * distance;
  const auto visit = [&](int t) {
    if (!facets.curved(t)) return;
    const double lower = std::max(0.0, facets.bounds(t, y, std::sqrt(squared)).lower);
    if (lower * lower < squared && !one_nearest_point(y, facets.patch(t))) squared = lower * lower;
  };
  if (facets.any_curved()) data_->active.tree().nearest(y, squared, visit);
  return data_->distance_to_closure(y, std::sqrt(squared), hint);
}

double MeshSurface::Data::distance_to_closure(const Vec3& y, double max_distance, int hint) const {
  if (partial) {
    const auto c = nearest(all_facets, y, max_distance, hint);
    if (!c) return max_distance;
    const double away = std::sqrt(c->squared_distance);
    return behind(*c, y, normals.at(facets, c->triangle, *c)) ? -away : away;
  }
  double squared = max_distance * max_distance;
  hole_tree.nearest(y, squared, [&](int i) {
    const double away = holes[static_cast<std::size_t>(i)].distance(y);
    squared = std::min(squared, away * away);
  });
  return std::sqrt(squared);
}

void MeshSurface::facet_groups(std::span<const Vec3> axis, double reach, FacetGroups& out) const {
  out.list.clear();
  if (!data_->one_group) data_->facet_groups().find(axis, reach, out);
}

bool MeshSurface::one_facet_group(std::span<const Vec3> axis, double reach) const {
  if (data_->one_group) return true;
  return reach < data_->bounds.diagonal() && data_->facet_groups().one(axis, reach);
}

std::optional<SurfacePoint> MeshSurface::query_group(const FacetGroup& group, const Vec3& y,
                                                     double max_distance, bool either_side) const {
  const auto near = data_->facet_groups().nearest(group, y, max_distance);
  const bool front = near && near->front;
  if (near && (either_side || (front && !data_->facet_groups().through(group, near->foot, y))))
    return data_->point_at(y, near->foot, near->pseudonormal, !front);
  if (!near && !data_->bounds.contains(y)) return std::nullopt;
  auto all = query(y, max_distance, near ? near->foot.triangle : -1);
  if (!all || all->distance > 0) return std::nullopt;
  if (front) return data_->point_at(y, near->foot, near->pseudonormal, false);
  if (!detail::MeshFacetGroups::holds(group, all->triangle)) return std::nullopt;
  return all;
}

Box MeshSurface::bounds() const { return data_->bounds; }
MeshView MeshSurface::mesh() const { return data_->mesh(); }
SmoothPatch MeshSurface::patch(int triangle) const { return data_->facets.patch(triangle); }
int MeshSurface::curved() const { return data_->curved; }
int MeshSurface::sharp_edges() const { return data_->sharp; }
double MeshSurface::bulge() const { return data_->bulge; }
int MeshSurface::internal_facets() const { return data_->internal; }

std::vector<bool> active_by_part(const TriangleMesh& mesh, const std::vector<std::string>& names) {
  std::vector<bool> active(mesh.triangles.size(), false);
  for (std::size_t t = 0; t < mesh.part.size(); ++t)
    active[t] = std::find(names.begin(), names.end(), mesh.parts[static_cast<std::size_t>(mesh.part[t])]) !=
                names.end();
  return active;
}

std::vector<bool> active_by_box(const TriangleMesh& mesh, const Box& box) {
  std::vector<bool> active(mesh.triangles.size());
  for (std::size_t t = 0; t < active.size(); ++t)
    active[t] = std::all_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                            [&](int v) { return box.contains(mesh.vertices[static_cast<std::size_t>(v)]); });
  return active;
}

}  // namespace hawser
