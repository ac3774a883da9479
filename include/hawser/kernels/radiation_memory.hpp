// Radiation force due to the past motion of a body (Cummins 1962), from its radiation damping. F is what the
// motion needs; the water's force on the body is -F.
//   F(t) = int_-inf^t K(t - s) v(s) ds,
//   K(t) = (2/pi) int_0^inf B(omega) cos(omega t) d omega  (Ogilvie 1964)
// For velocities that are linear between the times t_k with slopes a_k, and S'' = K, S(0) = S'(0) = 0,
//   F(t) = v_0 S'(t - t_0) + sum_k a_k [S(t - t_k) - S(t - t_k+1)]
// exactly, for steps of any length. See docs/theory/platforms.md.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hawser {

// A(at) - A(inf) by entry (kg and so on) from damping B by rows of frequencies `omega` [rad/s, ascending,
// above 0] and columns of entries; B is linear between the rows, 0 at 0 and beyond the last row. at: above 0
// and below the last row, where the jump of B makes A infinite. Ogilvie's relation as an integral over
// frequencies (Kotik and Mangulis 1962):
//   A(omega) - A(inf) = (2/pi) PV int_0^inf B(u)/(u² - omega²) du
Eigen::RowVectorXd added_mass_by_damping(const std::vector<double>& omega, const Eigen::MatrixXd& damping,
                                         double at);

// Several entries of a matrix K with the same frequencies.
class RadiationMemory {
 public:
  RadiationMemory() = default;
  // omega [rad/s]: above 0, increasing; damping: one row per frequency, one column per entry [N s/m, N s, N m
  // s]. Linear between the rows and from 0 at omega = 0; zero beyond the last. Throws std::invalid_argument
  // if sizes differ, frequencies do not increase, or all damping is zero.
  RadiationMemory(const std::vector<double>& omega, const Eigen::MatrixXd& damping);

  Eigen::Index entries() const { return damping_.cols(); }
  // Length of the memory, s: the time after which K is small, at most 400 s and 20000 points. If K is not
  // small by then, the memory is cut, which rounds off narrow peaks of B. Beyond it S is taken as constant.
  // Steady motion is then undamped, as for an infinite memory, because the integral of K over all times is
  // zero.
  double length() const { return length_; }
  // Distance of the points of the table, s.
  double spacing() const { return spacing_; }

  // K(t) by entry in closed form, t >= 0.
  Eigen::RowVectorXd retardation(double t) const;
  // S(t) by entry and, if `rate` is not null, S'(t), t >= 0, from a table, to about 1e-8 of K(0)/omega_last².
  void integrals(double t, double* S, double* rate) const;
  // added_mass_by_damping() for this damping.
  Eigen::RowVectorXd added_mass_by_damping(double omega) const;

 private:
  void tabulate();
  std::vector<double> omega_;
  Eigen::MatrixXd damping_;
  double length_ = 0, spacing_ = 0;
  // By time: S of all entries, then S', then K.
  std::vector<double> table_;
};

}  // namespace hawser
