// Pieces of a mesh: which way the triangles of one face, and which lie inside which. Shared by the report and
// the repairs of orientation.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// The triangles joined to `first` across edges of two, and in `turn` (-1: not seen yet) 1 for those that are
// to be turned over so that all agree with it. False: the surface has one side only.
bool grow_patch(const MeshView& mesh, const Topology& topo, int first, std::vector<signed char>& turn,
                std::vector<int>& patch);

// Signed volume [m³] of each component.
std::vector<double> component_volumes(const MeshView& mesh, const Topology& topo);

// In how many other components each one lies (whatever their orientation).
std::vector<int> nesting_depth(const MeshView& mesh, const Topology& topo);

}  // namespace hawser::detail
