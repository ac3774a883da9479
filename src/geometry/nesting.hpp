// Which pieces of a mesh lie inside which: shared by the report and the repair of orientation.
#pragma once

#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::detail {

// Signed volume [m³] of each component.
std::vector<double> component_volumes(const TriangleMesh& mesh, const Topology& topo);

// In how many other components each one lies (whatever their orientation).
std::vector<int> nesting_depth(const TriangleMesh& mesh, const Topology& topo);

}  // namespace hawser::detail
