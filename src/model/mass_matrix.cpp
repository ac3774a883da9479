// Mass, inertia and couplings from a full matrix about any point, and back.
#include "hawser/model/mass_matrix.hpp"

#include "hawser/kernels/coupled_mass.hpp"

namespace hawser::model {

void use_mass_matrix(BodyMass& m) {
  const Mat6 M = 0.5 * (m.matrix->rows + m.matrix->rows.transpose());
  if (!m.centre_given) {
    const Vec3 twice(M(1, 5) - M(2, 4), M(2, 3) - M(0, 5), M(0, 4) - M(1, 3));
    m.centre = m.matrix->about + twice / (2 * m.mass);
  }
  m.coupled = mass_about(M, m.matrix->about - m.centre);
  m.inertia = m.coupled.diagonal().tail<3>();
  m.products = {m.coupled(3, 4), m.coupled(4, 5), m.coupled(3, 5)};
  m.coupled -= rigid_mass(m.mass, m.tensor());
}

Mat6 mass_matrix_about(const BodyMass& m, const Vec3& about) {
  return mass_about(rigid_mass(m.mass, m.tensor()) + m.coupled, m.centre - about);
}

}  // namespace hawser::model
