// Full matrices of mass of floating bodies.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// Of a body with `matrix`: its moments and products of inertia, what couples, and its centre of mass where
// the case does not give it. Couplings of a rigid body about P are m (0, z, -y; -z, 0, x; y, -x, 0), with
// (x, y, z) from P to the centre of mass; each coordinate is the mean of two.
void use_mass_matrix(BodyMass& m);
// kg, kg m, kg m², of all of it about a point of the body's frame, its axes.
Mat6 whole_mass(const BodyMass& m, const Vec3& about);

}  // namespace hawser::model
