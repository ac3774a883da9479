// Extracts corners, sharp edges, pieces of faces and rings from a volume for contact of bodies, and the
// points at which the penetration of faces is monitored.
#include "hawser/terms/body_skeleton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "hawser/geometry/sharp_edges.hpp"
#include "hawser/geometry/tube_path.hpp"

namespace hawser {
namespace {

constexpr int kLeaf = 32;           // parts
constexpr int kMostPieces = 400;    // along a side of a triangle
constexpr double kSmall = 1.0 / 3;  // fraction of a piece: triangles without a larger error at one point
constexpr int kRing = 64;
constexpr double kWatched = 4000;  // points

using Triangle = std::array<Vec3, 3>;

Triangle corners(const MeshView& m, size_t t) { return {m.corner(t, 0), m.corner(t, 1), m.corner(t, 2)}; }

// Sharp edges of the active part, or their end points.
void sharp(const MeshView& m, const std::vector<bool>& active, bool edges, std::vector<SkeletonPart>& parts) {
  std::vector<char> corner(m.vertices.size(), 0);
  for (const auto& [first, second] : sharp_edges(m, active)) {
    const size_t a = first;
    const size_t b = second;
    if (edges) parts.push_back({m.vertices[a], m.vertices[b], 0, 1});
    corner[a] = corner[b] = 1;
  }
  for (size_t v = 0; v < corner.size() && !edges; ++v)
    if (corner[v]) parts.push_back(SkeletonPart::point(m.vertices[v]));
}

// Points of a rule on a triangle, all of equal weight, by their coordinates along two sides.
using TriangleRule = std::span<const std::array<double, 2>>;
constexpr std::array<double, 2> kCentre[] = {{1.0 / 3, 1.0 / 3}};
// Exact for polynomials of the second degree: Strang and Fix (1973), An Analysis of the Finite Element
// Method.
constexpr std::array<double, 2> kThree[] = {{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}};

double longest_side(const Triangle& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

// Points of the n² equal pieces of a triangle; sides of pieces are at most `piece` [m].
void faces(const Triangle& t, double piece, TriangleRule rule, std::vector<SkeletonPart>& points) {
  const double area = 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  if (!(area > 0)) return;
  const int n = std::clamp(static_cast<int>(std::ceil(longest_side(t) / piece)), 1, kMostPieces);
  const Vec3 u = (t[1] - t[0]) / n;
  const Vec3 v = (t[2] - t[0]) / n;
  const double weight = area / (n * n * static_cast<double>(rule.size()));
  const auto add = [&](const Vec3& corner, double side) {
    for (const auto& [a, b] : rule)
      points.push_back(SkeletonPart::point(corner + side * (a * u + b * v), 0, weight));
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add(t[0] + i * u + j * v, 1);
      if (i + j + 1 < n) add(t[0] + (i + 1) * u + (j + 1) * v, -1);
    }
}

void ring(const TorusShape& s, bool edges, std::vector<SkeletonPart>& parts) {
  const Vec3 axis = s.axis.normalized();
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  const auto at = [&](int i) {
    const double a = 2 * M_PI * (i % kRing) / kRing;
    return Vec3(s.centre + s.radius * (std::cos(a) * u + std::sin(a) * v));
  };
  for (int i = 0; i < kRing; ++i) parts.push_back({at(i), at(edges ? i + 1 : i), s.tube_radius, 1});
}

// The rims of a tube are rings of half the wall.
void rims(const TubeShape& s, bool edges, std::vector<SkeletonPart>& parts) {
  const TubePiece first = tube_pieces(s).front();
  const TubePiece last = tube_pieces(s).back();
  const double half = 0.5 * s.wall_thickness;
  ring({first.from, first.direction, s.middle_radius(), half}, edges, parts);
  ring({last.point(last.length), last.tangent(last.length), s.middle_radius(), half}, edges, parts);
}

}  // namespace

SkeletonParts::SkeletonParts(std::vector<SkeletonPart> parts) : parts_(std::move(parts)) {
  std::vector<Box> boxes;
  for (const SkeletonPart& p : parts_) {
    Box b{p.from, p.from};
    b.add(p.to);
    boxes.push_back(b.grown(p.radius));
  }
  tree_ = BoxTree(boxes, {}, kLeaf);
}

double face_piece(double size, double other) { return std::clamp(other / 5, size / 100, size / 25); }

BodySkeleton body_skeleton(const model::Volume& v, const MeshView& mesh, const std::vector<bool>& active,
                           double piece) {
  std::vector<SkeletonPart> parts;
  const auto* sphere = v.shape ? std::get_if<SphereShape>(&*v.shape) : nullptr;
  const auto* capsule = v.shape ? std::get_if<CapsuleShape>(&*v.shape) : nullptr;
  const auto* torus = v.shape ? std::get_if<TorusShape>(&*v.shape) : nullptr;
  const auto* tube = v.shape ? std::get_if<TubeShape>(&*v.shape) : nullptr;
  if (v.is_plane()) return {};
  if (v.basis == model::StiffnessBasis::per_area) {
    Box box;
    for (const Vec3& x : mesh.vertices) box.add(x);
    const double size = piece > 0 ? piece : face_piece((box.hi - box.lo).maxCoeff(), HUGE_VAL);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!active.empty() && !active[t]) continue;
      const Triangle triangle = corners(mesh, t);
      const bool small = longest_side(triangle) < kSmall * size;
      faces(triangle, size, small ? TriangleRule(kCentre) : kThree, parts);
    }
  } else {
    const bool edges = v.basis == model::StiffnessBasis::per_length;
    if (sphere) {
      if (!edges) parts.push_back(SkeletonPart::point(sphere->centre, sphere->radius));
    } else if (capsule) {
      if (edges)
        parts.push_back({capsule->from, capsule->to, capsule->radius, 1});
      else
        for (const Vec3& end : {capsule->from, capsule->to})
          parts.push_back(SkeletonPart::point(end, capsule->radius));
    } else if (torus) {
      ring(*torus, edges, parts);
    } else if (tube) {
      rims(*tube, edges, parts);
    } else {
      sharp(mesh, active, edges, parts);
    }
  }
  return {SkeletonParts(std::move(parts)), {}};
}

void watch_faces(const MeshView& mesh, const std::vector<bool>& active, BodySkeleton& skeleton) {
  double area = 0;
  const auto each = [&](const auto& visit) {
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
      if (active.empty() || active[t]) visit(corners(mesh, t));
  };
  each([&](const Triangle& t) { area += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm(); });
  if (!(area > 0)) return;
  // Of small triangles, only one point in each cell of the size of a piece is kept.
  const double piece = std::sqrt(area / kWatched);
  std::set<std::array<long, 3>> cells;
  std::vector<SkeletonPart> points, places;
  each([&](const Triangle& t) {
    points.clear();
    faces(t, piece, kCentre, points);
    for (const SkeletonPart& p : points) {
      const std::array<long, 3> cell{std::lround(p.from.x() / piece), std::lround(p.from.y() / piece),
                                     std::lround(p.from.z() / piece)};
      if (cells.insert(cell).second) places.push_back(p);
    }
  });
  skeleton.faces = SkeletonParts(std::move(places));
}

}  // namespace hawser
