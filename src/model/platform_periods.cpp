// Periods of a platform afloat and on its lines, with the added mass at these frequencies.
#include "hawser/model/platform_periods.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "hawser/kernels/table_places.hpp"
#include "hawser/model/mass_matrix.hpp"
#include "hawser/model/platform.hpp"
#include "hawser/model/waterplane.hpp"

namespace hawser::model {
namespace {

constexpr int kUpright[] = {2, 3, 4}, kPlane[] = {0, 1, 5};

// Surge, sway and yaw have no stiffness: M_ss x_s + M_sr x_r = 0 at any frequency, and the mass for heave,
// roll and pitch is
//   M_rr - M_rs M_ss^-1 M_sr
Mat3 mass_upright(const Mat6& M) {
  const Mat3 across = M(kPlane, kUpright);
  return M(kUpright, kUpright) - across.transpose() * Mat3(M(kPlane, kPlane)).ldlt().solve(across);
}

// rad/s, of the mode in which that degree of freedom (0: heave, 1: roll, 2: pitch) has the most kinetic
// energy; 0: none.
double frequency(const Mat3& C, const Mat3& M, int freedom) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> modes(C, M);
  Eigen::Index mode = 0;
  modes.eigenvectors().row(freedom).cwiseAbs().maxCoeff(&mode);
  return std::sqrt(std::max(modes.eigenvalues()[mode], 0.0));
}

// Between the rows; beyond them as there.
Mat6 added_mass(const HydrodynamicData& data, Eigen::Index first, double omega) {
  const auto [low, high, fraction] = frequency_place(data.omega, omega);
  const auto block = [&](size_t row) { return Mat6(data.added_mass[row].block<6, 6>(first, first)); };
  return (1 - fraction) * block(low) + fraction * block(high);
}

// s, natural period with the added mass at its frequency; 0: none. frequency_with(A): rad/s, with the added
// mass A of the body whose rows of the matrices begin at `first`.
template <class FrequencyWith>
double settled_period(const HydrodynamicData& data, Eigen::Index first, const FrequencyWith& frequency_with) {
  double omega = frequency_with(Mat6(data.infinite.block<6, 6>(first, first)));
  constexpr int kIterations = 50;
  for (int i = 0; i < kIterations && omega > 0; ++i) {
    const double next = frequency_with(added_mass(data, first, omega));
    omega = next > 0 ? 0.5 * (omega + next) : 0;
  }
  return omega > 0 ? 2 * M_PI / omega : 0;
}

}  // namespace

PlatformPeriods platform_periods(const Case& c, const Body& b) {
  const BodyMass& m = *b.mass;
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const double g = c.environment.gravity;
  const PlatformHydrostatics in_still_water = hydrostatics(m, c.environment.water.density, g);
  // About the centre of the waterplane, where heave is not a part of roll and pitch.
  const Mat3 C = about_waterplane_centre(restoring(m, in_still_water, g));
  const Mat6 motion = motion_from_point(waterplane_centre(in_still_water.stiffness));
  const Mat6 mass = mass_matrix_about(m, Vec3::Zero());
  const auto period = [&](int freedom) {
    return settled_period(*h.data, h.first_row(), [&](const Mat6& A) {
      return frequency(C, mass_upright(motion.transpose() * (mass + A) * motion), freedom);
    });
  };
  return {period(0), period(1), period(2)};
}

std::array<PlatformMode, 6> modes_on_stiffness_matrix(const Body& b) {
  const Mat6 motion = motion_from_point(b.mass->centre);
  return platform_modes(b, motion.transpose() * b.mass->stiffness_matrix * motion);
}

std::array<PlatformMode, 6> platform_modes(const Body& b, const Mat6& K) {
  constexpr double kRounded = 1e-12;  // of the largest omega²: no stiffness
  const BodyMass& m = *b.mass;
  const Mat6 motion = motion_from_point(m.centre);
  const Mat6 mass = mass_matrix_about(m, m.centre);
  std::array<PlatformMode, 6> out;
  for (int k = 0; k < 6; ++k) {
    Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> modes;
    Mat6 M;
    const auto frequency_with = [&](const Mat6& A) {
      M = mass + motion.transpose() * A * motion;
      modes.compute(0.5 * (K + K.transpose()), 0.5 * (M + M.transpose()));
      const double square = modes.eigenvalues()[k];
      return square > kRounded * modes.eigenvalues()[5] ? std::sqrt(square) : 0;
    };
    double& period = out[static_cast<size_t>(k)].period;
    if (m.hydrodynamics)
      period = settled_period(*m.hydrodynamics->data, m.hydrodynamics->first_row(), frequency_with);
    else if (const double omega = frequency_with(Mat6::Zero()); omega > 0)
      period = 2 * M_PI / omega;
    const Vec6 x = modes.eigenvectors().col(k);
    Vec6 energy = x.cwiseProduct(M * x);
    for (int named = 0; named < k; ++named) energy[out[static_cast<size_t>(named)].freedom] = -HUGE_VAL;
    energy.maxCoeff(&out[static_cast<size_t>(k)].freedom);
  }
  // Modes of equal periods, such as surge and sway of a symmetric platform, have arbitrary vectors in a
  // plane: they are named in the order of the degrees of freedom.
  constexpr double kEqual = 1e-3;
  for (size_t k = 1; k < out.size(); ++k) {
    PlatformMode& before = out[k - 1];
    PlatformMode& now = out[k];
    const bool equal = before.period > 0 ? before.period <= (1 + kEqual) * now.period : !(now.period > 0);
    if (equal && before.freedom > now.freedom) std::swap(before.freedom, now.freedom);
  }
  return out;
}

}  // namespace hawser::model
