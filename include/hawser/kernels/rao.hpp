// Response amplitude operators: how a vessel moves in a wave of 1 m, by frequency and direction.
#pragma once

#include <array>
#include <complex>
#include <tuple>
#include <utility>
#include <vector>

#include "hawser/kernels/table_places.hpp"
#include "hawser/kernels/waves.hpp"

namespace hawser {

// Surge, sway, heave [m/m], roll, pitch, yaw [rad/m]: amplitude times exp(-i lag), the lag in rad after the
// crest passes the vessel's origin: motion = Re(response exp(i omega t)) where the elevation there is
// cos(omega t).
using Response = std::array<std::complex<double>, 6>;

class RaoTable {
 public:
  struct Row {
    double omega = 0,
           direction = 0;  // rad/s; rad, where the wave goes to seen from the vessel (0: to the bow)
    Response response;
  };
  // Every direction needs the same frequencies. std::invalid_argument otherwise, or without rows.
  explicit RaoTable(std::vector<Row> rows);

  // Straight lines between frequencies and (all round) between directions, in the complex plane; beyond the
  // first and last frequency as there.
  Response at(double omega, double direction) const;

  DirectionGap neighbours(double direction) const { return direction_gap(direction_, direction); }

  // Two neighbouring frequencies of the table at one of its directions between which the phase of a response
  // turns by more than 90 degrees, though neither amplitude is small: the straight line between them passes
  // near zero.
  struct Turn {
    size_t freedom = 0;                      // 0 to 5, surge to yaw
    double direction = 0, from = 0, to = 0;  // rad, rad/s
    double angle = 0;                        // rad
    double ends = 0, least = 0;              // the smaller amplitude of the two, and the least between them
    bool operator<(const Turn& b) const {
      return std::tie(freedom, direction, from) < std::tie(b.freedom, b.direction, b.from);
    }
  };
  // Those that the response to this wave is made of.
  std::vector<Turn> turns(double omega, double direction) const;

  double lowest() const { return omega_.front(); }  // rad/s
  double highest() const { return omega_.back(); }

 private:
  const Response& row(size_t direction, size_t omega) const {
    return rows_[direction * omega_.size() + omega];
  }
  std::vector<double> omega_, direction_;  // ascending; directions in [0, 2 pi)
  std::vector<Response> rows_;
  std::array<double, 6> largest_{};  // amplitudes of all rows
};

// A table of one side of a vessel whose halves are alike, with the other side: to -direction surge, heave and
// pitch are the same, and sway, roll and yaw the opposite. Of what goes along the vessel there is one only.
std::vector<RaoTable::Row> with_other_side(const std::vector<RaoTable::Row>& rows);

// A vessel's motion in a sea of components: a sum of harmonics.
class RaoMotion {
 public:
  // Origin of the vessel at rest (x, y count) and its heading: the direction of its bow, rad from +x. `yaw`
  // [rad]: what it has drifted round by, so that the waves meet it as seen from there.
  RaoMotion(const RaoTable& table, const WaveField& waves, const Vec3& origin, double heading,
            double yaw = 0);
  // Offset [m] and rotation vector [rad], in the axes of space that turn with the drift. `drifted` [m]: how
  // far the vessel is from its origin now, where it meets the waves.
  void at(double t, Vec3& offset, Vec3& rotation, const Vec3& drifted = Vec3::Zero()) const;
  // The same at `count` times from `first` on, `step` apart [s], of a vessel that stays where it has drifted
  // to.
  void rows(double first, double step, size_t count, const Vec3& drifted, std::vector<Vec3>& offset,
            std::vector<Vec3>& rotation) const;
  double highest() const { return highest_; }  // rad/s, of the components

 private:
  struct Term {
    double omega = 0, kx = 0, ky = 0;  // rad/s, 1/m
    Vec3 offset_cos, offset_sin, rotation_cos, rotation_sin;
  };
  std::vector<Term> terms_;
  double highest_ = 0;
};

}  // namespace hawser
