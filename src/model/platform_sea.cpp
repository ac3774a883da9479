// Coverage of a sea's directions and periods by tables of wave forces, and wave-drift damping in that sea.
#include <algorithm>
#include <cmath>

#include "hawser/kernels/table_places.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::model {
namespace {

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

}  // namespace

Mat6 wave_drift_damping(const BodyHydrodynamics& h, const std::vector<WaveComponent>& sea) {
  Mat6 out = Mat6::Zero();
  if (h.drift_damping.empty()) return out;
  std::vector<double> omega;
  for (const auto& [at, B] : h.drift_damping) omega.push_back(at);
  Mat3 sum = Mat3::Zero();
  for (const WaveComponent& w : sea) {
    const TablePlace place = frequency_place(omega, w.omega);
    const Mat3& low = h.drift_damping[place.low].second;
    const Mat3& high = h.drift_damping[place.high].second;
    sum += w.amplitude * w.amplitude * ((1 - place.weight) * low + place.weight * high);
  }
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) out(kHorizontalFreedoms[i], kHorizontalFreedoms[j]) = sum(i, j);
  return out;
}

Coverage coverage(const WaveForceTable& table, const std::vector<WaveComponent>& sea, double heading) {
  Coverage out;
  double all = 0;
  for (const WaveComponent& w : sea) {
    const double energy = w.amplitude * w.amplitude;
    const double direction = std::atan2(w.y, w.x) - heading;
    all += energy;
    if (!covered(table.directions(), direction)) {
      if (out.uncovered == 0) out.direction = std::remainder(direction, 2 * M_PI);
      out.uncovered += energy;
    }
    if (w.omega > table.highest() * (1 + 1e-4)) out.shorter_waves += energy;
    if (w.omega < table.lowest() * (1 - 1e-4)) out.longer_waves += energy;
  }
  if (!(all > 0)) return out;
  out.uncovered /= all;
  out.shorter_waves /= all;
  out.longer_waves /= all;
  return out;
}

MeanDirection mean_direction(const std::vector<WaveComponent>& sea) {
  Eigen::Vector2d sum(0, 0);
  double all = 0;
  for (const WaveComponent& w : sea) {
    const double energy = w.amplitude * w.amplitude;
    sum += energy * Eigen::Vector2d(w.x, w.y);
    all += energy;
  }
  if (!(all > 0)) return {};
  const Eigen::Vector2d mean = sum.normalized();
  MeanDirection out;
  out.direction = std::atan2(sum.y(), sum.x());
  for (const WaveComponent& w : sea)
    if (mean.dot(Eigen::Vector2d(w.x, w.y)) < std::cos(kFarFromMean))
      out.far += w.amplitude * w.amplitude / all;
  return out;
}

const DifferenceForces& difference_forces(const BodyHydrodynamics& h, const std::vector<WaveComponent>& sea,
                                          double heading) {
  const double direction = mean_direction(sea).direction - heading;
  const auto distance = [&](const DifferenceForces& of) {
    return std::abs(std::remainder(of.direction() - direction, 2 * M_PI));
  };
  const std::vector<DifferenceForces>& all = h.data->difference;
  return *std::min_element(all.begin(), all.end(),
                           [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

}  // namespace hawser::model
