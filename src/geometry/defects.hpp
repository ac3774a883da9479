// Places of a mesh where the nearest facet does not determine the inside.
#pragma once

#include <vector>

#include "hawser/geometry/winding_tree.hpp"

namespace hawser::detail {

struct Defects {
  // Contains all edges of a hole, within the radius of a segment.
  struct Hole {
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double radius = 0;                     // m
    double distance(const Vec3& y) const;  // m, 0 within
    Box box() const {
      Box b{from, from};
      b.add(to);
      return b.grown(radius);
    }
  };
  // Facets near which the winding number decides; empty: none. These are facets at whose centre it does not
  // pass 1/2, facets near a hole, and facets where pieces may overlap.
  std::vector<bool> undecided;
  // Facets that must not be bent, because the winding number does not separate their sides: those at whose
  // centre it does not pass 1/2.
  std::vector<bool> straight;
  // Facets with the inside on both sides: walls within the body, and overlapping parts of bodies.
  std::vector<bool> internal;
  std::vector<Hole> holes;  // one for each connected set of hole edges
  int internal_facets = 0;
};

// Edges of a hole are those not used equally often in both directions. The surface that closes a hole lies in
// the convex hull of its edges, of which no point is farther from the edges than twice the radius of a `Hole`
// that contains them, or than half its extent. The line from a point to its nearest facet therefore passes
// through a hole only if the facet is that near to the hull; otherwise the hole's edge would be nearer.
// Facets within twice this distance are undecided.
Defects find_defects(const MeshView& mesh, const Topology& topo, const WindingTree& tree);

}  // namespace hawser::detail
