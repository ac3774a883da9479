// Bend stiffeners: additional bending stiffness along a part of a line.
#pragma once

#include <utility>
#include <vector>

namespace hawser::model {

// Adds its bending stiffness to that of the line in both bending planes.
struct BendStiffener {
  double at = 0;                                // m, arc length of the root from end A
  bool towards_a = false;                       // extends from the root towards end A, else towards end B
  std::vector<std::pair<double, double>> rows;  // m from the root, N m²; linear in between, zero beyond

  double EI(double s) const;  // N m², at arc length s [m]
};

// Effective bending stiffness [N m²] between arc lengths from and to [m]: the harmonic mean of EI plus all
// stiffeners, the constant stiffness that has the same rotation under a constant moment.
double stiffened_EI(const std::vector<BendStiffener>& stiffeners, double from, double to, double EI);

}  // namespace hawser::model
