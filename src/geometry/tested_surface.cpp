#include "hawser/geometry/tested_surface.hpp"

#include <limits>
#include <stdexcept>

#include "hawser/geometry/point_in_polyhedron.hpp"

namespace hawser {

TestedSurface::TestedSurface(std::shared_ptr<const MeshSurface> mesh, SignBy test, bool partial)
    : mesh_(std::move(mesh)), test_(test), partial_(partial) {
  if (mesh_->curved() > 0) throw std::invalid_argument("a test of points in polyhedra needs flat facets");
  if (test_ == SignBy::winding) winding_ = WindingTree(mesh_->mesh());
}

std::optional<SurfacePoint> TestedSurface::query(const Vec3& y, double max_distance, int hint) const {
  Location where = Location::outside;
  if (mesh_->bounds().contains(y)) {
    const MeshView m = mesh_->mesh();
    if (test_ == SignBy::winding)
      where = winding_.inside(m, y) ? Location::inside : Location::outside;
    else
      where = locate(m, y,
                     test_ == SignBy::tetrahedra ? InsideTest::tetrahedra
                     : test_ == SignBy::ray      ? InsideTest::ray
                                                 : InsideTest::solid_angle);
  }
  // What is inside is met however deep; under an inactive part it is not.
  const bool deep = where == Location::inside && !partial_;
  auto p = mesh_->query(y, deep ? std::numeric_limits<double>::infinity() : max_distance, hint);
  if (!p || where == Location::boundary) return p;
  if ((where == Location::inside) != (p->distance < 0) && p->distance != 0)
    p->distance = -p->distance, p->normal = -p->normal, p->curvature = -p->curvature;
  if (p->distance > max_distance) return std::nullopt;
  return p;
}

}  // namespace hawser
