// Wave forces on platforms by fast sums, against direct sums over components and pairs.
#include "hawser/kernels/platform_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::platform_waves_test {
namespace {

std::vector<WaveComponent> sea() {
  std::vector<WaveComponent> out;
  for (int i = 0; i < 12; ++i) {
    WaveComponent w;
    w.omega = 0.4 + 0.07 * i;
    w.number = w.omega * w.omega / 9.81;
    w.amplitude = 1 + 0.3 * std::sin(i);
    w.phase = 0.9 * i * i;
    w.x = std::cos(0.3);
    w.y = std::sin(0.3);
    out.push_back(w);
  }
  return out;
}

DifferenceForceTable difference() {
  std::vector<double> omega;
  for (int i = 0; i < 8; ++i) omega.push_back(0.35 + 0.15 * i);
  std::vector<ComplexVec6> values(64, ComplexVec6::Zero());
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k : {0, 4})
        values[static_cast<size_t>(8 * i + j)][k] =
            Complex((3 - 0.2 * (i + j)) * (k - 2), (i - j) * 0.4);  // Hermitian
  return {omega, values};
}

WaveForceTable mean() {
  std::vector<double> omega;
  std::vector<ComplexVec6> values;
  for (int i = 0; i < 8; ++i) {
    omega.push_back(0.35 + 0.15 * i);
    values.push_back(ComplexVec6::Zero());
    values.back()[0] = 1 + i;
    values.back()[1] = 3 - i;
  }
  return {omega, {0}, values};
}

// (re cos - im sin) of a single wave, for a rotated body away from the origin.
TEST(PlatformWaves, FirstOrderLeadsTheCrest) {
  std::vector<ComplexVec6> values(4, ComplexVec6::Zero());
  values[0][2] = Complex(1, 2);
  values[1][2] = Complex(3, 4);  // 0 deg
  values[2][2] = Complex(5, -6);
  values[3][2] = Complex(7, 8);  // 90 deg
  const WaveForceTable table({0.5, 1.0}, {0, M_PI / 2}, values);
  WaveComponent w;
  w.omega = 0.75;
  w.amplitude = 2;
  w.phase = 0.4;
  w.number = 0.06;
  w.x = std::cos(0.9);
  w.y = std::sin(0.9);
  const PlatformWaves waves({w}, 0.9 - M_PI / 4, table, Eigen::Vector2d::Zero(), {}, {}, SecondOrder::none);
  const Complex X = 0.25 * (Complex(1, 2) + Complex(3, 4) + Complex(5, -6) + Complex(7, 8));
  const double t = 3.1, x = 12, y = -5;
  const double phase = 0.75 * t - 0.06 * (w.x * x + w.y * y) - 0.4;
  EXPECT_NEAR(waves.at(t, x, y).first[2], (2.0 * X * std::polar(1.0, phase)).real(), 1e-12);
  EXPECT_EQ(waves.at(t, x, y).slow.norm(), 0);
}

TEST(PlatformWaves, FullDriftIsTheDoubleSum) {
  const auto components = sea();
  const DifferenceForceTable table = difference();
  const PlatformWaves waves(components, 0, {}, Eigen::Vector2d::Zero(), {}, table, SecondOrder::full);
  for (const double t : {0.0, 17.0, 230.5}) {
    Vec6 sum = Vec6::Zero(), average = Vec6::Zero();
    for (const WaveComponent& a : components)
      for (const WaveComponent& b : components) {
        const ComplexVec6 F = a.amplitude * b.amplitude * table.at(a.omega, b.omega);
        sum += (F * std::polar(1.0, (a.omega - b.omega) * t - a.phase + b.phase)).real();
        if (&a == &b) average += F.real();
      }
    EXPECT_LT((waves.mean_drift() - average).norm(), 1e-12 * average.norm());
    EXPECT_LT((waves.mean_drift() + waves.at(t, 0, 0).slow - sum).norm(), 1e-3 * average.norm()) << t;
  }
}

// sqrt(D_i D_j) if both have the same sign, else 0 (Standing, Brendling and Wilson 1987).
TEST(PlatformWaves, NewmanIsTheDoubleSumOfRoots) {
  const auto components = sea();
  const PlatformWaves waves(components, 0, {}, Eigen::Vector2d::Zero(), mean(), {}, SecondOrder::newman);
  for (const double t : {0.0, 17.0, 230.5}) {
    Vec6 sum = Vec6::Zero();
    for (const WaveComponent& a : components)
      for (const WaveComponent& b : components)
        for (int k = 0; k < 6; ++k) {
          const double A = mean().at(a.omega, 0.3)[k].real();
          const double B = mean().at(b.omega, 0.3)[k].real();
          if (A * B <= 0) continue;
          sum[k] += a.amplitude * b.amplitude * std::copysign(std::sqrt(A * B), A) *
                    std::cos((a.omega - b.omega) * t - a.phase + b.phase);
        }
    EXPECT_LT((waves.mean_drift() + waves.at(t, 0, 0).slow - sum).norm(), 1e-12 * (1 + sum.norm())) << t;
  }
}

