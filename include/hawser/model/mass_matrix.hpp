// Full mass matrices of floating bodies.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// Sets moments and products of inertia, coupling terms and, if not given, the centre of mass of a body with
// `matrix`. The couplings of a rigid body about P are m (0, z, -y; -z, 0, x; y, -x, 0), with (x, y, z) from P
// to the centre of mass; each coordinate is the mean of its two entries.
void use_mass_matrix(BodyMass& m);
// Complete mass matrix [kg, kg m, kg m²] about a point of the body frame, body axes.
Mat6 mass_matrix_about(const BodyMass& m, const Vec3& about);

}  // namespace hawser::model
