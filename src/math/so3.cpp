// Smallest rotation between two directions, the only function on rotations that is not inline.
#include "hawser/math/so3.hpp"

namespace hawser {

// Not inline: Eigen computes a singular value decomposition for opposite vectors, which would dominate the
// compile time of each file that includes it.
Quat minimal_rotation(const Vec3& from, const Vec3& to) { return Quat::FromTwoVectors(from, to); }

}  // namespace hawser
