// Which elements may touch at the start of a run: what the cut into ranks takes into account.
#pragma once

#include <utility>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::app {

// Pairs of Mesh::elements, of lines that take part in contact, in the start shape. Local: every rank makes
// the whole shape, the same on each.
std::vector<std::pair<int, int>> near_elements(const model::Case& c, const Mesh& mesh, const Bodies& bodies);

}  // namespace hawser::app
