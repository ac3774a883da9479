// Wave forces on a platform as sums over the components of a sea: of first order, and those that vary slowly
// with products of two components. See docs/theory/platforms.md.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "hawser/kernels/rigid_body.hpp"
#include "hawser/kernels/wave_sums.hpp"

namespace hawser {

using Complex = std::complex<double>;
using ComplexVec6 = Eigen::Matrix<Complex, 6, 1>;

// A table over frequency and direction: F = Re X a exp(i omega t) where the elevation at the origin of the
// body is a cos(omega t); X in N/m and N (of second order: N/m², N/m), axes of the body. Straight lines
// between the entries, in the complex plane; all round between directions. Beyond the first and the last
// frequency as there.
class WaveForceTable {
 public:
  WaveForceTable() = default;
  // omega [rad/s] growing, directions [rad] growing in [0, 2 pi) (where the wave goes to, seen from the
  // bow); values by direction, then frequency. std::invalid_argument where they do not fit.
  WaveForceTable(std::vector<double> omega, std::vector<double> directions, std::vector<ComplexVec6> values);
  bool none() const { return values_.empty(); }
  ComplexVec6 at(double omega, double direction) const;
  // By the direction, 1/rad.
  ComplexVec6 by_direction(double omega, double direction) const;
  double lowest() const { return omega_.front(); }
  double highest() const { return omega_.back(); }
  const std::vector<double>& directions() const { return directions_; }

 private:
  std::vector<double> omega_, directions_;
  std::vector<ComplexVec6> values_;
};

// Difference-frequency forces F_ij of two waves of one direction (the quadratic transfer function): F_ji is
// the conjugate of F_ij. Bilinear between the frequencies; beyond them as at the nearest.
class DifferenceForceTable {
 public:
  DifferenceForceTable() = default;
  // values by first, then second frequency, all pairs.
  DifferenceForceTable(std::vector<double> omega, std::vector<ComplexVec6> values);
  bool none() const { return values_.empty(); }
  ComplexVec6 at(double first, double second) const;

 private:
  std::vector<double> omega_;
  std::vector<ComplexVec6> values_;
};

enum class SecondOrder { none, mean, newman, full };

class PlatformWaves {
 public:
  PlatformWaves() = default;
  // first: of first order, or none; mean: forces in regular waves over the square of the amplitude, or none;
  // difference: for SecondOrder::full. heading [rad]: of the body, against +x.
  PlatformWaves(const std::vector<WaveComponent>& sea, double heading, const WaveForceTable& first,
                const WaveForceTable& mean, const DifferenceForceTable& difference, SecondOrder order);

  bool none() const { return components_.empty(); }
  // The body has turned to another heading [rad]: its forces from then on.
  void turn_to(double heading);
  // Of the sea, at all times: N, N m; axes of the heading.
  const Vec6& mean_drift() const { return mean_drift_; }
  // The same at any heading, and its derivative by that, axes of that heading.
  struct MeanDrift {
    Vec6 force = Vec6::Zero(), by_heading = Vec6::Zero();
  };
  MeanDrift mean_drift(double heading) const;

  struct Forces {
    Vec6 first = Vec6::Zero(), slow = Vec6::Zero();  // of second order without its mean
  };
  // Time [s], and where the body's origin is [m] for the phases of the waves.
  Forces at(double time, double x, double y) const;

 private:
  // Of one freedom: sum over modes of weight |sum_i amplitude_i exp(i phase_i)|².
  struct Mode {
    int freedom = 0;
    double weight = 0;
    std::vector<Complex> amplitude;
  };
  void add_newman(const Eigen::MatrixXd& drift);
  void add_full();

  std::vector<WaveComponent> components_;
  WaveForceTable first_table_, mean_table_;
  DifferenceForceTable difference_table_;
  SecondOrder order_ = SecondOrder::none;
  double heading_ = 0;
  std::vector<ComplexVec6> first_;  // times the amplitude of the component
  std::vector<Mode> modes_;
  Vec6 mean_drift_ = Vec6::Zero();
};

}  // namespace hawser
