// Surfaces of primitives, and triangle meshes of them for pictures.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hawser/geometry/primitives.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

constexpr int kAround = 64;   // facets around an axis; the corners lie on the surface
constexpr int kQuarter = 12;  // facets per quarter circle of the profile
constexpr int kRim = 8;       // facets around the rim of a tube
constexpr double kPi = std::numbers::pi;

struct ProfilePoint {
  double rho, z;
};

// Revolves the profile about the axis through `origin`; outward if it runs from low to high z on the outside.
// Points with rho = 0 are poles. The last point of a closed profile is joined to the first.
TriangleMesh revolve(const std::vector<ProfilePoint>& profile, const Vec3& origin, const Vec3& axis,
                     bool closed) {
  const Vec3 ex = axis.unitOrthogonal();
  const Vec3 ey = axis.cross(ex);
  TriangleMesh m;
  std::vector<int> first;  // vertex of each profile point
  for (const ProfilePoint& p : profile) {
    first.push_back(static_cast<int>(m.vertices.size()));
    const int copies = p.rho > 0 ? kAround : 1;
    for (int i = 0; i < copies; ++i) {
      const double angle = 2 * kPi * i / kAround;
      m.vertices.push_back(origin + p.z * axis + p.rho * (std::cos(angle) * ex + std::sin(angle) * ey));
    }
  }
  const auto vertex = [&](std::size_t k, int i) { return first[k] + (profile[k].rho > 0 ? i % kAround : 0); };
  for (std::size_t k = 0; k + (closed ? 0 : 1) < profile.size(); ++k) {
    const std::size_t up = (k + 1) % profile.size();
    for (int i = 0; i < kAround; ++i) {
      const int a = vertex(k, i);
      const int b = vertex(k, i + 1);
      const int c = vertex(up, i + 1);
      const int d = vertex(up, i);
      if (a != b) m.triangles.push_back({a, b, c});
      if (c != d) m.triangles.push_back({a, c, d});
    }
  }
  return m;
}

// Points of a circle about (rho, z) from angle `from` to `to`, measured from the axis' downward direction.
void arc(std::vector<ProfilePoint>& profile, double rho, double z, double radius, double from, double to,
         int n) {
  for (int i = 0; i <= n; ++i) {
    const double angle = from + (to - from) * i / n;
    const bool pole = rho == 0 && (angle == 0 || angle == kPi);
    profile.push_back({pole ? 0 : rho + radius * std::sin(angle), z - radius * std::cos(angle)});
  }
}

TriangleMesh capsule(const Vec3& from, const Vec3& to, double radius) {
  const double length = (to - from).norm();
  const Vec3 axis = length > 0 ? Vec3((to - from) / length) : Vec3::UnitZ();
  std::vector<ProfilePoint> profile;
  arc(profile, 0, 0, radius, 0, kPi / 2, kQuarter);
  if (!(length > 0)) profile.pop_back();
  arc(profile, 0, length, radius, kPi / 2, kPi, kQuarter);
  return revolve(profile, from, axis, false);
}

// A circle about the axis of a tube.
struct Ring {
  Vec3 centre, ex, ey;
  double radius;
};

// Joins each ring to the next and the last to the first. Outward if rings outside go along ex × ey.
TriangleMesh joined(const std::vector<Ring>& rings) {
  TriangleMesh m;
  for (const Ring& r : rings)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * kPi * i / kAround;
      m.vertices.push_back(r.centre + r.radius * (std::cos(angle) * r.ex + std::sin(angle) * r.ey));
    }
  const int n = static_cast<int>(rings.size());
  const auto vertex = [&](int k, int i) { return kAround * (k % n) + i % kAround; };
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < kAround; ++i) {
      const int a = vertex(k, i);
      const int b = vertex(k, i + 1);
      const int c = vertex(k + 1, i + 1);
      const int d = vertex(k + 1, i);
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return m;
}

// Rings of the outside along the axis; the frame turns with the arcs and does not twist.
std::vector<Ring> along(const TubeShape& s) {
  const std::vector<TubePiece> pieces = tube_pieces(s);
  Vec3 ex = pieces.front().direction.unitOrthogonal();
  Vec3 ey = pieces.front().direction.cross(ex);
  std::vector<Ring> rings{{pieces.front().from, ex, ey, s.outer_radius()}};
  for (const TubePiece& p : pieces) {
    const int n = std::max(1, static_cast<int>(std::ceil(p.turn() * kAround / (2 * kPi))));
    const Vec3 ex0 = ex;
    const Vec3 ey0 = ey;
    for (int i = 1; i <= n; ++i) {
      if (p.arc()) {
        const Quat turn = exp_so3(p.turn() * i / n * p.axis());
        ex = turn * ex0;
        ey = turn * ey0;
      }
      rings.push_back({p.point(p.length * i / n), ex, ey, s.outer_radius()});
    }
  }
  return rings;
}

