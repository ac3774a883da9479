// Coverage of a sea's directions and periods by tables of wave forces, loss between their directions, and
// wave-drift damping in that sea.
#include <algorithm>
#include <cmath>

#include "hawser/kernels/table_places.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::model {
namespace {

constexpr double kDegree = M_PI / 180;
// Linear interpolation between directions further apart than kWideGap misses a side of the body; a single
// direction covers those within kNear.
constexpr double kWideGap = 60 * kDegree, kNear = 15 * kDegree;

bool covered(const std::vector<double>& directions, double direction) {
  const DirectionGap gap = direction_gap(directions, direction);
  const auto off = [direction](double other) {
    return std::abs(std::remainder(direction - other, 2 * M_PI));
  };
  const double nearest = std::min(off(gap.from), off(gap.to));
  if (directions.size() == 1) return nearest < kNear;
  return gap.to - gap.from <= kWideGap * (1 + 1e-9) || nearest < kDegree;
}

// Calls visit(component, amplitude² [m²], direction relative to the bow [rad]). Returns the sum of
// amplitude².
template <class Visit>
double for_components(const std::vector<WaveComponent>& sea, double heading, const Visit& visit) {
  double all = 0;
  for (const WaveComponent& w : sea) {
    const double energy = w.amplitude * w.amplitude;
    all += energy;
    visit(w, energy, std::atan2(w.y, w.x) - heading);
  }
  return all;
}

}  // namespace

Mat6 wave_drift_damping(const BodyHydrodynamics& h, const std::vector<WaveComponent>& sea) {
  Mat6 out = Mat6::Zero();
  if (h.drift_damping.empty()) return out;
  std::vector<double> omega;
  for (const auto& [at, B] : h.drift_damping) omega.push_back(at);
  Mat3 sum = Mat3::Zero();
  for (const WaveComponent& w : sea) {
    const TablePlace place = frequency_place(omega, w.omega);
    const Mat3 &low = h.drift_damping[place.low].second, &high = h.drift_damping[place.high].second;
    sum += w.amplitude * w.amplitude * ((1 - place.weight) * low + place.weight * high);
  }
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) out(kHorizontalFreedoms[i], kHorizontalFreedoms[j]) = sum(i, j);
  return out;
}

Coverage coverage(const WaveForceTable& table, const std::vector<WaveComponent>& sea, double heading) {
  Coverage out;
  const double all =
      for_components(sea, heading, [&](const WaveComponent& w, double energy, double direction) {
        if (!covered(table.directions(), direction)) {
          if (out.uncovered == 0) out.direction = std::remainder(direction, 2 * M_PI);
          out.uncovered += energy;
        }
        if (w.omega > table.highest() * (1 + 1e-4)) out.shorter_waves += energy;
        if (w.omega < table.lowest() * (1 - 1e-4)) out.longer_waves += energy;
      });
  if (!(all > 0)) return out;
  out.uncovered /= all;
  out.shorter_waves /= all;
  out.longer_waves /= all;
  return out;
}

TurningPhases turning_phases(const WaveForceTable& table, const Eigen::Vector2d& d,
                             const std::vector<WaveComponent>& sea, double heading, bool varies) {
  constexpr double kOff = 1e-6;  // rad, off the rows of the table
  TurningPhases out;
  double largest = 0;
  const double all =
      for_components(sea, heading, [&](const WaveComponent& w, double energy, double direction) {
        const DirectionGap gap = direction_gap(table.directions(), direction + (varies ? kOff : 0));
        const Eigen::Vector2d apart(std::cos(gap.from) - std::cos(gap.to),
                                    std::sin(gap.from) - std::sin(gap.to));
        const double turn = w.number * std::abs(d.dot(apart));
        out.lost += energy * (1 - std::cos(std::min(0.5 * turn, M_PI / 2)));
        if (energy * turn > largest) {
          largest = energy * turn;
          out.worst = gap;
        }
      });
  if (all > 0) out.lost /= all;
  return out;
}

}  // namespace hawser::model
