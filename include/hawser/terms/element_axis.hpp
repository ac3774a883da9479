// Axis of an element in a state, for contact along lines, and the distribution of a contact force to the
// element's nodes for output.
#pragma once

#include "hawser/kernels/axis_shape.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

// first, second: local nodes of the element's ends.
inline AxisEnds element_axis(const Kinematics& state, const Element& e, int first, int second) {
  const size_t i = first;
  const size_t j = second;
  AxisEnds a;
  a.beam = e.beam;
  a.length = e.length;
  a.x1 = state.x[i];
  a.x2 = state.x[j];
  a.v1 = state.v[i];
  a.v2 = state.v[j];
  if (!a.beam) return a;
  a.q1 = state.q[i];
  a.q2 = state.q[j];
  a.w1 = state.w[i];
  a.w2 = state.w[j];
  return a;
}

// Calls add(node, weight) for the ends that this rank owns. weight: value of the position's shape function at
// xi.
template <class Add>
void weights_at_ends(const Element& e, int first, int second, int owned, double xi, const Add& add) {
  const double at_second = e.beam ? xi * xi * (3 - 2 * xi) : xi;
  if (first < owned) add(first, 1 - at_second);
  if (second < owned) add(second, at_second);
}

}  // namespace hawser
