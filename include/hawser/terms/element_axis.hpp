// Axis of an element in a state, for contact along lines, and the distribution of a contact force to the
// element's nodes for output.
#pragma once

#include "hawser/kernels/axis_shape.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

// first, second: local nodes of the element's ends.
inline AxisEnds element_axis(const Kinematics& at, const Element& e, int first, int second) {
  const size_t i = first, j = second;
  AxisEnds a;
  a.beam = e.beam;
  a.length = e.length;
  a.x1 = at.x[i];
  a.x2 = at.x[j];
  a.v1 = at.v[i];
  a.v2 = at.v[j];
  if (!a.beam) return a;
  a.q1 = at.q[i];
  a.q2 = at.q[j];
  a.w1 = at.w[i];
  a.w2 = at.w[j];
  return a;
}

// Calls what(node, share) for the ends that this rank owns. share: value of the position's shape function at
// xi.
template <class What>
void share_at_ends(const Element& e, int first, int second, int owned, double xi, const What& what) {
  const double at_second = e.beam ? xi * xi * (3 - 2 * xi) : xi;
  if (first < owned) what(first, 1 - at_second);
  if (second < owned) what(second, at_second);
}

}  // namespace hawser
