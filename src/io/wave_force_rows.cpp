// Tables of wave forces from entries in any order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydrodynamic_parts.hpp"

namespace hawser::io {
namespace {

constexpr long kRound = 360000000;  // key of 360 deg

}  // namespace

void WaveForceRows::add(double omega, double direction_deg, int mode, Complex value) {
  double direction = std::fmod(direction_deg, 360.0);
  if (direction < 0) direction += 360;
  if (direction > 360 - 1e-6) direction = 0;
  const long key = std::lround(1e6 * direction);
  directions_[key] = direction * kRadPerDegree;
  auto& at = values_[{omega, key}];
  at.resize(static_cast<size_t>(6 * bodies_));
  at[static_cast<size_t>(mode)] = value;
}

std::vector<WaveForceTable> WaveForceRows::tables(const std::string& path) {
  if (mirrored_) add_other_side(path);
  std::vector<double> omega, directions;
  for (const auto& [at, value] : values_)
    if (omega.empty() || at.first > omega.back()) omega.push_back(at.first);
  for (const auto& [key, direction] : directions_) directions.push_back(direction);
  std::vector<WaveForceTable> out;
  for (int body = 0; body < bodies_; ++body) {
    std::vector<ComplexVec6> values;
    for (const auto& [key, direction] : directions_)
      for (const double w : omega) {
        const auto found = values_.find({w, key});
        if (found == values_.end())
          throw std::runtime_error(
              fmt::format("{}: has no rows at {:.6g} s for {:g} deg, though other directions have them", path,
                          2 * M_PI / w, direction / kRadPerDegree));
        values.push_back(Eigen::Map<const ComplexVec6>(&found->second[static_cast<size_t>(6 * body)]));
      }
    out.emplace_back(omega, directions, std::move(values));
  }
  return out;
}

// X(-beta) is X(beta) with sway, roll and yaw reversed.
void WaveForceRows::add_other_side(const std::string& path) {
  const auto on = [this](bool port) {
    return std::any_of(directions_.begin(), directions_.end(), [port](const auto& d) {
      return port ? d.first > 0 && d.first < kRound / 2 : d.first > kRound / 2;
    });
  };
  if (on(true) && on(false))
    throw std::runtime_error(path +
                             ": has directions on both sides of the body, and 'symmetry: port_starboard' "
                             "makes the other side of files of one side");
  const auto given = values_;
  for (const auto& [at, value] : given) {
    const auto [omega, key] = at;
    if (key == 0 || key == kRound / 2) continue;
    std::vector<Complex> image = value;
    for (size_t mode = 1; mode < image.size(); mode += 2) image[mode] = -image[mode];
    directions_[kRound - key] = 2 * M_PI - directions_.at(key);
    values_[{omega, kRound - key}] = std::move(image);
  }
}

}  // namespace hawser::io
