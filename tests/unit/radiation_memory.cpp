// Retardation functions and their integrals against closed forms, and the force for piecewise linear
// velocities.
#include "hawser/kernels/radiation_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace hawser::radiation_memory_test {
namespace {

// B = omega² exp(-omega) has K(t) = (2/pi) Re 2/(1 - i t)³.
double damping(double omega) { return omega * omega * std::exp(-omega); }
double retardation(double t) { return 4 / M_PI * (1 - 3 * t * t) / std::pow(1 + t * t, 3); }

RadiationMemory memory(double step = 0.05) {
  std::vector<double> omega;
  for (double w = step; w < 15; w += step) omega.push_back(w);
  Eigen::MatrixXd B(omega.size(), 2);
  for (size_t k = 0; k < omega.size(); ++k)
    B.row(static_cast<int>(k)) << damping(omega[k]), -0.5 * damping(omega[k]);
  return {omega, B};
}

TEST(RadiationMemory, HasTheClosedFormOfItsDamping) {
  const RadiationMemory m = memory();
  for (double t = 0; t < 12; t += 0.37) {
    EXPECT_NEAR(m.retardation(t)[0], retardation(t), 5e-4 * retardation(0)) << t;
    EXPECT_NEAR(m.retardation(t)[1], -0.5 * retardation(t), 5e-4 * retardation(0)) << t;
  }
}

// A(omega) - A(inf) by Ogilvie's relation in the time domain, from the closed form of K; at rows and between
// them.
TEST(RadiationMemory, GivesTheAddedMassByOgilvie) {
  const RadiationMemory m = memory();
  for (const double omega : {0.3, 1.0, 1.027, 2.5}) {
    double sum = 0;
    const double h = 1e-3;
    for (double t = 0.5 * h; t < 200; t += h) sum += h * retardation(t) * std::sin(omega * t) / omega;
    EXPECT_NEAR(m.added_mass_by_damping(omega)[0], -sum, 2e-3) << omega;
  }
}

// The same in closed form, by hand, for a triangle of damping that is 0 at zero frequency, 1 at 2 rad/s and 0
// at 4 rad/s: damping w/2 up to 2 rad/s and 2 - w/2 beyond.
TEST(RadiationMemory, GivesTheAddedMassByFrequencies) {
  Eigen::MatrixXd triangle(2, 1);
  triangle << 1, 0;
  const RadiationMemory one({2, 4}, triangle);
  for (const double w : {0.7, 2.0, 3.1}) {
    const double first = w == 2 ? 0 : std::log(std::abs(2 - w));
    const double up = 0.5 * w * (first - std::log(w)) + 0.5 * w * (std::log(2 + w) - std::log(w));
    const double down = (2 - 0.5 * w) * (std::log(std::abs(4 - w)) - first) -
                        (2 + 0.5 * w) * (std::log(4 + w) - std::log(2 + w));
    EXPECT_NEAR(one.added_mass_by_damping(w)[0], (up + down) / (M_PI * w), 1e-12) << w;
  }
}

TEST(RadiationMemory, IntegralsAreThoseOfTheRetardation) {
  const RadiationMemory m = memory(0.1);
  double S[2], rate[2], later[2], slope[2];
  m.integrals(0, S, rate);
  EXPECT_EQ(S[0], 0);
  EXPECT_EQ(rate[0], 0);
  const double e = 1e-4;
  for (double t = 0.013; t < 0.9 * m.length(); t += 0.61) {
    m.integrals(t, S, rate);
    m.integrals(t + e, later, slope);
    EXPECT_NEAR((later[0] - S[0]) / e, 0.5 * (rate[0] + slope[0]), 1e-6) << t;
    EXPECT_NEAR((slope[0] - rate[0]) / e, m.retardation(t + 0.5 * e)[0], 2e-5) << t;
  }
  // The force is zero after steady motion for longer than the memory.
  m.integrals(m.length() + 5, S, rate);
  EXPECT_EQ(rate[0], 0);
  m.integrals(m.length(), later, slope);
  EXPECT_EQ(S[0], later[0]);
}

// In harmonic motion the memory gives the damping omega int_0^length S' sin(omega t) dt. Far below the peak,
// where damping is 0.4 % of it, a memory that ended where K is 0.1 % of K(0) would give 4 % too much.
TEST(RadiationMemory, IsLongEnoughForLittleDamping) {
  const auto B = [](double omega) { return std::pow(omega, 4) * std::exp(-2 * omega); };
  std::vector<double> omega;
  for (int k = 1; k < 400; ++k) omega.push_back(0.02 * k);
  Eigen::MatrixXd damping(omega.size(), 1);
  for (size_t k = 0; k < omega.size(); ++k) damping(static_cast<int>(k), 0) = B(omega[k]);
  const RadiationMemory m(omega, damping);
  const double h = 0.01, slow = 0.2;
  double found = 0, S = 0, rate = 0;
  for (double t = 0.5 * h; t < m.length(); t += h) {
    m.integrals(t, &S, &rate);
    found += h * slow * std::sin(slow * t) * rate;
  }
  EXPECT_NEAR(found, B(slow), 0.02 * B(slow));
}

TEST(RadiationMemory, RefusesFrequenciesThatDoNotGrow) {
  EXPECT_THROW(RadiationMemory({1, 1}, Eigen::MatrixXd::Ones(2, 1)), std::invalid_argument);
  EXPECT_THROW(RadiationMemory({0, 1}, Eigen::MatrixXd::Ones(2, 1)), std::invalid_argument);
  EXPECT_THROW(RadiationMemory({1, 2}, Eigen::MatrixXd::Ones(3, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace hawser::radiation_memory_test
