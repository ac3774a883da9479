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
    Box box() const {
      Box b{from, from};
      b.add(to);
      return b.grown(radius);
    }
  };
  // Facets near which the winding number must be asked; empty: none. These are facets about whose middle it
  // does not pass 1/2, those by a hole, and those where pieces may overlap.
  std::vector<bool> undecided;
  // Those of them that are not to be bent, as w does not tell their sides apart: about whose middle it does
  // not pass 1/2. By a hole and where pieces overlap it does.
  std::vector<bool> straight;
  // Facets with the inside on both sides: walls within the body and parts of bodies that overlap.
  std::vector<bool> internal;
  std::vector<Hole> holes;  // about the edges of each that hang together
  int internal_facets = 0;
};

// Edges of a hole are those that do not run equally often each way. The surface that closes a hole lies in
// the convex hull of its edges, and no point of that is farther from the edges than twice the radius of a
// hole that holds them, or than half its extent. So the line from a point to its nearest facet passes through
// a hole only if the facet is that near to the hull: else the hole's edge would be nearer. Facets within
// twice this are unsure.
Defects find_defects(const MeshView& mesh, const Topology& topo, const WindingTree& tree);

}  // namespace hawser::detail
