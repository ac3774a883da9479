// Arc lengths of points on elements.
#pragma once

#include "hawser/mesh/mesh.hpp"

namespace hawser {

// Unstretched arc length from end A, m; xi in [0, 1] along the element.
inline double arc_at(const Mesh& mesh, const Element& e, double xi) {
  const double a = mesh.node(e.first).arc;
  const double b = mesh.node(e.second).arc;
  return a + xi * (b - a);
}

}  // namespace hawser
