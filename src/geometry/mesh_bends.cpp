// Sharp edges of a mesh, common normals of its smooth corners, and the bends of its facets from these.
#include "hawser/geometry/mesh_bends.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hawser/geometry/smooth_patch.hpp"
#include "hawser/math/disjoint_sets.hpp"
#include "planar_regions.hpp"

namespace hawser {
namespace {

constexpr double kWide = 4;  // planar regions whose widths differ by more do not belong to one curved surface
constexpr double kMaxBend = 0.5;  // fraction of the edge's length
constexpr int kNone = -1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Bends {
 public:
  Bends(const TriangleMesh& mesh, const Topology& topo, double crease_angle,
        const std::vector<bool>& straight)
      : mesh_(mesh), topo_(topo), straight_(straight), cosine_(std::cos(crease_angle)) {
    for (const auto& t : mesh.triangles)
      normal_.push_back(triangle_normal(vertex(t[0]), vertex(t[1]), vertex(t[2])));
  }

  MeshBends make() {
    number_edges();
    corner_normals();
    crease_tangents();
    MeshBends out;
    for (int e = 0; e < static_cast<int>(ends_.size()); ++e) bend_edge(e);
    unfold();
    collect(out);
    return out;
  }

 private:
  enum class Kind : char { smooth, sharp, straight };

  const Vec3& vertex(int v) const { return mesh_.vertices[at(v)]; }
  int corner_vertex(int t, int i) const { return mesh_.triangles[at(t)][at(i % 3)]; }
  // Edge of u that joins the same vertices as edge i of t.
  int edge_in(int u, int t, int i) const {
    const int a = corner_vertex(t, i);
    const int b = corner_vertex(t, i + 1);
    for (int k = 0; k < 3; ++k) {
      const int c = corner_vertex(u, k);
      const int d = corner_vertex(u, k + 1);
      if ((c == a && d == b) || (c == b && d == a)) return k;
    }
    return 0;
  }
  bool is_straight(int t) const { return !straight_.empty() && straight_[at(t)]; }

  void number_edges() {
    edge_.assign(mesh_.triangles.size(), {kNone, kNone, kNone});
    for (int t = 0; t < static_cast<int>(edge_.size()); ++t)
      for (int i = 0; i < 3; ++i) {
        if (edge_[at(t)][at(i)] != kNone) continue;
        const int e = static_cast<int>(ends_.size());
        const int u = topo_.neighbours[at(t)][at(i)];
        edge_[at(t)][at(i)] = e;
        ends_.push_back({corner_vertex(t, i), corner_vertex(t, i + 1)});
        home_.push_back(3 * t + i);
        kind_.push_back(Kind::straight);
        if (u < 0) continue;
        const int k = edge_in(u, t, i);
        edge_[at(u)][at(k)] = e;
        const bool agree = corner_vertex(u, k) == ends_.back()[1];
        const bool area = !normal_[at(t)].isZero(0) && !normal_[at(u)].isZero(0);
        if (!agree || !area || is_straight(t) || is_straight(u)) continue;
        kind_.back() = normal_[at(t)].dot(normal_[at(u)]) >= cosine_ ? Kind::smooth : Kind::sharp;
      }
    bend_.assign(ends_.size(), Vec3::Zero());
  }

  int root(int c) { return group_.smallest(c); }

  // Common normal of the corners at a vertex that smooth edges join; zero if unsuitable.
  void corner_normals() {
    group_.reset(3 * mesh_.triangles.size());
    for (int t = 0; t < static_cast<int>(edge_.size()); ++t)
      for (int i = 0; i < 3; ++i) {
        const int u = topo_.neighbours[at(t)][at(i)];
        if (u < t || kind_[at(edge_[at(t)][at(i)])] != Kind::smooth) continue;
        const int k = edge_in(u, t, i);
        group_.unite(3 * t + i, 3 * u + (k + 1) % 3);
        group_.unite(3 * t + (i + 1) % 3, 3 * u + k);
      }
    const std::vector<double> width = detail::planar_widths(mesh_, topo_, normal_);
    std::vector<double> widest(group_.size(), 0);
    for (int c = 0; c < static_cast<int>(group_.size()); ++c)
      widest[at(root(c))] = std::max(widest[at(root(c))], width[at(c / 3)]);
    group_normal_.assign(group_.size(), Vec3::Zero());
    for (int c = 0; c < static_cast<int>(group_.size()); ++c) {
      const int t = c / 3;
      const int i = c % 3;
      const int g = root(c);
      if (width[at(t)] * kWide < widest[at(g)]) continue;
      const Vec3 e = vertex(corner_vertex(t, i + 1)) - vertex(corner_vertex(t, i));
      const Vec3 f = vertex(corner_vertex(t, i + 2)) - vertex(corner_vertex(t, i));
      const double scale = e.squaredNorm() * f.squaredNorm();
      if (scale > 0) group_normal_[at(g)] += e.cross(f) / scale;
    }
    for (Vec3& n : group_normal_) n = n.squaredNorm() > 0 ? Vec3(n.normalized()) : n;
    // The tip of a cone has no tangent plane.
    std::vector<bool> tip(group_.size(), false);
    for (int c = 0; c < static_cast<int>(group_.size()); ++c)
      if (group_normal_[at(root(c))].dot(normal_[at(c / 3)]) < cosine_) tip[at(root(c))] = true;
    for (std::size_t g = 0; g < tip.size(); ++g)
      if (tip[g]) group_normal_[g].setZero();
  }

  // Tangent of a crease at each vertex through which it passes smoothly: that of the circle through the
  // vertex and its neighbours; along the longer edge if their lengths differ by more than kWide; zero at
  // corners.
  void crease_tangents() {
    std::vector<std::array<int, 2>> along(mesh_.vertices.size(), {kNone, kNone});
    std::vector<int> count(mesh_.vertices.size(), 0);
    for (int e = 0; e < static_cast<int>(ends_.size()); ++e) {
      if (kind_[at(e)] == Kind::smooth) continue;
      // A straight edge ends a crease, unless it belongs to a fold without area: there is no tangent in
      // either case.
      for (const int v : ends_[at(e)]) {
        if (count[at(v)] < 2) along[at(v)][at(count[at(v)])] = e;
        count[at(v)] += kind_[at(e)] == Kind::sharp ? 1 : 3;
      }
    }
    tangent_.assign(mesh_.vertices.size(), Vec3::Zero());
    for (int v = 0; v < static_cast<int>(tangent_.size()); ++v) {
      if (count[at(v)] != 2) continue;
      const auto other = [&](int e) { return ends_[at(e)][0] == v ? ends_[at(e)][1] : ends_[at(e)][0]; };
      const Vec3 a = vertex(v) - vertex(other(along[at(v)][0]));
      const Vec3 b = vertex(other(along[at(v)][1])) - vertex(v);
      const double la = a.norm();
      const double lb = b.norm();
      if (!(la > 0 && lb > 0) || a.dot(b) < cosine_ * la * lb) continue;
      Vec3 t = a / (la * la) + b / (lb * lb);
      if (la > kWide * lb) t = a;
      if (lb > kWide * la) t = b;
      tangent_[at(v)] = t.normalized();
    }
  }

  // Contribution of the end v of a crease edge to its bend; r: chord from v.
  Vec3 from_tangent(int v, const Vec3& r) const {
    const Vec3& t = tangent_[at(v)];
    const double along = t.dot(r);
    if (!(std::abs(along) > 0.5 * r.norm())) return Vec3::Zero();
    return 0.5 * (r.squaredNorm() / along * t - r);
  }

  void bend_edge(int e) {
    const int t = home_[at(e)] / 3;
    const int i = home_[at(e)] % 3;
    const int a = ends_[at(e)][0];
    const int b = ends_[at(e)][1];
    const Vec3 r = vertex(b) - vertex(a);
    Vec3 c = Vec3::Zero();
    if (kind_[at(e)] == Kind::sharp) {
      c = from_tangent(a, r) + from_tangent(b, -r);
    } else if (kind_[at(e)] == Kind::smooth) {
      Vec3 na = group_normal_[at(root(3 * t + i))];
      Vec3 nb = group_normal_[at(root(3 * t + (i + 1) % 3))];
      const bool has_a = !na.isZero(0);
      const bool has_b = !nb.isZero(0);
      if (!has_a && !has_b) return;
      const Vec3 edge_normal = (normal_[at(t)] + normal_[at(topo_.neighbours[at(t)][at(i)])]).normalized();
      const Vec3 m = ((has_a ? na : edge_normal) + (has_b ? nb : edge_normal)).normalized();
      if (has_a && m.dot(na) > 0.5) c -= 0.5 * r.dot(na) / m.dot(na) * m;
      if (has_b && m.dot(nb) > 0.5) c += 0.5 * r.dot(nb) / m.dot(nb) * m;
    }
    const double limit = kMaxBend * r.norm();
    const double size = c.norm();
    if (size > limit) c *= limit / size;
    // Rounding of the vertices of a flat place is no bend.
    if (size < 1e-9 * r.norm() || !c.allFinite()) c.setZero();
    bend_[at(e)] = c;
  }

  SmoothPatch patch(int t) const {
    SmoothPatch q;
    for (int i = 0; i < 3; ++i) {
      q.p[at(i)] = vertex(corner_vertex(t, i));
      q.c[at(i)] = bend_[at(edge_[at(t)][at(i)])];
    }
    return q;
  }

  // True if the normal, a quadratic polynomial of (u, v), stays within 60 degrees of the facet's and is not
  // too small, from its six Bernstein coefficients.
  bool sound(int t) const {
    const SmoothPatch q = patch(t);
    const Vec3& n = normal_[at(t)];
    if (q.flat()) return true;
    if (n.isZero(0)) return false;
    const Vec3 flat = (q.p[1] - q.p[0]).cross(q.p[2] - q.p[0]);
    const double uv[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    Vec3 a[3], b[3];
    for (int k = 0; k < 3; ++k) {
      a[k] = q.by_u(uv[k][0], uv[k][1]);
      b[k] = q.by_v(uv[k][0], uv[k][1]);
    }
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l) {
        const Vec3 N = 0.5 * (a[k].cross(b[l]) + a[l].cross(b[k]));
        if (!(N.dot(n) > 0.5 * N.norm() && N.dot(n) > 0.1 * flat.norm())) return false;
      }
    return true;
  }

  // Reduces the bends of triangles that would fold. An edge's bend is zero after the fourth reduction.
  void unfold() {
    std::vector<char> rounds(ends_.size(), 0);
    std::vector<int> todo(edge_.size());
    std::iota(todo.begin(), todo.end(), 0);
    while (!todo.empty()) {
      std::vector<int> next;
      for (const int t : todo) {
        if (sound(t)) continue;
        for (int i = 0; i < 3; ++i) {
          const int e = edge_[at(t)][at(i)];
          const int u = topo_.neighbours[at(t)][at(i)];
          if (bend_[at(e)].isZero(0)) continue;
          bend_[at(e)] *= ++rounds[at(e)] < 4 ? 0.5 : 0.0;
          if (u >= 0) next.push_back(u);
        }
        next.push_back(t);
      }
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      todo.swap(next);
    }
  }

  void collect(MeshBends& out) const {
    out.sharp = static_cast<int>(std::count(kind_.begin(), kind_.end(), Kind::sharp));
    out.edge_bends.resize(edge_.size());
    for (int t = 0; t < static_cast<int>(edge_.size()); ++t) {
      SmoothPatch q = patch(t);
      for (int i = 0; i < 3; ++i) {
        out.edge_bends[at(t)][at(i)] = q.c[at(i)].cast<float>();
        q.c[at(i)] = out.edge_bends[at(t)][at(i)].cast<double>();
      }
      out.curved += !q.flat();
      out.bulge = std::max(out.bulge, q.bulge());
    }
    if (out.curved == 0) out.edge_bends.clear();
  }

  const TriangleMesh& mesh_;
  const Topology& topo_;
  const std::vector<bool>& straight_;
  double cosine_;
  std::vector<Vec3> normal_;              // of faces, unit
  std::vector<std::array<int, 3>> edge_;  // index of each triangle's edges
  std::vector<std::array<int, 2>> ends_;  // vertices of each edge
  std::vector<int> home_;                 // 3 triangle + edge
  std::vector<Kind> kind_;
  std::vector<Vec3> bend_;
  DisjointSets group_;  // of corners 3 triangle + i
  std::vector<Vec3> group_normal_, tangent_;
};

}  // namespace

MeshBends mesh_bends(const TriangleMesh& mesh, const Topology& topo, double crease_angle,
                     const std::vector<bool>& straight) {
  return Bends(mesh, topo, crease_angle, straight).make();
}

}  // namespace hawser
