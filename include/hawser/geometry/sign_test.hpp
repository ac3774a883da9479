// Tests whether a point is inside a mesh.
#pragma once

namespace hawser {

// automatic: pseudonormals for a valid mesh, winding numbers otherwise. Last three: OMAE2006-92155.
enum class SignTest { automatic, pseudonormal, winding, tetrahedra, ray, solid_angle };

}  // namespace hawser
