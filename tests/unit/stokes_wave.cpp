// Waves of finite height: the equations of the flow, published solutions, limits and refusals.
#include "hawser/kernels/stokes_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace hawser::stokes_wave_test {
namespace {

constexpr double kG = 9.80665;

StokesInput input(double height, double period, double depth) {
  StokesInput in;
  in.height = height;
  in.period = period;
  in.depth = depth;
  in.gravity = kG;
  return in;
}

// Largest violation of the two surface conditions in the frame of the crest: flow along the surface, and
// Bernoulli's law; relative to speed and pressure there.
struct Residual {
  double flow = 0, pressure = 0;
};
Residual residual(const StokesWave& w) {
  Residual r;
  const double c = w.omega() / w.number();
  for (int i = 0; i <= 200; ++i) {
    const double x = w.length() * i / 200;
    const double h = 1e-5 * w.length();
    const double eta = w.at({x, 0, 0}, 0).surface;
    const double slope = (8 * (w.at({x + h, 0, 0}, 0).surface - w.at({x - h, 0, 0}, 0).surface) -
                          (w.at({x + 2 * h, 0, 0}, 0).surface - w.at({x - 2 * h, 0, 0}, 0).surface)) /
                         (12 * h);
    const WaveMotion m = w.at({x, 0, eta}, 0);
    const double u = m.velocity.x() - c;
    const double v = m.velocity.z();
    r.flow = std::max(r.flow, std::abs(u * slope - v) / c);
    const double head = 0.5 * (u * u + v * v) + kG * (w.depth() + eta);
    r.pressure = std::max(r.pressure, std::abs(head - w.head()) / (c * c));
  }
  return r;
}

// Both are of sixth order in the steepness, for any depth, with and without current. A wrong coefficient
// would leave an error of lower order.
TEST(StokesWave, ConditionsAtTheSurfaceAreOfSixthOrder) {
  for (const double depth : {0.0, 200.0, 30.0, 12.0})
    for (const double current : {0.0, 1.0, -0.7})
      for (const bool transport : {false, true}) {
        // Half the height at the same length, so that the order is that of k H/2 alone.
        const auto of = [&](double height) {
          StokesInput in = input(height, 9, depth);
          in.current = current;
          in.transport = transport;
          const double length = depth > 0 && depth < 20 ? 80 : 120;
          double low = 3, high = 40;  // the period of that length
          for (int i = 0; i < 200; ++i) {
            in.period = 0.5 * (low + high);
            (StokesWave(in).length() < length ? low : high) = in.period;
          }
          return residual(StokesWave(in));
        };
        const double H = depth > 0 && depth < 20 ? 2 : 8;
        const Residual all = of(H);
        const Residual half = of(H / 2);
        const double flow = std::log2(all.flow / half.flow);
        const double pressure = std::log2(all.pressure / half.pressure);
        if (current == 0 && !transport)
          printf("  depth %g m: flow %.1e (order %.2f), pressure %.1e (order %.2f)\n", depth, all.flow, flow,
                 all.pressure, pressure);
        EXPECT_GT(flow, 5.7) << depth;
        EXPECT_GT(pressure, 5.7) << depth;
        EXPECT_LT(all.flow, 2e-3) << depth;
        EXPECT_LT(all.pressure, 2e-3) << depth;
      }
}

// The flow has no divergence and no rotation, and does not pass the bed; minus the acceleration of the water
// is the gradient of pressure. The same with a ramp.
TEST(StokesWave, IsPotentialFlow) {
  StokesInput in = input(6, 9, 35);
  in.direction = 0.7;
  in.phase = 0.4;
  in.current = 0.8;
  const StokesWave w(in);
  const double h = 1e-3, factor = 0.6, rate = 0.3;
  for (const Vec3& x : {Vec3(3, -2, -5), Vec3(40, 10, -2.5), Vec3(-7, 100, -34)})
    for (const double t : {0.0, 4.2}) {
      const auto gradient = [&](auto value) {
        Mat3 g;
        for (int i = 0; i < 3; ++i)
          g.col(i) = (value(x + h * Vec3::Unit(i), t) - value(x - h * Vec3::Unit(i), t)) / (2 * h);
        return g;
      };
      const auto velocity = [&](const Vec3& p, double s) { return w.at(p, s).velocity; };
      const auto acceleration = [&](const Vec3& p, double s) { return w.at(p, s).acceleration; };
      const Mat3 g = gradient(velocity);
      EXPECT_NEAR(g.trace(), 0, 1e-7);
      EXPECT_LT((g - g.transpose()).norm(), 1e-7);
      const Mat3 of_pressure = gradient(acceleration);
      EXPECT_LT((of_pressure - of_pressure.transpose()).norm(), 1e-6);
      const Vec3 by_time = (velocity(x, t + h) - velocity(x, t - h)) / (2 * h);
      const Vec3 v = velocity(x, t);
      EXPECT_LT((by_time + g * v - acceleration(x, t)).norm(), 1e-6);
      const WaveMotion part = w.at(x, t, factor, rate);
      EXPECT_LT((factor * by_time + factor * factor * g * v + rate * v - part.acceleration).norm(), 1e-6);
      EXPECT_LT((part.velocity - factor * v).norm(), 1e-14);
    }
  EXPECT_EQ(w.at({5, 6, -35}, 1).velocity.z(), 0);
}

// Minus the acceleration of the water is the gradient of the pressure, which is zero at the surface.
TEST(StokesWave, HeadIsItsPressure) {
  StokesInput in = input(6, 9, 35);
  in.direction = 0.7;
  in.phase = 0.4;
  in.current = 0.8;
  const StokesWave w(in);
  const double h = 1e-3;
  const double t = 4.2;
  for (const Vec3& x : {Vec3(3, -2, -5), Vec3(40, 10, -3.5), Vec3(-7, 100, -34)}) {
    Vec3 gradient;
    for (int i = 0; i < 3; ++i)
      gradient[i] = (w.head_at(x + h * Vec3::Unit(i), t) - w.head_at(x - h * Vec3::Unit(i), t)) / (2 * h);
    EXPECT_LT((kG * gradient + w.at(x, t).acceleration).norm(), 1e-5);
  }
  for (double x = 0; x < 120; x += 7) {
    const double crest = w.at({x, 0, 0}, t).surface;
    EXPECT_NEAR(w.head_at({x, 0, crest}, t), crest, 5e-3);
    EXPECT_EQ(w.head_at({x, 0, 50}, t), w.head_at({x, 0, crest}, t));
  }
}

// The difference of fluxes through two planes is the rate of volume between them; the mean flux is that of
// `transport`.
TEST(StokesWave, ContinuityAndTransport) {
  for (const bool transport : {false, true})
    for (const double current : {0.0, 0.5}) {
      StokesInput in = input(2, 8, 20);
      in.current = current;
      in.transport = transport;
      const StokesWave w(in);
      const auto flux = [&](double x, double t) {  // Simpson from the bed to the surface
        const double top = w.at({x, 0, 0}, t).surface;
        const double step = (top + 20) / 400;
        double sum = 0;
        for (int i = 0; i <= 400; ++i)
          sum += (i == 0 || i == 400 ? 1 : i % 2 ? 4 : 2) * w.at({x, 0, -20 + i * step}, t).velocity.x();
        return sum * step / 3;
      };
      double mean = 0, at_a_place = 0;
      for (int i = 0; i < 64; ++i) {
        const double t = in.period * i / 64;
        const double h = 1e-4;
        mean += flux(3, t) / 64;
        at_a_place += w.at({3, 0, -15}, t).velocity.x() / 64;
        const double filled = (w.at({3, 0, 0}, t + h).surface - w.at({3, 0, 0}, t - h).surface) / (2 * h);
        EXPECT_NEAR((flux(3 + h, t) - flux(3 - h, t)) / (2 * h), -filled, 1e-3 * M_PI * 2 / 8);
      }
      printf("  current %g, %s: transport %.6f, at a place %.6f m/s\n", current,
             transport ? "transport" : "Euler", mean / 20, at_a_place);
      if (transport)
        EXPECT_NEAR(mean / 20, current, 1e-5);
      else
        EXPECT_NEAR(at_a_place, current, 1e-12);
      EXPECT_GT(mean / 20, at_a_place + 0.01);
    }
}

// Fenton's program, fifth-order Stokes, H/d 0.3, L/d 8 (its output as published with FentonStokesClass,
// Tsai): period, speed, constants, and coefficients of surface and potential.
TEST(StokesWave, FentonsProgram) {
  StokesInput in;
  in.gravity = 1;
  in.depth = 1;
  in.height = 0.3;
  double low = 5, high = 12;
  for (int i = 0; i < 200; ++i) {
    in.period = 0.5 * (low + high);
    (StokesWave(in).length() < 8 ? low : high) = in.period;
  }
  const StokesWave w(in);
  EXPECT_NEAR(in.period, 8.5184, 6e-5);
  EXPECT_NEAR(w.omega() / w.number(), 0.9391, 6e-5);
  EXPECT_NEAR(w.drift(), 0, 1e-14);
  EXPECT_NEAR(w.head(), 1.4443, 6e-5);
  const double surface[] = {1.1085623e-001, 2.7030818e-002, 6.3316832e-003, 2.1243859e-003, 6.2180771e-004};
  const double potential[] = {1.3411476e-001, 1.5378594e-002, 1.4247651e-003, 3.5681394e-005,
                              -2.3287527e-005};
  const double k = w.number();
  const double kd = k;
  for (int j = 1; j <= 5; ++j) {
    // By projection over a period: elevation, and velocity at the bed, where cosh is 1.
    double eta = 0, u = 0;
    for (int i = 0; i < 32; ++i) {
      const double x = 8.0 * i / 32;
      const double c = std::cos(j * k * x) / 16;
      eta += c * w.at({x, 0, 0}, 0).surface;
      u += c * w.at({x, 0, -1}, 0).velocity.x();
    }
    EXPECT_NEAR(k * eta, surface[j - 1], 6e-9) << j;
    EXPECT_NEAR(u * std::sqrt(k) * std::cosh(j * kd) / j, potential[j - 1], 6e-9) << j;
  }
}

// Exact waves of the same program (Fourier method, 20 terms): a moderate one in shallow water, and one of 86
// % of the highest in deeper water, by its period.
TEST(StokesWave, NearExactWaves) {
  StokesInput in;
  in.gravity = 1;
  in.depth = 1;
  in.height = 0.3;
  in.period = 8.5153;
  const StokesWave shallow(in);
  EXPECT_NEAR(shallow.length(), 8, 0.001 * 8);
  in.height = 0.2;
  in.period = 3;
  const StokesWave steep(in);
  printf("  length %+.2f %%, %+.2f %%\n", 100 * (shallow.length() / 8 - 1),
         100 * (steep.length() / 1.6526 - 1));
  EXPECT_NEAR(steep.length(), 1.6526, 0.002 * 1.6526);
}

// At zero height the wave is Airy's, with an error of order H²; deep water is the limit of increasing depth.
TEST(StokesWave, Limits) {
  double last = 0;
  for (const double height : {0.2, 0.02, 0.002}) {
    const StokesWave w(input(height, 8, 25));
    const WaveField airy({w.component()}, 25, kG, Stretching::none);
    EXPECT_NEAR(w.number(), wave_number(w.omega(), 25, kG), 1e-2 * height * height);
    double off = 0;
    for (const double t : {0.3, 2.0, 5.1}) {
      const Vec3 x(4, 0, -3);
      off = std::max(off, (w.at(x, t).velocity - airy.at(x, t).velocity).norm());
      off = std::max(off, std::abs(w.at({4, 0, 0}, t).surface - airy.at({4, 0, 0}, t).surface));
    }
    if (last > 0) {
      EXPECT_NEAR(last / off, 100, 5);
    }
    last = off;
  }
  const StokesWave deep(input(10, 10, 0));
  const StokesWave deeper(input(10, 10, 5000));
  const StokesWave far(input(10, 10, 90));
  EXPECT_NEAR(deep.number(), deeper.number(), 1e-15);
  EXPECT_NEAR(deep.number(), far.number(), 1e-4);
  // omega² = g k (1 + e²/2 + e⁴/8)² on deep water.
  const double e = 5 * deep.number();
  const double f = 1 + e * e / 2 + e * e * e * e / 8;
  EXPECT_NEAR(deep.omega() * deep.omega(), kG * deep.number() * f * f, 1e-14);
  EXPECT_LT(deep.at({0, 0, -4000}, 0).velocity.norm(), 1e-7);
  EXPECT_LT((deep.at({10, 0, -30}, 1).velocity - deeper.at({10, 0, -30}, 1).velocity).norm(), 1e-12);
}

std::string refusal(const StokesInput& in) {
  try {
    const StokesWave w(in);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(StokesWave, RefusesWhatIsNoWave) {
  // 0.141 of the length in deep water, 0.83 of the depth in shallow water.
  EXPECT_NEAR(highest_wave(100, 0), 14.1063, 1e-12);
  EXPECT_NEAR(highest_wave(100, 1000), 14.1063, 0.07);
  EXPECT_NEAR(highest_wave(1e5, 1), 0.8332, 1e-3);
  EXPECT_NE(refusal(input(22, 8, 0)).find("breaks at a height of"), std::string::npos);
  EXPECT_NE(refusal(input(1, 20, 5)).find("too long for its depth"), std::string::npos);
  StokesInput against = input(2, 6, 0);
  against.current = -4;
  EXPECT_NE(refusal(against).find("can run against"), std::string::npos);
  against.current = -1;
  EXPECT_EQ(refusal(against), "");
  EXPECT_NE(refusal(input(0, 6, 0)).find("needs a height"), std::string::npos);
}

}  // namespace
}  // namespace hawser::stokes_wave_test
