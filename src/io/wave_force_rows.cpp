// Tables of wave forces from entries in any order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "hawser/advice/hydrodynamic_files.hpp"
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
  directions_[key] = direction * kDegree;
  constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  auto& at = values_[{omega, key}];
  at.resize(static_cast<size_t>(6 * bodies_), Complex(kAbsent));
  Complex& entry = at[static_cast<size_t>(mode)];
  Again& again = again_[rotates(mode)];
  if (!std::isnan(entry.real()) && std::abs(value - entry) > std::abs(again.change))
    again = {omega, direction_deg, mode, value - entry};
  entry = value;
}

std::vector<WaveForceTable> WaveForceRows::tables(const std::string& path) {
  check_again(path);
  check_degrees(path);
  if (mirrored_) add_other_side(path);
  complete_modes(path);
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
                          2 * M_PI / w, direction / kDegree));
        values.push_back(Eigen::Map<const ComplexVec6>(&found->second[static_cast<size_t>(6 * body)]));
      }
    out.emplace_back(omega, directions, std::move(values));
  }
  return out;
}

// Duplicate rows with different values, relative to the largest force or moment: values that are zero by
// symmetry are noise. Directions of -180 and 180 deg are one.
void WaveForceRows::check_again(const std::string& path) const {
  constexpr double kCounts = 0.005;
  std::array<double, 2> largest{};
  for (const auto& [at, value] : values_)
    for (size_t m = 0; m < value.size(); ++m)
      if (const double size = std::abs(value[m]); size > largest[rotates(static_cast<int>(m))])
        largest[rotates(static_cast<int>(m))] = size;
  for (const size_t turns : {0, 1}) {
    const Again& again = again_[turns];
    if (std::abs(again.change) > kCounts * largest[turns])
      throw std::runtime_error(fmt::format(
          "{}: gives mode {} ({}) at {:.6g} s for {:g} deg twice, with different values: are these "
          "rows of two runs?",
          path, again.mode + 1, advice::modes_text(again.mode, again.mode), 2 * M_PI / again.omega,
          again.direction));
  }
}

// Directions of diffraction runs are multiples of 5 deg or other round numbers of degrees. Directions within
// one revolution of radians that are all such multiples as radians, and not one of them a multiple of half a
// degree as degrees, are in radians.
void WaveForceRows::check_degrees(const std::string& path) const {
  constexpr double kStep = 5 * kDegree, kRounded = 1e-3;  // rad
  constexpr double kRoundDegrees = 0.5, kDigits = 1e-6;
  if (directions_.size() < 3) return;  // an odd direction may be one by chance
  double widest = 0;
  for (const auto& [key, unused] : directions_) {
    const double direction = 1e-6 * static_cast<double>(key > kRound / 2 ? key - kRound : key);
    if (key == 0) continue;
    if (std::abs(direction) > 2 * M_PI + kRounded || std::abs(std::remainder(direction, kStep)) > kRounded ||
        std::abs(std::remainder(direction, kRoundDegrees)) < kDigits)
      return;
    if (std::abs(direction) > std::abs(widest)) widest = direction;
  }
  if (widest != 0)
    throw std::runtime_error(fmt::format(
        "{}: its directions, up to {:.5g}, are multiples of 5 deg in radians: give them in degrees", path,
        widest));
}

// Missing rows are zero by symmetry or in waves too short to load the body; a missing row is an error if that
// of the next longer waves is significant.
void WaveForceRows::complete_modes(const std::string& path) {
  constexpr double kCounts = 0.01;
  const auto modes = static_cast<size_t>(6 * bodies_);
  std::array<double, 2> largest{};  // of forces and of moments
  for (const auto& [at, value] : values_)
    for (size_t mode = 0; mode < modes; ++mode)
      if (const double size = std::abs(value[mode]); size > largest[rotates(static_cast<int>(mode))])
        largest[rotates(static_cast<int>(mode))] = size;
  std::map<long, const std::vector<Complex>*> previous;  // by direction; frequencies increase
  for (auto& [at, value] : values_) {
    const std::vector<Complex>* before = std::exchange(previous[at.second], &value);
    for (size_t mode = 0; mode < modes; ++mode) {
      if (!std::isnan(value[mode].real())) continue;
      const int m = static_cast<int>(mode);
      if (before && std::abs((*before)[mode]) > kCounts * largest[rotates(m)])
        throw std::runtime_error(
            fmt::format("{}: has no row {} ({}) at {:.6g} s for {:g} deg, though other periods have one: "
                        "complete the file",
                        path, mode + 1, advice::modes_text(m, m), 2 * M_PI / at.first,
                        directions_.at(at.second) / kDegree));
      value[mode] = 0;
    }
  }
}

// X(-beta) equals X(beta) with sway, roll and yaw reversed.
void WaveForceRows::add_other_side(const std::string& path) {
  const auto has_side = [this](bool port) {
    return std::any_of(directions_.begin(), directions_.end(), [port](const auto& d) {
      return port ? d.first > 0 && d.first < kRound / 2 : d.first > kRound / 2;
    });
  };
  if (has_side(true) && has_side(false))
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
