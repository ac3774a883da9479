// Sign of the distance to a mesh from a point-in-polyhedron test or the winding number.
#include "hawser/geometry/tested_surface.hpp"

#include <limits>
#include <stdexcept>

#include "hawser/geometry/point_in_polyhedron.hpp"

namespace hawser {

TestedSurface::TestedSurface(std::shared_ptr<const MeshSurface> mesh, SignTest test, bool partial)
    : mesh_(std::move(mesh)), test_(test), partial_(partial) {
  if (mesh_->curved() > 0) throw std::invalid_argument("a test of points in polyhedra needs flat facets");
  if (test_ == SignTest::winding) winding_ = WindingTree(mesh_->mesh());
}

bool TestedSurface::inside(const Vec3& y) const {
  if (!mesh_->bounds().contains(y)) return false;
  const MeshView m = mesh_->mesh();
  switch (test_) {
    case SignTest::tetrahedra:
      return inside_by_tetrahedra(m, y);
    case SignTest::ray:
      return inside_by_ray(m, y);
    case SignTest::solid_angle:
      return inside_by_solid_angle(m, y);
    default:
      return winding_.inside(m, y);
  }
}

std::optional<SurfacePoint> TestedSurface::query(const Vec3& y, double max_distance, int hint) const {
  const bool is_inside = inside(y);
  // A point inside is found at any depth, except below an inactive part.
  const bool deep = is_inside && !partial_;
  auto p = mesh_->query(y, deep ? std::numeric_limits<double>::infinity() : max_distance, hint);
  if (!p) return p;
  if (is_inside != (p->distance < 0) && p->distance != 0) {
    p->distance = -p->distance;
    p->normal = -p->normal;
    p->curvature = -p->curvature;
  }
  if (p->distance > max_distance) return std::nullopt;
  return p;
}

}  // namespace hawser
