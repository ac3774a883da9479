// Waves: dispersion, kinematics, stretching, pressure and spectra, against closed forms and sums by the C
// library.
#include "hawser/kernels/waves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <map>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::waves_test {
namespace {

constexpr double kG = 9.80665, kRho = 1025;

// Root of omega² = g k tanh kh by Brent's method to round-off.
TEST(Waves, Dispersion) {
  struct Row {
    double depth, period, k;
  };
  const Row rows[] = {{10.0, 4.0, 0.2547097348825959},      {10.0, 6.0, 0.12983315897623712},
                      {10.0, 8.0, 0.08864112882243126},     {10.0, 10.0, 0.06803237213195777},
                      {10.0, 12.0, 0.05546706557617877},    {10.0, 16.0, 0.0407249315843566},
                      {10.0, 20.0, 0.03226617171780885},    {20.0, 4.0, 0.25162629833724487},
                      {20.0, 6.0, 0.11417252815404104},     {20.0, 8.0, 0.07078053498187946},
                      {20.0, 10.0, 0.05183725263394577},    {20.0, 12.0, 0.04124785303723828},
                      {20.0, 16.0, 0.029597765631646837},   {20.0, 20.0, 0.023213250155773777},
                      {50.0, 4.0, 0.2516048905926807},      {50.0, 6.0, 0.11182750728665393},
                      {50.0, 8.0, 0.06312967213742765},     {50.0, 10.0, 0.04154100063032464},
                      {50.0, 12.0, 0.03068285739701696},    {50.0, 16.0, 0.020416895955711882},
                      {50.0, 20.0, 0.015492591910462195},   {100.0, 4.0, 0.25160489058672836},
                      {100.0, 6.0, 0.11182439585963716},    {100.0, 8.0, 0.06290165528224717},
                      {100.0, 10.0, 0.04028231709999276},   {100.0, 12.0, 0.02815717684301577},
                      {100.0, 16.0, 0.01684626685751947},   {100.0, 20.0, 0.012050297240794658},
                      {320.0, 4.0, 0.25160489058672836},    {320.0, 6.0, 0.1118243958163237},
                      {320.0, 8.0, 0.06290122264668209},    {320.0, 10.0, 0.04025678249439721},
                      {320.0, 12.0, 0.027956099902830118},  {320.0, 16.0, 0.015726643646077804},
                      {320.0, 20.0, 0.010095702352896266},  {2000.0, 4.0, 0.25160489058672836},
                      {2000.0, 6.0, 0.1118243958163237},    {2000.0, 8.0, 0.06290122264668209},
                      {2000.0, 10.0, 0.040256782493876535}, {2000.0, 12.0, 0.02795609895408092},
                      {2000.0, 16.0, 0.015725305661670522}, {2000.0, 20.0, 0.010064195623469134}};
  for (const Row& r : rows) EXPECT_NEAR(wave_number(2 * M_PI / r.period, r.depth, kG), r.k, 1e-12 * r.k);
  EXPECT_NEAR(wave_number(0.5, 0, kG), 0.25 / kG, 1e-17);
  EXPECT_NEAR(wave_number(1e-4, 10, kG), 1e-4 / std::sqrt(kG * 10), 1e-8 * 1e-5);  // shallow
}

WaveField regular(double height, double period, double depth, Stretching s = Stretching::none,
                  double phase = 0) {
  WaveComponent c;
  c.amplitude = height / 2;
  c.omega = 2 * M_PI / period;
  c.phase = phase;
  return WaveField({c}, depth, kG, s);
}

// An irregular sea summed over components with the functions of the C library, for large x and y and late
// times. The difference is the rounding of angles if no components are excluded, and below the exclusion
// tolerance otherwise. For an ordinary sea, and for one with almost all energy in short waves.
TEST(Waves, SumsOverComponents) {
  for (const double depth : {0.0, 30.0, 200.0}) {
    std::vector<WaveComponent> sea = irregular(Jonswap{6, 11, 3.3}, 0.4, 400, 7, 5);
    for (WaveComponent& c : sea) c.number = wave_number(c.omega, depth, kG);
    for (const bool ripples : {false, true}) {
      for (WaveComponent& c : sea)
        if (ripples && c.omega < 2) c.amplitude *= 1e-5;
      const WaveSums sums(sea, depth);
      const double x = -731.7;
      const double y = 412.3;
      const double t = 10795.3;
      const double bottom = depth > 0 ? depth : 400;
      double speed = 0, growth = 0, surface = 0;
      for (const WaveComponent& c : sea) {
        speed += c.amplitude * c.omega;
        growth += c.amplitude * c.omega * c.omega;
        surface += c.amplitude * std::cos(c.number * (c.x * x + c.y * y) - c.omega * t + c.phase);
      }
      WaveSums::Phases phases;
      sums.phases(x, y, t, sums.size(), phases);
      EXPECT_NEAR(phases.surface, surface, 1e-11 * speed);
      bool excluded = false;
      for (const double z : {2.0, 0.0, -0.1, -1.0, -10.0, -0.5 * bottom, -0.9 * bottom, -bottom}) {
        Vec3 u = Vec3::Zero(), a = Vec3::Zero(), u0 = Vec3::Zero(), a0 = Vec3::Zero();
        double most = 0;
        for (const WaveComponent& c : sea) {
          const double k = c.number;
          const double angle = k * (c.x * x + c.y * y) - c.omega * t + c.phase;
          const double down = depth > 0 ? std::exp(-2 * k * depth) : 0;
          const double e = c.amplitude * c.omega * std::exp(k * z) / (1 - down);
          const double back =
              depth > 0 ? c.amplitude * c.omega * std::exp(-k * (2 * depth + z)) / (1 - down) : 0;
          const Vec3 along(c.x, c.y, 0);
          const Vec3 up(0, 0, 1);
          u0 += (e + back) * std::cos(angle) * along + (e - back) * std::sin(angle) * up;
          a0 += c.omega * ((e + back) * std::sin(angle) * along - (e - back) * std::cos(angle) * up);
          if (2 * std::exp(k * z) > WaveSums::kNegligible) most = std::max(most, k);
        }
        sums.add_motion(phases, z, u, a);
        const bool all = most >= sea.back().number;
        excluded |= !all && (u - u0).norm() > 2e-10 * speed;  // more than rounding
        EXPECT_LE((u - u0).norm(), (all ? 1e-10 : WaveSums::kNegligible) * speed) << depth << " " << z;
        EXPECT_LE((a - a0).norm(), (all ? 1e-10 : WaveSums::kNegligible) * growth) << depth << " " << z;
      }
      EXPECT_TRUE(excluded) << depth << (ripples ? ", ripples" : "");
    }
  }
}

// Components that are excluded at the bed do not affect the motion there: against the field with all
// components at their common elevation. Components are excluded only at a bed with Wheeler's stretching.
TEST(Waves, PlacesAtTheBedSumSignificantComponents) {
  for (const double depth : {0.0, 200.0})
    for (const Stretching s : {Stretching::none, Stretching::vertical, Stretching::wheeler}) {
      std::vector<WaveComponent> sea = irregular(Jonswap{4, 9, 3.3}, 0.4, 400, 7, 0);
      const WaveField field(sea, depth, kG, s);
      for (WaveComponent& c : sea) c.number = wave_number(c.omega, depth, kG);
      const WaveSums sums(sea, depth);
      double speed = 0, growth = 0;
      for (const WaveComponent& c : sea) {
        speed += c.amplitude * c.omega;
        growth += c.amplitude * c.omega * c.omega;
      }
      int fewer = 0;
      for (const double z : {-40.0, -80.0, -120.0, -180.0, -199.0, -199.99, -200.0})
        for (double t = 100; t < 130; t += 7) {
          WaveSums::Phases all;
          sums.phases(12, -5, t, sums.size(), all);
          const double eta = all.surface;
          const double there = s != Stretching::wheeler ? z
                               : depth > 0              ? depth * (z - eta) / (depth + eta)
                                                        : z - eta;
          Vec3 u = Vec3::Zero(), a = Vec3::Zero();
          sums.add_motion(all, there, u, a);
          const WaveMotion m = field.at({12, -5, z}, t);
          fewer += m.surface != eta;
          EXPECT_LE((m.velocity - u).norm(), 2 * WaveSums::kNegligible * speed) << depth << " " << z;
          EXPECT_LE((m.acceleration - a).norm(), 2 * WaveSums::kNegligible * growth) << depth << " " << z;
        }
      EXPECT_EQ(fewer > 0, depth > 0 && s == Stretching::wheeler) << depth << " " << static_cast<int>(s);
    }
}

// A long swell, and waves that are too short to reach the bed, in one vector.
TEST(Waves, AtTheBedUnderSwellAndShortWaves) {
  constexpr double depth = 1000;
  WaveComponent swell, chop;
  swell.amplitude = 2;
  swell.omega = 2 * M_PI / 25;
  chop.amplitude = 0.3;
  chop.omega = 2 * M_PI / 2;
  for (const Stretching s : {Stretching::none, Stretching::vertical, Stretching::wheeler}) {
    const WaveField both({swell, chop}, depth, kG, s);
    const WaveField one({swell}, depth, kG, s);
    const WaveMotion m = both.at({10, 0, -depth}, 3);
    const WaveMotion n = one.at({10, 0, -depth}, 3);
    EXPECT_GT(n.velocity.norm(), 1e-6);
    EXPECT_LE((m.velocity - n.velocity).norm(), 1e-12);
    EXPECT_LE((m.acceleration - n.acceleration).norm(), 1e-12);
  }
}

// The velocity field has no divergence and no rotation, satisfies the condition at the moving surface to
// first order, and is zero at the bed; its acceleration is its time derivative.
TEST(Waves, IsPotentialFlow) {
  const double a = 1e-4, depth = 30, h = 1e-3;
  WaveComponent c, d;
  c.amplitude = a;
  c.omega = 0.7;
  c.phase = 0.3;
  c.x = 0.6;
  c.y = 0.8;
  d.amplitude = 0.5 * a;
  d.omega = 1.1;
  d.phase = -1;
  d.x = 0;
  d.y = -1;
  const WaveField w({c, d}, depth, kG, Stretching::none);
  for (const Vec3& x : {Vec3(3, -2, -5), Vec3(40, 10, -0.1), Vec3(-7, 100, -29)}) {
    const double t = 4.2;
    Mat3 grad;
    for (int i = 0; i < 3; ++i)
      grad.col(i) =
          (w.at(x + h * Vec3::Unit(i), t).velocity - w.at(x - h * Vec3::Unit(i), t).velocity) / (2 * h);
    EXPECT_NEAR(grad.trace(), 0, 1e-8 * a);
    EXPECT_LT((grad - grad.transpose()).norm(), 1e-8 * a);
    const Vec3 rate = (w.at(x, t + h).velocity - w.at(x, t - h).velocity) / (2 * h);
    EXPECT_LT((rate - w.at(x, t).acceleration).norm(), 1e-6 * a);
    const double rise =
        (w.at({x.x(), x.y(), 0}, t + h).surface - w.at({x.x(), x.y(), 0}, t - h).surface) / (2 * h);
    EXPECT_NEAR(w.at({x.x(), x.y(), -1e-9}, t).velocity.z(), rise, 1e-5 * a);
    EXPECT_NEAR(w.at({x.x(), x.y(), -depth}, t).velocity.z(), 0, 1e-12 * a);
  }
}

// Below the still water rho du/dt = -grad p, in waves of several directions. At the surface and above it the
// head equals the elevation, for any depth.
TEST(Waves, HeadIsTheirPressure) {
  for (const double depth : {0.0, 15.0, 200.0}) {
    const std::vector<WaveComponent> sea = {{0.8, 0.6, 0, 1, 0, 0.3}, {0.4, 1.1, 0, 0.6, 0.8, 1.7}};
    const WaveField flat(sea, depth, kG, Stretching::vertical);
    const double h = 1e-3;
    const double t = 3.1;
    for (const Vec3& x : {Vec3(3, -2, -1), Vec3(40, 10, -6), Vec3(-7, 100, -14.5)}) {
      Vec3 gradient;
      for (int i = 0; i < 3; ++i)
        gradient[i] = (flat.head(x + h * Vec3::Unit(i), t) - flat.head(x - h * Vec3::Unit(i), t)) / (2 * h);
      EXPECT_LT((kG * gradient + flat.at(x, t).acceleration).norm(),
                1e-4 * flat.at(x, t).acceleration.norm());
      EXPECT_NEAR(flat.head(x, t, 0.4), 0.4 * flat.head(x, t), 1e-14);
    }
    for (const Stretching stretching : {Stretching::wheeler, Stretching::vertical, Stretching::none}) {
      const WaveField waves(sea, depth, kG, stretching);
      for (double s = 0; s < 12; s += 0.7) {
        const double crest = waves.at({5, 1, 0}, s).surface;
        if (crest > 0 || stretching == Stretching::wheeler) {
          EXPECT_NEAR(waves.head({5, 1, crest}, s), crest, 1e-12);
        }
        EXPECT_NEAR(waves.head({5, 1, 30}, s), waves.head({5, 1, std::max(crest, 0.0)}, s), 0.2);
      }
    }
  }
}

// In-line force and moment on a pile of 1 m, Cd 1.2, Cm 2: closed forms of the integrals to the still water
// (linear), and of the drag under the crest to the surface by three stretchings; also the surface velocity.
TEST(Waves, ForceOnAPile) {
  struct Row {
    double height, period, depth, inertia, drag, moment_inertia, moment_drag, wheeler, constant;
  };
  for (const Row& r :
       {Row{5, 10, 50, 38253.09106, 21306.14732, 1196872.163, 783995.4772, 22371.45468169, 25345.67569228},
        {10, 12, 100, 78383.00026, 78431.32216, 5368991.901, 6361846.696, 82352.88826795, 99811.30991994},
        {2, 6, 20, 15464.62383, 3301.754562, 198901.83, 50238.50987, 3466.84229, 0}}) {
    const auto integrate = [&](Stretching s, double top, double phase, bool drag, bool moment) {
      const WaveField w = regular(r.height, r.period, r.depth, s, phase);
      const int n = 4000;
      double sum = 0;
      for (int i = 0; i < n; ++i) {
        const double z = -r.depth + (i + 0.5) * (r.depth + top) / n;
        const WaveMotion m = w.at({0, 0, z}, 0);
        const double q = drag ? 0.5 * kRho * 1.2 * std::abs(m.velocity.x()) * m.velocity.x()
                              : 2 * kRho * M_PI / 4 * m.acceleration.x();
        sum += q * (moment ? z + r.depth : 1) * (r.depth + top) / n;
      }
      return sum;
    };
    const double quarter = M_PI / 2;  // a quarter of the period before the crest
    EXPECT_NEAR(integrate(Stretching::none, 0, 0, true, false), r.drag, 1e-5 * r.drag);
    EXPECT_NEAR(integrate(Stretching::none, 0, 0, true, true), r.moment_drag, 1e-5 * r.moment_drag);
    EXPECT_NEAR(std::abs(integrate(Stretching::none, 0, quarter, false, false)), r.inertia, 1e-5 * r.inertia);
    EXPECT_NEAR(std::abs(integrate(Stretching::none, 0, quarter, false, true)), r.moment_inertia,
                1e-5 * r.moment_inertia);
    EXPECT_NEAR(integrate(Stretching::wheeler, r.height / 2, 0, true, false), r.wheeler, 1e-5 * r.wheeler);
    if (r.constant > 0) {
      EXPECT_NEAR(integrate(Stretching::vertical, r.height / 2, 0, true, false), r.constant,
                  1e-5 * r.constant);
    }
  }
  // Acceleration and velocity are out of phase: at the crest the horizontal acceleration is zero.
  EXPECT_NEAR(regular(5, 10, 50).at({0, 0, -3}, 0).acceleration.x(), 0, 1e-15);
  EXPECT_GT(regular(5, 10, 50).at({0, 0, -3}, -2.5).acceleration.x(),
            0);  // the water accelerates before the crest
}

// Moments by quadrature to 1e-12, scaled so that m0 is Hs²/16, against those of many components. The
// components end at ten times the peak frequency, and the energy beyond is distributed over them; the test
// reverses this.
TEST(Waves, JonswapMoments) {
  struct Row {
    double height, period, gamma, m_1, m0, m1, m2, m4;  // m4 up to five times the peak's frequency
  };
  for (const Row& r : {Row{5, 10, 1, 2.131737564, 1.5625, 1.272070535, 1.222389767, 1.71664998},
                       {5, 10, 3.3, 2.246312538, 1.5625, 1.176692796, 1.020684631, 1.216563058},
                       {5, 10, 5, 2.285846082, 1.5625, 1.143769416, 0.9512172023, 1.045011517},
                       {2, 12, 3.3, 0.4312920072, 0.25, 0.1568923728, 0.1134094035, 0.09387060636},
                       {10, 14, 2, 12.30421592, 6.25, 3.4788649, 2.259427512, 1.489491425}}) {
    const double peak = 2 * M_PI / r.period;
    const auto sea = irregular(Jonswap{r.height, r.period, r.gamma}, 0, 20000, 1);
    const auto moment = [&](int n, double to) {
      double sum = 0;
      for (const WaveComponent& c : sea)
        if (c.omega < to * peak) sum += 0.5 * c.amplitude * c.amplitude * std::pow(c.omega, n);
      return sum;
    };
    // Far above the peak the density is tail * omega^-5.
    const double end = 10 * peak;
    const double tail = 4 * (moment(0, 10) - moment(0, 8)) / (std::pow(0.8 * end, -4) - std::pow(end, -4));
    const double kept = 1 - 0.25 * tail * std::pow(end, -4) / r.m0;
    EXPECT_NEAR(moment(0, 11), r.m0, 1e-12 * r.m0);
    EXPECT_NEAR(kept * (moment(-1, 10) + tail * std::pow(end, -5) / 5), r.m_1, 1e-6 * r.m_1);
    EXPECT_NEAR(kept * (moment(1, 10) + tail * std::pow(end, -3) / 3), r.m1, 1e-6 * r.m1);
    EXPECT_NEAR(kept * (moment(2, 10) + tail * std::pow(end, -2) / 2), r.m2, 1e-5 * r.m2);
    EXPECT_NEAR(kept * moment(4, 5), r.m4, 1e-4 * r.m4);
  }
}

// Three hours of a sea with the default number of components: variance and mean zero-crossing period within 1
// % of the spectrum's for any seed. The sums use rotating phasors.
TEST(Waves, IrregularSeaOfThreeHours) {
  const double m0 = 1.5625;
  const double T02 = 2 * M_PI * std::sqrt(m0 / 1.020684631);
  const double h = 1;
  double worst[2] = {0, 0};
  for (int seed = 1; seed <= 20; ++seed) {
    const model::Case c = io::read_case_text(
        "hawser: 1\nenvironment: {water: {}, waves: {jonswap: {hs: 5, tp: 10, seed: " + std::to_string(seed) +
            "}}}\nline_types: {t: {outer_diameter: 0.1, mass_per_length: 9, EA: 1e6, bending: "
            "false}}\nlines: "
            "{l: {sections: [{type: t, length: 60, elements: 1}], end_a: {anchor: [0, 0, 0]}, end_b: "
            "{anchor: "
            "[50, 0, 0]}}}\n",
        HAWSER_SOURCE_DIR "/tests/sea.yaml");
    const WaveField w = model::wave_field(c.environment);
    std::vector<std::complex<double>> now, turn;
    std::vector<double> omega;
    for (const WaveComponent& k : w.components()) {
      now.push_back(std::polar(k.amplitude, k.phase));
      turn.push_back(std::polar(1.0, -k.omega * h));
      omega.push_back(k.omega);
    }
    double sum2 = 0, rate2 = 0, elevation = 0;
    const int n = 10800;
    for (int i = 0; i < n; ++i) {
      double rate = 0;
      elevation = 0;
      for (size_t k = 0; k < now.size(); ++k) {
        now[k] = {now[k].real() * turn[k].real() - now[k].imag() * turn[k].imag(),
                  now[k].real() * turn[k].imag() + now[k].imag() * turn[k].real()};
        elevation += now[k].real();
        rate += omega[k] * now[k].imag();
      }
      sum2 += elevation * elevation;
      rate2 += rate * rate;
    }
    EXPECT_NEAR(w.at({0, 0, 0}, n * h).surface, elevation, 1e-8);
    const double variance = sum2 / n / m0 - 1;
    const double period = 2 * M_PI * std::sqrt(sum2 / rate2) / T02 - 1;
    worst[0] = std::max(worst[0], std::abs(variance));
    worst[1] = std::max(worst[1], std::abs(period));
    EXPECT_LT(std::abs(variance), 0.01) << seed;
    EXPECT_LT(std::abs(period), 0.01) << seed;
  }
  printf("  20 seeds: m0 within %.2f %%, T02 within %.2f %%\n", 100 * worst[0], 100 * worst[1]);
}

TEST(Waves, SeedsAndSpreading) {
  const Jonswap s{3, 8, 3.3};
  const auto a = irregular(s, 0, 50, 7);
  const auto b = irregular(s, 0, 50, 7);
  const auto c = irregular(s, 0, 50, 8);
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].phase, b[i].phase);
    EXPECT_NE(a[i].phase, c[i].phase);
    EXPECT_EQ(a[i].x, 1);
  }
  EXPECT_NEAR(a[0].phase, 4.0822127409094637, 1e-12);  // the same on every machine
  // Spreading leaves frequencies and phases unchanged.
  const auto wide = irregular(s, 0, 50, 7, 5);
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].omega, wide[i].omega);
    EXPECT_EQ(a[i].phase, wide[i].phase);
    EXPECT_NEAR(std::hypot(wide[i].x, wide[i].y), 1, 1e-15);
  }
}

