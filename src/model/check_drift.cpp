// Size and direction of mean drift forces.
#include "hawser/model/check_drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::model {
namespace {

// Tables of mean drift of a body: one, or one for each direction of full difference-frequency forces. None of
// bodies side by side, which push each other away.
std::vector<const WaveForceTable*> drift_tables(const BodyHydrodynamics& h) {
  std::vector<const WaveForceTable*> out;
  const auto add = [&](const std::vector<WaveForceTable>& of_bodies) {
    if (!of_bodies.empty()) out.push_back(&of_bodies[static_cast<size_t>(h.body) - 1]);
  };
  if (h.second_order == SecondOrder::none || h.data->bodies > 1) return out;
  add(h.data->drift);
  for (const DifferenceForces& of_direction : h.data->difference) add(of_direction.drift);
  return out;
}

}  // namespace

DriftSize drift_size(const Case& c, const Body& b) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const double density = c.environment.water.density;
  const double g = c.environment.gravity;
  DriftSize out;
  if (!(g > 0)) return out;
  const double volume = displaced_volume(*b.mass, density);
  const double waterplane = hydrostatics(*b.mass, density, g).stiffness(0, 0) / (density * g);
  out.width = std::max(std::cbrt(volume), 2 * std::sqrt(std::max(waterplane, 0.0) / M_PI));
  for (const WaveForceTable* table : drift_tables(h))
    for (const double beta : table->directions())
      for (const double omega : table->omega()) {
        const double force = table->at(omega, beta).head<2>().real().norm();
        if (force <= out.force) continue;
        out.force = force;
        out.period = 2 * M_PI / omega;
      }
  out.times = out.force / (0.5 * density * g * out.width);
  return out;
}

std::string text_of(const DriftSize& size, const BodyHydrodynamics& h) {
  return fmt::format(
      "the mean drift force of the files, {:.3g} N/m² at {:.4g} s, is {:.3g} times that of a wall of {:.3g} "
      "m, the width of the body, which reflects the wave completely: are its values those divided by rho "
      "g{}?",
      size.force, size.period, size.times, size.width,
      h.format == BodyHydrodynamics::Format::wamit ? " (WAMIT), for the length scale of the case" : "");
}

// Sums over frequencies and directions of the force along the axis of a freedom, positive with the waves,
// weighted by the widths of the frequencies.
std::optional<int> drift_against_waves(const BodyHydrodynamics& h) {
  constexpr double kAlong = 0.5;     // component of the direction along the axis
  constexpr double kCounts = 0.05;   // of the other axis
  constexpr double kAgainst = -0.5;  // of the sum of absolute values
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  Eigen::Array2d all = Eigen::Array2d::Zero();
  for (const WaveForceTable* table : drift_tables(h)) {
    const std::vector<double>& omega = table->omega();
    for (const double beta : table->directions()) {
      const Eigen::Array2d axis(std::cos(beta), std::sin(beta));
      for (size_t k = 0; k < omega.size(); ++k) {
        const double width = omega[std::min(k + 1, omega.size() - 1)] - omega[k > 0 ? k - 1 : 0];
        const Eigen::Array2d force = width * table->at(omega[k], beta).head<2>().real().array() * axis;
        for (int i = 0; i < 2; ++i) {
          if (std::abs(axis[i]) < kAlong) continue;
          sum[i] += force[i];
          all[i] += std::abs(force[i]);
        }
      }
    }
  }
  for (int i = 0; i < 2; ++i)
    if (all[i] > kCounts * all[1 - i] && sum[i] < kAgainst * all[i]) return i;
  return {};
}

}  // namespace hawser::model
