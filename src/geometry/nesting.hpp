// Orientation and nesting of the pieces of a mesh, for inspection and repair.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// Collects the triangles connected with `first` across edges of two triangles. turn: -1 for unvisited
// triangles; set to 1 for those that must be reversed to agree with `first`, else 0. Returns false if the
// surface is one-sided.
bool grow_patch(const MeshView& mesh, const Topology& topo, int first, std::vector<signed char>& turn,
                std::vector<int>& patch);

// Signed volume [m³] of each component.
std::vector<double> component_volumes(const MeshView& mesh, const Topology& topo);

// Number of other components that contain each component, regardless of orientation.
std::vector<int> nesting_depth(const MeshView& mesh, const Topology& topo);

}  // namespace hawser::detail