// Energy by direction of cos^(2s)((theta - direction)/2), for any seed, with the default number of
// components: mean cosine s/(s + 1), of twice the angle s (s - 1)/((s + 1) (s + 2)); half of it on either
// side of the mean direction. Directions of half of the frequencies have the same distribution as the rest.
TEST(Waves, SpreadingOfEverySeed) {
  const std::vector<SpectrumRow> rows{{0.4, 0}, {0.6, 9}, {0.8, 2}, {2, 0}};
  for (const double s : {1.0, 2.0, 4.0, 10.0, 100.0, 1000.0}) {
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const auto sea =
          seed % 2 ? irregular({5, 10, 3.3}, 0.7, 200, seed, s) : irregular(rows, 0.7, 200, seed, s);
      std::complex<double> once = 0, twice = 0;
      double all = 0, left = 0;
      for (const WaveComponent& c : sea) {
        const std::complex<double> turn = std::complex<double>(c.x, c.y) * std::polar(1.0, -0.7);
        const double energy = c.amplitude * c.amplitude;
        all += energy;
        once += energy * turn;
        twice += energy * turn * turn;
        if (turn.imag() > 0) left += energy;
      }
      const double off = std::abs(std::arg(once)) * 180 / M_PI;
      worst = std::max(worst, off);
      EXPECT_LT(off, 0.5) << s << " " << seed;
      EXPECT_NEAR(once.real() / all, s / (s + 1), 0.01) << s << " " << seed;
      EXPECT_NEAR(twice.real() / all, s * (s - 1) / ((s + 1) * (s + 2)), 0.02) << s << " " << seed;
      EXPECT_NEAR(left / all, 0.5, 0.05) << s << " " << seed;
    }
    printf("  spreading %g: mean direction of 40 seeds within %.2f degrees\n", s, worst);
  }
}

