// Places on elements as arc lengths of their lines.
#pragma once

#include "hawser/mesh/mesh.hpp"

namespace hawser {

// m, unstretched, from end A; xi in [0, 1] along the element.
inline double arc_at(const Mesh& mesh, const Element& e, double xi) {
  const double a = mesh.nodes[static_cast<std::size_t>(e.first)].arc,
               b = mesh.nodes[static_cast<std::size_t>(e.second)].arc;
  return a + xi * (b - a);
}

}  // namespace hawser