// Forces whose size varies linearly with frequency and direction and whose phases are those of an origin at
// -c: with phases at c they are interpolated exactly, and lose a third or more otherwise.
TEST(PlatformWaves, InterpolatesWithPhasesAtTheCentre) {
  const Eigen::Vector2d c(25, -15);
  const auto number = [](double omega) { return omega * omega / 9.81; };
  const auto at_centre = [](double omega, double direction) {
    return ComplexVec6::Constant((3 + direction + omega) * std::polar(1.0, 0.4)).eval();
  };
  const auto phase = [&](double omega, double direction) {
    return std::polar(1.0, -number(omega) * (c.x() * std::cos(direction) + c.y() * std::sin(direction)));
  };
  const std::vector<double> omega = {0.8, 1.2}, directions = {0, 0.6, 1.2};
  std::vector<ComplexVec6> values;
  for (const double b : directions)
    for (const double w : omega) values.push_back(phase(w, b) * at_centre(w, b));
  const WaveForceTable table(omega, directions, values);
  const WaveForceTable moved = table.with_phases_at(c, {number(0.8), number(1.2)});
  for (const double b : {0.0, 0.2, 0.6, 0.9})
    for (const double w : {0.8, 0.95, 1.2})
      EXPECT_LT((moved.at(w, b) - at_centre(w, b)).norm(), 1e-13 * at_centre(w, b).norm()) << w << " " << b;
  EXPECT_LT(table.at(1.2, 0.9).norm(), 0.7 * at_centre(1.2, 0.9).norm());
  EXPECT_LT(table.at(1, 0).norm(), 0.7 * at_centre(1, 0).norm());

  // The force is that of the table of the origin, in a wave with its crest there, for a turned body.
  WaveComponent wave;
  wave.omega = 1.2;
  wave.number = number(1.2);
  wave.amplitude = 2;
  wave.x = std::cos(0.6 + 0.3);
  wave.y = std::sin(0.6 + 0.3);
  const PlatformWaves waves({wave}, 0.3, moved, c, {}, {}, SecondOrder::none);
  EXPECT_LT((waves.at(0, 0, 0).first - 2 * table.at(1.2, 0.6).real()).norm(), 1e-12);
}

// A body that turns to another heading has the wave forces of a body made at that heading, and the derivative
// of its mean drift is the slope of the table.
TEST(PlatformWaves, TurnsToAnotherHeading) {
  std::vector<ComplexVec6> values;
  for (int k = 0; k < 24; ++k) {
    values.emplace_back();
    for (int i = 0; i < 6; ++i) values.back()[i] = Complex(std::sin(k + i), std::cos(2.0 * k - i));
  }
  const WaveForceTable table({0.4, 0.9, 1.4}, {0, 0.7, 1.5, 2.4, 3.3, 4.2, 5, 5.9}, values);
  for (const SecondOrder order : {SecondOrder::mean, SecondOrder::newman}) {
    PlatformWaves turned(sea(), 0.1, table, Eigen::Vector2d::Zero(), table, {}, order);
    const PlatformWaves made(sea(), 2.2, table, Eigen::Vector2d::Zero(), table, {}, order);
    EXPECT_GT((turned.at(3, 1, 2).first - made.at(3, 1, 2).first).norm(), 0.1);
    turned.turn_to(2.2);
    const auto a = turned.at(3, 1, 2);
    const auto b = made.at(3, 1, 2);
    EXPECT_LT((a.first - b.first).norm(), 1e-12);
    EXPECT_LT((a.slow - b.slow).norm(), 1e-12);
    EXPECT_LT((turned.mean_drift() - made.mean_drift()).norm(), 1e-12);
    const double e = 1e-6;
    const auto mean = turned.mean_drift(2.2);
    const Vec6 found = (turned.mean_drift(2.2 + e).force - turned.mean_drift(2.2 - e).force) / (2 * e);
    EXPECT_GT(mean.by_heading.norm(), 0.1);
    EXPECT_LT((mean.by_heading - found).norm(), 1e-7 * found.norm());
    EXPECT_LT((mean.force - made.mean_drift()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace hawser::platform_waves_test
