// Degrees of freedom without added mass and damping, or without wave forces.
#include "hawser/model/check_freedoms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/math/freedoms.hpp"

namespace hawser::model {
namespace {

// Largest size of each wave force, N/m and N.
Vec6 largest_forces(const WaveForceTable& table) {
  Vec6 largest = Vec6::Zero();
  for (const double beta : table.directions())
    for (const double omega : table.omega()) largest = largest.cwiseMax(table.at(omega, beta).cwiseAbs());
  return largest;
}

bool has_radiation(const BodyHydrodynamics& h, int freedom) {
  const HydrodynamicData& data = *h.data;
  const Eigen::Index row = h.first_row() + freedom;
  const auto is_given = [row](const Eigen::MatrixXd& m) { return m(row, row) != 0; };
  return is_given(data.infinite) || std::any_of(data.added_mass.begin(), data.added_mass.end(), is_given) ||
         std::any_of(data.damping.begin(), data.damping.end(), is_given);
}

// True if the table has waves along the axis of a degree of freedom: surge and pitch need waves ahead or
// astern, sway and roll waves from a side. Yaw of a body whose sides are mirror images needs none.
bool is_loaded(const WaveForceTable& table, int freedom) {
  constexpr double kLeast = 0.5;  // of the component along the axis
  if (freedom == 2) return true;
  if (freedom == 5) return false;
  const bool ahead = freedom == 0 || freedom == 4;
  return std::any_of(table.directions().begin(), table.directions().end(), [ahead](double beta) {
    return std::abs(ahead ? std::cos(beta) : std::sin(beta)) >= kLeast;
  });
}

// Added mass relative to that of the displaced water, and to its square of the length for rotations.
double relative_added_mass(const Case& c, const Body& b, int freedom) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const double density = c.environment.water.density;
  const double volume = displaced_volume(*b.mass, density);
  const Eigen::Index row = h.first_row() + freedom;
  double largest = 0;
  for (const Eigen::MatrixXd& A : h.data->added_mass) largest = std::max(largest, A(row, row));
  return largest / (density * std::pow(volume, freedom < 3 ? 1 : 5.0 / 3));
}

}  // namespace

std::optional<MissingFreedom> missing_freedom(const Case& c, const Body& b) {
  constexpr double kCounts = 0.01;
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const WaveForceTable& table = *h.wave_forces();
  const Vec6 largest = largest_forces(table);
  const auto lacks_forces = [&](int freedom) {
    return largest[freedom] == 0 && is_loaded(table, freedom) && relative_added_mass(c, b, freedom) > kCounts;
  };
  // A hinged body may have no translations at all.
  for (int freedom = 0; freedom < 3; ++freedom)
    if (lacks_forces(freedom) && !largest.head<3>().isZero(0)) return MissingFreedom{freedom, false};
  const bool translates = has_radiation(h, 0) || has_radiation(h, 1) || has_radiation(h, 2);
  for (int freedom = translates ? 0 : 3; freedom < 6; ++freedom) {
    const double of_kind = largest.segment<3>(freedom < 3 ? 0 : 3).maxCoeff();
    if (largest[freedom] > kCounts * of_kind && !has_radiation(h, freedom))
      return MissingFreedom{freedom, true};
  }
  for (int freedom = 3; freedom < 6; ++freedom)
    if (lacks_forces(freedom)) return MissingFreedom{freedom, false};
  return {};
}

std::string text_of(const MissingFreedom& missing, const BodyHydrodynamics& h) {
  const auto mode = h.first_row() + missing.freedom + 1;
  const HydrodynamicData& data = *h.data;
  return missing.in_radiation
             ? fmt::format(
                   "no added mass and damping of mode {} ({}) in {}, although {} has wave forces of it: "
                   "complete the file",
                   mode, kFreedomNames[missing.freedom], data.radiation_file, data.excitation_file)
             : fmt::format(
                   "no wave forces of mode {} ({}) in {}, although {} has added mass of it: complete the "
                   "file",
                   mode, kFreedomNames[missing.freedom], data.excitation_file, data.radiation_file);
}

}  // namespace hawser::model
