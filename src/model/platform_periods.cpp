// Natural periods of heave, roll and pitch with the added mass at their own frequency.
#include "hawser/model/platform_periods.hpp"

#include <cmath>

#include "hawser/kernels/table_places.hpp"
#include "hawser/model/mass_matrix.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::model {
namespace {

// Linear between the rows, constant beyond.
double added_mass(const HydrodynamicData& data, int mode, double omega) {
  const auto [low, high, share] = frequency_place(data.omega, omega);
  return (1 - share) * data.added_mass[low](mode, mode) + share * data.added_mass[high](mode, mode);
}

double period(const HydrodynamicData& data, int mode, double mass, double stiffness) {
  if (!(stiffness > 0)) return 0;
  double omega = std::sqrt(stiffness / (mass + data.infinite(mode, mode)));
  constexpr int kIterations = 50;
  for (int i = 0; i < kIterations; ++i)
    omega = 0.5 * (omega + std::sqrt(stiffness / (mass + added_mass(data, mode, omega))));
  return 2 * M_PI / omega;
}

}  // namespace

PlatformPeriods platform_periods(const Case& c, const Body& b) {
  const BodyMass& m = *b.mass;
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const double g = c.environment.gravity;
  const Vec3 stiffness = restoring(m, hydrostatics(m, c.environment.water.density, g), g);
  const Mat6 mass = whole_mass(m, Vec3::Zero());
  const int first = 6 * (h.body - 1);
  PlatformPeriods out;
  out.heave = period(*h.data, first + 2, mass(2, 2), stiffness[0]);
  out.roll = period(*h.data, first + 3, mass(3, 3), stiffness[1]);
  out.pitch = period(*h.data, first + 4, mass(4, 4), stiffness[2]);
  return out;
}

}  // namespace hawser::model
