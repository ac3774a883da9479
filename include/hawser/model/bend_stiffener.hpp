// What stiffens a line against bending along a part of its length.
#pragma once

#include <utility>
#include <vector>

namespace hawser::model {

// Adds its bending stiffness to the line's own, both ways.
struct BendStiffener {
  double at = 0;                                // m, arc length from end A, of its root
  bool towards_a = false;                       // it goes from its root towards end A, else towards end B
  std::vector<std::pair<double, double>> rows;  // m from the root, N m²; straight between, nothing beyond

  double EI(double s) const;  // N m², at arc length s [m]
};

// Of all of them, along [from, to] (m, arc lengths), on top of a constant EI [N m²]: the constant stiffness
// that bends as much under a constant moment, which is the harmonic mean.
double stiffened_EI(const std::vector<BendStiffener>& stiffeners, double from, double to, double EI);

}  // namespace hawser::model
