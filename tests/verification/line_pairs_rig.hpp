// Shared by the tests of contact between lines: cases of several straight lines.
#pragma once

#include <cmath>

#include "support/rig.hpp"
#include "verification/statics_newton.hpp"

namespace hawser::test {

// A straight line of one type from end A along `direction`, unstretched length as given.
inline model::Line straight_line(const std::string& name, const std::string& type, double length,
                                 int elements, const model::End& a, const model::End& b) {
  model::Line l;
  l.name = name;
  l.sections.push_back({type, length, elements, 1});
  l.end_a = a;
  l.end_b = b;
  l.start = model::Start::straight;
  return l;
}

// Sets the stiffness per length of all contact between lines.
inline void touch(model::Case& c, double per_length, double smoothing, double friction = 0, double slip = 0) {
  model::LinePairSettings& s = c.contact.between_lines.general;
  s.basis = model::StiffnessBasis::per_length;
  s.normal_stiffness = per_length;
  s.smoothing = smoothing;
  s.friction = friction;
  s.mobilisation_length = slip;
}

// Contact force of two straight cylinders that cross at the angle theta, their axes `reach - p` apart, with
// the stiffness k per length of either (both sides in series) without smoothing: the integral of the normal
// component of the pressure.
inline double crossing_force(double k, double reach, double p, double theta) {
  const double d = reach - p;
  const double most = std::sqrt(reach * reach - d * d);  // m, across the other axis
  double sum = 0;
  const int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double q = most * (2 * (i + 0.5) / n - 1);
    const double r = std::hypot(d, q);
    sum += k * (reach - r) * d / r * 2 * most / n;
  }
  return sum / std::sin(theta);
}

// Updates the candidate pairs at the present state, then solves with Newton.
inline int settle(Simulation& s, double tolerance = 1e-10, std::vector<double>* residuals = nullptr) {
  if (s.system().update_couplings(s.state().at_rest(), 0) == CouplingChange::layout_changed)
    s.system().update_ghosts(s.state());
  return newton(s.system(), s.state(), tolerance, residuals);
}

}  // namespace hawser::test