// No phase of one sea occurs in another, shifted or not.
TEST(Waves, SeedsAreIndependent) {
  std::map<double, std::uint64_t> first_seed;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (const WaveComponent& c : irregular({5, 10, 3.3}, 0, 100, seed, 0)) {
      const auto [there, first] = first_seed.emplace(c.phase, seed);
      ASSERT_TRUE(first) << "seeds " << there->second << " and " << seed;
    }
}

// A tabulated spectrum: energy and moments by linear interpolation; direction and seed as for the other
// spectra.
TEST(Waves, SpectrumByRows) {
  const std::vector<SpectrumRow> rows{{0.2, 0}, {0.5, 9}, {0.7, 4}, {0.9, 4}, {2, 0}};
  double m0 = 0, m1 = 0;
  for (size_t i = 1; i < rows.size(); ++i)
    for (int k = 0; k < 1000; ++k) {
      const double z = (k + 0.5) / 1000;
      const double step = (rows[i].omega - rows[i - 1].omega) / 1000;
      const double s = rows[i - 1].density + z * (rows[i].density - rows[i - 1].density);
      m0 += step * s;
      m1 += step * s * (rows[i - 1].omega + 1000 * z * step);
    }
  const auto sea = irregular(rows, 0.7, 400, 3);
  double energy = 0, first = 0;
  for (const WaveComponent& c : sea) {
    energy += 0.5 * c.amplitude * c.amplitude;
    first += 0.5 * c.amplitude * c.amplitude * c.omega;
    EXPECT_GE(c.omega, 0.2);
    EXPECT_LE(c.omega, 2);
    EXPECT_NEAR(c.x, std::cos(0.7), 1e-15);
  }
  EXPECT_NEAR(energy, m0, 1e-6 * m0);
  EXPECT_NEAR(first, m1, 5e-4 * m1);
  EXPECT_EQ(irregular(rows, 0.7, 400, 3)[17].phase, sea[17].phase);
  EXPECT_NE(irregular(rows, 0.7, 400, 4)[17].phase, sea[17].phase);
  // Rows without energy have no components.
  EXPECT_LT(irregular({{0.1, 0}, {0.5, 0}, {0.6, 5}, {0.7, 0}}, 0, 100, 1).size(), 20u);
}

}  // namespace
}  // namespace hawser::waves_test
