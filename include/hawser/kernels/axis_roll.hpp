// Roll of the ends of an element about its own axis, for friction at the line's surface.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Roll between two attitudes of a node, with the line's tangent c in its material axes: the rotation about
// the tangent that remains after the smallest rotation from the old tangent to the new one is removed.
struct AxisRoll {
  double angle = 0;                  // rad
  Vec3 by_turn = Vec3::Zero();       // d angle / d Theta, Theta: small rotation of the node in material axes
  Mat3 by_turn_turn = Mat3::Zero();  // d by_turn / d Theta
};
// q0, q1: from material axes to the axes in which the roll is measured (those of a body with the surface).
AxisRoll axis_roll(const Quat& q0, const Quat& q1, const Vec3& c);

}  // namespace hawser