// Rings of a rim between two equal ends, from the outside (sign 1) or the bore (-1) over half a circle.
void rim(const Ring& end, const TubeShape& s, int sign, std::vector<Ring>& rings) {
  const Vec3 out = sign * end.ex.cross(end.ey);
  for (int i = 1; i < kRim; ++i) {
    const double angle = kPi * i / kRim;
    const double half = 0.5 * s.wall_thickness;
    rings.push_back({end.centre + half * std::sin(angle) * out, end.ex, end.ey,
                     s.middle_radius() + sign * half * std::cos(angle)});
  }
}

struct Facets {
  const Box& extent;

  TriangleMesh operator()(const PlaneShape& s) const {
    const Vec3 n = s.normal.stableNormalized();
    const Vec3 ex = n.unitOrthogonal();
    const Vec3 ey = n.cross(ex);
    const Vec3 middle =
        extent.empty() ? s.point : Vec3(extent.centre() - n.dot(extent.centre() - s.point) * n);
    const double half = extent.diagonal() > 0 ? 0.5 * extent.diagonal() : 1;
    TriangleMesh m;
    m.vertices = {middle + half * (-ex - ey), middle + half * (ex - ey), middle + half * (ex + ey),
                  middle + half * (ey - ex)};
    m.triangles = {{0, 1, 2}, {0, 2, 3}};
    return m;
  }
  TriangleMesh operator()(const BoxShape& s) const {
    const Quat turn = exp_so3(s.rotation);
    TriangleMesh m;
    for (int i = 0; i < 8; ++i) {
      const Vec3 side(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
      m.vertices.push_back(s.centre + turn * s.size.cwiseProduct(side));
    }
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
  }
  TriangleMesh operator()(const SphereShape& s) const { return capsule(s.centre, s.centre, s.radius); }
  TriangleMesh operator()(const CylinderShape& s) const {
    const double length = (s.to - s.from).norm();
    return revolve({{0, 0}, {s.radius, 0}, {s.radius, length}, {0, length}}, s.from, (s.to - s.from) / length,
                   false);
  }
  TriangleMesh operator()(const CapsuleShape& s) const { return capsule(s.from, s.to, s.radius); }
  TriangleMesh operator()(const TorusShape& s) const {
    std::vector<ProfilePoint> profile;
    arc(profile, s.radius, 0, s.tube_radius, 0, 2 * kPi, 2 * kQuarter);
    profile.pop_back();  // duplicate of the first point
    return revolve(profile, s.centre, s.axis.stableNormalized(), true);
  }
  TriangleMesh operator()(const TubeShape& s) const {
    const std::vector<Ring> outside = along(s);
    std::vector<Ring> rings = outside;
    rim(outside.back(), s, 1, rings);
    for (auto r = outside.rbegin(); r != outside.rend(); ++r) {
      rings.push_back(*r);
      rings.back().radius = s.inner_radius;
    }
    rim(outside.front(), s, -1, rings);
    return joined(rings);
  }
};

struct MakeSurface {
  using Result = std::shared_ptr<const Surface>;
  Result operator()(const PlaneShape& s) const { return std::make_shared<PlaneSurface>(s.point, s.normal); }
  Result operator()(const BoxShape& s) const { return std::make_shared<BoxSurface>(s); }
  Result operator()(const SphereShape& s) const { return std::make_shared<SphereSurface>(s); }
  Result operator()(const CylinderShape& s) const {
    return std::make_shared<CylinderSurface>(s.from, s.to, s.radius);
  }
  Result operator()(const CapsuleShape& s) const { return std::make_shared<CapsuleSurface>(s); }
  Result operator()(const TorusShape& s) const { return std::make_shared<TorusSurface>(s); }
  Result operator()(const TubeShape& s) const { return std::make_shared<TubeSurface>(s); }
};

}  // namespace

std::shared_ptr<const Surface> make_surface(const Primitive& shape) {
  return std::visit(MakeSurface{}, shape);
}

TriangleMesh facets(const Primitive& shape, const Box& extent) { return std::visit(Facets{extent}, shape); }

}  // namespace hawser
