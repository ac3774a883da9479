// Wave forces on a platform as sums over the components of a sea: first-order forces, and slowly varying ones
// from products of two components. See docs/theory/platforms.md.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "hawser/kernels/rigid_body.hpp"
#include "hawser/kernels/wave_sums.hpp"

namespace hawser {

using Complex = std::complex<double>;
using ComplexVec6 = Eigen::Matrix<Complex, 6, 1>;

// Table over frequency and direction: F = Re X a exp(i omega t) for the elevation a cos(omega t) at a point
// of the body; X in N/m and N (second order: N/m², N/m), body axes. Linear interpolation in the
// complex plane, periodic in the direction, constant beyond the first and the last frequency.
class WaveForceTable {
 public:
  WaveForceTable() = default;
  // omega [rad/s] increasing; directions [rad] increasing in [0, 2 pi) (where the wave goes, from the bow);
  // values by direction, then frequency. Throws std::invalid_argument if the sizes do not match.
  WaveForceTable(std::vector<double> omega, std::vector<double> directions, std::vector<ComplexVec6> values);
  bool none() const { return values_.empty(); }
  ComplexVec6 at(double omega, double direction) const;
  // Derivative by the direction, 1/rad.
  ComplexVec6 by_direction(double omega, double direction) const;
  double lowest() const { return omega_.front(); }
  double highest() const { return omega_.back(); }
  const std::vector<double>& omega() const { return omega_; }
  const std::vector<double>& directions() const { return directions_; }
  // The same forces with the phases of the waves at another point, c from the origin [m, body axes].
  // numbers: wave number of each frequency, 1/m.
  WaveForceTable with_phases_at(const Eigen::Vector2d& c, const std::vector<double>& numbers) const;

 private:
  std::vector<double> omega_, directions_;
  std::vector<ComplexVec6> values_;
};

// Difference-frequency forces F_ij of two waves of one direction (quadratic transfer function); F_ji is the
// conjugate of F_ij. Bilinear between the frequencies, constant beyond them.
class DifferenceForceTable {
 public:
  DifferenceForceTable() = default;
  // values: all pairs, by first, then second frequency.
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
  // first: first-order table, or none; mean: forces in regular waves divided by the square of the amplitude,
  // or none; difference: for SecondOrder::full. heading: of the body from +x, rad.
  // first_point: point of the phases of `first`, from that of the other tables, m, axes of the heading.
  PlatformWaves(const std::vector<WaveComponent>& sea, double heading, const WaveForceTable& first,
                const Eigen::Vector2d& first_point, const WaveForceTable& mean,
                const DifferenceForceTable& difference, SecondOrder order);

  bool none() const { return components_.empty(); }
  // Sets the heading [rad] and recomputes the forces for it.
  void turn_to(double heading);
  // Mean drift force of the sea, N and N m, axes of the heading.
  const Vec6& mean_drift() const { return mean_drift_; }
  // Mean drift at any heading, in its axes, and its derivative by the heading.
  struct MeanDrift {
    Vec6 force = Vec6::Zero(), by_heading = Vec6::Zero();
  };
  MeanDrift mean_drift(double heading) const;

  struct Forces {
    Vec6 first = Vec6::Zero(), slow = Vec6::Zero();  // slow: second order without its mean
  };
  // Forces at a time [s]; x, y: position of the point of the phases of `mean` and `difference`, m.
  Forces at(double time, double x, double y) const;
  // First-order force of each component at that point: Re(F exp(i omega t)).
  std::vector<ComplexVec6> first_order(double x, double y) const;

 private:
  // Contribution to one degree of freedom: weight |sum_i amplitude_i exp(i phase_i)|².
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
  Eigen::Vector2d first_point_ = Eigen::Vector2d::Zero();
  std::vector<ComplexVec6> first_;  // times the amplitude of the component
  std::vector<Mode> modes_;
  Vec6 mean_drift_ = Vec6::Zero();
};

}  // namespace hawser
