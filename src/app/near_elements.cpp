#include "hawser/app/near_elements.hpp"

#include <algorithm>

#include "hawser/mesh/partition.hpp"
#include "hawser/solve/start_shape.hpp"
#include "hawser/system/line_candidates.hpp"

namespace hawser::app {

std::vector<std::pair<int, int>> near_elements(const model::Case& c, const Mesh& mesh, const Bodies& bodies) {
  std::vector<double> radius;
  for (const Element& e : mesh.elements) {
    const auto& names = c.contact.lines;
    const bool takes_part =
        c.contact.all_lines ||
        std::find(names.begin(), names.end(), c.lines[static_cast<size_t>(e.line)].name) != names.end();
    radius.push_back(takes_part ? 0.5 * c.line_types[static_cast<size_t>(e.type)].contact_diameter : 0.0);
  }
  const LocalMesh whole = local_mesh(mesh, std::vector<int>(mesh.nodes.size(), 0), 0, 1);
  const StartShape shape = start_shape(c, whole, bodies);
  LineCandidates candidates(MPI_COMM_SELF, whole, std::move(radius));
  candidates.update(shape.state.view(0), 0);
  return candidates.elements();
}

}  // namespace hawser::app
