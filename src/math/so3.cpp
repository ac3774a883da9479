// The smallest rotation between two directions, the one function on rotations that is not inline.
#include "hawser/math/so3.hpp"

namespace hawser {

// Not inline: what Eigen does for opposite vectors is a singular value decomposition, and each file that saw
// it would compile it again, for twice as long as all the rest of the file.
Quat minimal_rotation(const Vec3& from, const Vec3& to) { return Quat::FromTwoVectors(from, to); }

}  // namespace hawser
