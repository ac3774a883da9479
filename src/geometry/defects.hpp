// Where on a mesh the nearest facet does not tell inside from outside.
#pragma once

#include <vector>

#include "hawser/geometry/winding_tree.hpp"

namespace hawser::detail {

struct Defects {
  // All within the radius of a segment.
  struct Hole {
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double radius = 0;                     // m
    double distance(const Vec3& y) const;  // m, 0 within
  };
  // Facets near which the winding number must be asked; empty: none. These are facets about whose middle it
  // does not pass 1/2, those by a hole, and those where pieces may overlap.
  std::vector<bool> unsure;
  // Those of them that are not to be bent, as w does not tell their sides apart: about whose middle it does
  // not pass 1/2. By a hole and where pieces overlap it does.
  std::vector<bool> straight;
  // Facets with the inside on both sides: walls within the body and parts of bodies that overlap.
  std::vector<bool> internal;
  // The boundary of the surface taken apart into closed ways, a thin one for each crack where it can be.
  std::vector<Hole> holes;
  int boundary_edges = 0, internal_facets = 0;
};

// Boundary edges are those that do not run equally often each way; they form closed ways, and the surface
// that closes one lies in its convex hull. A point of the hull is no farther from the way itself than the
// radius of any ball that holds it, and, where the way goes there and back along a crack, twice its width. So
// the line from a point to its nearest facet passes through a hole only if the facet is that near to the
// hull: else the hole's edge would be nearer. Facets within twice this are unsure.
Defects find_defects(const MeshView& mesh, const Topology& topo, const WindingTree& tree);

}  // namespace hawser::detail
