// What `hawser check` says of a platform: its weight and buoyancy, stability, added mass and periods.
#include <fmt/format.h>

#include <cmath>

#include "hawser/kernels/table_places.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::model {
namespace {

// Between the rows; beyond them as there.
double added_mass(const HydrodynamicData& data, int mode, double omega) {
  const auto [low, high, share] = frequency_place(data.omega, omega);
  return (1 - share) * data.added_mass[low](mode, mode) + share * data.added_mass[high](mode, mode);
}

// s, of one freedom by itself: T = 2 pi sqrt((M + A(2 pi/T))/C); 0: nothing pulls it back.
double period(const HydrodynamicData& data, int mode, double mass, double stiffness) {
  if (!(stiffness > 0)) return 0;
  double omega = std::sqrt(stiffness / (mass + data.infinite(mode, mode)));
  constexpr int kIterations = 50;
  for (int i = 0; i < kIterations; ++i)
    omega = 0.5 * (omega + std::sqrt(stiffness / (mass + added_mass(data, mode, omega))));
  return 2 * M_PI / omega;
}

}  // namespace

std::string platform_text(const Case& c, const Body& b) {
  const BodyMass& m = *b.mass;
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const HydrodynamicData& data = *h.data;
  const double g = c.environment.gravity, density = c.environment.water.density;
  const Hydrostatics still = hydrostatics(m, density, g);
  const double weight = m.mass * g, heave = (still.buoyancy - weight) / still.stiffness(2, 2);
  std::string s = fmt::format("    displaced volume {:.6g} m³{}, buoyancy {:.5g} kN, weight {:.5g} kN\n",
                              still.buoyancy / (density * g), h.volume > 0 ? "" : " (that of its mass)",
                              still.buoyancy / 1000, weight / 1000);
  if (h.volume > 0 && still.stiffness(2, 2) > 0)
    s += fmt::format(
        "    without lines it would float {:.3g} m {}; lines that pull {:.5g} kN {} keep it in place\n",
        std::abs(heave), heave > 0 ? "higher" : "lower", std::abs(still.buoyancy - weight) / 1000,
        heave > 0 ? "down" : "up");
  const double roll = still.stiffness(3, 3) - weight * m.centre.z();
  const double pitch = still.stiffness(4, 4) - weight * m.centre.z();
  s += fmt::format("    metacentric heights {:.4g} m (roll), {:.4g} m (pitch)\n", roll / weight,
                   pitch / weight);
  const int first = 6 * (h.body - 1);
  std::string added;
  for (int k = 0; k < 6; ++k)
    added += fmt::format("{}{:.4g}", k > 0 ? ", " : "", data.infinite(first + k, first + k));
  s += fmt::format("    added mass at infinite frequency{}: {} (kg, kg m²)\n",
                   data.infinite_estimated ? ", estimated" : "", added);
  const Mat3 inertia = m.tensor();
  const Vec3& x = m.centre;
  const double about_x = inertia(0, 0) + m.mass * (x.y() * x.y() + x.z() * x.z());
  const double about_y = inertia(1, 1) + m.mass * (x.x() * x.x() + x.z() * x.z());
  const double periods[] = {period(data, first + 2, m.mass, still.stiffness(2, 2)),
                            period(data, first + 3, about_x, roll), period(data, first + 4, about_y, pitch)};
  const auto text = [](double T) { return T > 0 ? fmt::format("{:.4g} s", T) : std::string("none"); };
  s += fmt::format("    periods without lines and coupling: heave {}, roll {}, pitch {}\n", text(periods[0]),
                   text(periods[1]), text(periods[2]));
  s += fmt::format("    coefficients of {} frequencies, {:.4g} to {:.4g} s{}\n", data.omega.size(),
                   2 * M_PI / data.omega.back(), 2 * M_PI / data.omega.front(),
                   data.excitation.empty() ? ", no wave forces"
                                           : fmt::format(", wave forces of {} directions",
                                                         data.excitation.front().directions().size()));
  return s;
}

}  // namespace hawser::model
