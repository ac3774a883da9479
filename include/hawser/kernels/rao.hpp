// Response amplitude operators: motion of a vessel in a wave of 1 m by frequency and direction.
#pragma once

#include <array>
#include <complex>
#include <tuple>
#include <utility>
#include <vector>

#include "hawser/kernels/table_places.hpp"
#include "hawser/kernels/waves.hpp"

namespace hawser {

// Surge, sway, heave [m/m], roll, pitch, yaw [rad/m]: amplitude times exp(-i lag), where the lag [rad] is
// counted from the passage of the crest at the vessel's origin: motion = Re(response exp(i omega t)) for the
// elevation cos(omega t) there.
using Response = std::array<std::complex<double>, 6>;

class RaoTable {
 public:
  struct Row {
    double omega = 0,
           direction = 0;  // rad/s; rad, where the wave goes, from the vessel's bow (0: to the bow)
    Response response;
  };
  // All directions must have the same frequencies, at least one; throws std::invalid_argument.
  explicit RaoTable(std::vector<Row> rows);

  // Linear interpolation in the complex plane between frequencies and, periodically, between directions;
  // constant beyond the first and last frequency.
  Response at(double omega, double direction) const;

  DirectionGap neighbours(double direction) const { return direction_gap(direction_, direction); }

  // Two neighbouring frequencies at a direction of the table between which the phase of a response changes by
  // more than 90 degrees though neither amplitude is small: linear interpolation then passes near zero.
  struct Turn {
    size_t freedom = 0;                      // 0 to 5, surge to yaw
    double direction = 0, from = 0, to = 0;  // rad, rad/s
    double angle = 0;                        // rad
    double ends = 0, smallest = 0;           // smaller of both amplitudes; smallest amplitude between them
    bool operator<(const Turn& b) const {
      return std::tie(freedom, direction, from) < std::tie(b.freedom, b.direction, b.from);
    }
  };
  // Those involved in the response to this wave.
  std::vector<Turn> turns(double omega, double direction) const;

  double lowest() const { return omega_.front(); }  // rad/s
  double highest() const { return omega_.back(); }

 private:
  const Response& row(size_t direction, size_t omega) const {
    return rows_[direction * omega_.size() + omega];
  }
  std::vector<double> omega_, direction_;  // ascending; directions in [0, 2 pi)
  std::vector<Response> rows_;
  std::array<double, 6> largest_{};  // largest amplitudes of all rows
};

// Completes a table of one side of a vessel with symmetric halves: at -direction surge, heave and pitch are
// equal, sway, roll and yaw opposite. Directions along the vessel occur only once.
std::vector<RaoTable::Row> with_other_side(const std::vector<RaoTable::Row>& rows);

// A vessel's motion in a sea of components: a sum of harmonics.
class RaoMotion {
 public:
  // origin: of the vessel at rest (x and y are used). heading: direction of the bow from +x, rad. yaw [rad]:
  // rotation by drift, which changes the direction of the waves relative to the vessel.
  RaoMotion(const RaoTable& table, const WaveField& waves, const Vec3& origin, double heading,
            double yaw = 0);
  // Offset [m] and rotation vector [rad], in space axes that turn with the drift. drifted [m]: present
  // distance of the vessel from its origin, where it meets the waves.
  void at(double t, Vec3& offset, Vec3& rotation, const Vec3& drifted = Vec3::Zero()) const;
  // Rows of the motion at `count` times from `first`, spaced by `step` [s], at a constant drift.
  void rows(double first, double step, size_t count, const Vec3& drifted, std::vector<Vec3>& offset,
            std::vector<Vec3>& rotation) const;
  double highest() const { return highest_; }  // rad/s, highest frequency of the components

 private:
  struct Term {
    double omega = 0, kx = 0, ky = 0;  // rad/s, 1/m
    Vec3 offset_cos, offset_sin, rotation_cos, rotation_sin;
  };
  std::vector<Term> terms_;
  double highest_ = 0;
};

}  // namespace hawser
