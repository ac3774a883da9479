// Rotation about the vertical by a heading.
#pragma once

#include "hawser/math/so3.hpp"

namespace hawser {

// Rotation by a heading [rad], anticlockwise viewed from above, from +x.
inline Quat heading_rotation(double heading) { return exp_so3(heading * Vec3::UnitZ()); }
// Columns: the axes x, y, z that this rotation turns to.
inline Mat3 heading_axes(double heading) { return heading_rotation(heading).toRotationMatrix(); }

}  // namespace hawser
