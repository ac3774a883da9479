// Bending with history: the given curve, unloading along twice that curve, dissipation, tangents of the law
// and the element, and the rows of a Ramberg-Osgood curve.
#include "hawser/kernels/plastic_bending.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "hawser/kernels/beam.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::plastic_bending_test {
namespace {

const std::vector<PlasticBending::Row> kRows = {{0.01, 1000}, {0.02, 1600}, {0.05, 2200}, {0.1, 2600}};

double on_rows(const std::vector<PlasticBending::Row>& rows, double c) {
  PlasticBending::Row from{0, 0};
  for (const PlasticBending::Row& to : rows) {
    if (c <= to.first || &to == &rows.back())
      return from.second + (c - from.first) * (to.second - from.second) / (to.first - from.first);
    from = to;
  }
  return 0;
}

double size(const BendingMoment& m) { return std::hypot(m.m[0], m.m[1]); }

struct Path {
  explicit Path(unsigned seed) : g(seed) {}
  std::mt19937 g;
  std::uniform_real_distribution<double> u{-1, 1};
  double next(double most) { return most * u(g); }
};

}  // namespace

TEST(PlasticBending, FollowsItsRowsInEveryDirection) {
  const PlasticBending law(kRows);
  EXPECT_DOUBLE_EQ(law.initial(), 1e5);
  for (const double c : {0.004, 0.01, 0.013, 0.03, 0.05, 0.08, 0.1, 0.2})
    for (const double turn : {0.0, 0.7, 2.0, 4.0}) {
      const BendingMoment m = law.at(c * std::cos(turn), c * std::sin(turn), nullptr);
      EXPECT_NEAR(size(m), on_rows(kRows, c), 1e-10 * 2600) << c;
      EXPECT_NEAR(m.m[0] * std::sin(turn) - m.m[1] * std::cos(turn), 0, 1e-9) << c;
      // In several steps along the same path, the moment is the same.
      std::vector<double> set(law.memory(), 0);
      for (int k = 1; k <= 50; ++k)
        law.bend(0.02 * k * c * std::cos(turn), 0.02 * k * c * std::sin(turn), set.data());
      EXPECT_NEAR(size(law.at(c * std::cos(turn), c * std::sin(turn), set.data())), size(m), 1e-10 * 2600);
    }
}

// Masing's rule: reversed at (c1, M1), the moment is M1 - 2 f((c1 - c)/2) of the first curve f.
TEST(PlasticBending, IsBentBackByTwiceTheCurve) {
  const PlasticBending law(kRows);
  std::vector<double> set(law.memory(), 0);
  const double c1 = 0.08;
  const double m1 = on_rows(kRows, c1);
  law.bend(0, c1, set.data());
  for (const double c : {0.075, 0.06, 0.05, 0.0, -0.02, -0.07})
    EXPECT_NEAR(law.at(0, c, set.data()).m[1], m1 - 2 * on_rows(kRows, 0.5 * (c1 - c)), 1e-9) << c;
  // After elastic unloading with the first slope, the curvature without moment is the residual.
  const auto [r2, r3] = law.residual(set.data());
  EXPECT_NEAR(r2, 0, 1e-15);
  EXPECT_NEAR(r3, c1 - m1 / law.initial(), 1e-12);
  // At -c1 the moment is on the first curve again, without effect of the history.
  law.bend(0, -c1, set.data());
  for (const double c : {-0.09, -0.2}) EXPECT_NEAR(law.at(0, c, set.data()).m[1], -on_rows(kRows, -c), 1e-9);
}

// On any path, work is recoverable or dissipated.
TEST(PlasticBending, WorkIsKeptOrDissipated) {
  const PlasticBending law(kRows);
  Path path(4);
  std::vector<double> set(law.memory(), 0);
  double c[2] = {0, 0}, work = 0, dissipated = 0;
  for (int leg = 0; leg < 8; ++leg) {
    const double to[2] = {path.next(0.1), path.next(0.1)};
    const double from[2] = {c[0], c[1]};
    constexpr int kSteps = 4000;
    for (int k = 1; k <= kSteps; ++k) {
      const BendingMoment before = law.at(c[0], c[1], set.data());
      const double x = static_cast<double>(k) / kSteps;
      const double next[2] = {from[0] + x * (to[0] - from[0]), from[1] + x * (to[1] - from[1])};
      const double lost = law.bend(next[0], next[1], set.data());
      EXPECT_GE(lost, 0);
      dissipated += lost;
      const BendingMoment after = law.at(next[0], next[1], set.data());
      for (int i = 0; i < 2; ++i) {
        work += 0.5 * (before.m[i] + after.m[i]) * (next[i] - c[i]);
        c[i] = next[i];
      }
    }
  }
  EXPECT_GT(dissipated, 100);
  EXPECT_NEAR(work, law.at(c[0], c[1], set.data()).energy + dissipated, 1e-4 * work);
}

TEST(PlasticBending, TangentAcrossYield) {
  const PlasticBending law(kRows);
  for (unsigned seed = 0; seed < 40; ++seed) {
    Path path(seed);
    std::vector<double> set(law.memory(), 0);
    for (int k = 0; k < 5; ++k) law.bend(path.next(0.1), path.next(0.1), set.data());
    const double c2 = path.next(0.12);
    const double c3 = path.next(0.12);
    const double d2 = path.next(1);
    const double d3 = path.next(1);
    const double h = 1e-8;
    const BendingMoment m = law.at(c2, c3, set.data());
    const BendingMoment a = law.at(c2 + h * d2, c3 + h * d3, set.data());
    const BendingMoment b = law.at(c2 - h * d2, c3 - h * d3, set.data());
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR((a.m[i] - b.m[i]) / (2 * h), m.K[i][0] * d2 + m.K[i][1] * d3, 1e-6 * law.initial()) << seed;
  }
}

TEST(PlasticBending, TwentyCirclesMakeRambergAndOsgood) {
  const double EI = 2e7, My = 4e5;
  for (const auto& [A, B] : {std::pair{0.4, 12.0}, {1.0, 6.0}, {0.02, 40.0}, {0.2, 4.0}}) {
    const double last = 10 * My / EI;
    const auto rows = ramberg_osgood(EI, My, A, B, last, 21);
    const PlasticBending law(rows);
    EXPECT_LE(law.memory(), 40u);
    EXPECT_NEAR(law.initial(), EI, 5e-3 * EI);
    EXPECT_NEAR(law.last(), rows[rows.size() - 2].first, 1e-15);
    double worst = 0;
    for (double m = 0.01;; m += 0.01) {
      const double c = My / EI * (m + A * std::pow(m, B));
      if (c > last) break;
      worst = std::max(worst, std::abs(law.at(c, 0, nullptr).m[0] / (m * My) - 1));
    }
    printf("  A %g, B %g: within %.2g %% of the curve\n", A, B, 100 * worst);
    EXPECT_LT(worst, 5e-3);
    EXPECT_GT(worst, 1e-5);
  }
}

TEST(PlasticBending, RefusesWhatDoesNotYield) {
  const auto wrong = [](std::vector<PlasticBending::Row> rows) {
    try {
      PlasticBending law(rows);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(wrong({{0.01, 10}, {0.01, 12}}), "row 2 does not rise");
  EXPECT_EQ(wrong({{0.01, 10}, {0.02, 9}}), "row 2 does not rise");
  EXPECT_EQ(wrong({{0.01, 10}, {0.02, 30}}), "row 2 makes the curve steeper than before");
  EXPECT_EQ(wrong({{0.01, 10}}), "at least two rows are needed");
}

// An element with a long bending history: the tangent is exact, and equal to the elastic one without
// yielding.
TEST(PlasticBending, TangentOfTheElement) {
  const PlasticBending law(std::vector<PlasticBending::Row>{{0.1, 6}, {0.3, 11}, {0.6, 13}, {1.5, 15}});
  using Vec12 = Eigen::Matrix<double, 12, 1>;
  using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;
  const auto moved = [](BeamEnds e, const Vec12& d) {
    e.x1 += d.segment<3>(0);
    e.x2 += d.segment<3>(6);
    e.q1 = e.q1 * exp_so3(d.segment<3>(3));
    e.q2 = e.q2 * exp_so3(d.segment<3>(9));
    return e;
  };
  for (unsigned seed = 0; seed < 12; ++seed) {
    Path path(seed);
    const auto vec = [&] { return Vec3(path.next(1), path.next(1), path.next(1)); };
    BeamSection s{1.3, 2e3, 65, 65, 23, 0, seed % 2 ? 0.05 : 0};
    s.plastic = &law;
    BeamReference r;
    std::vector<double> set(kBendingPlaces * law.memory(), 0);
    BeamEnds e;
    for (int k = 0; k < 4; ++k) {
      e.q1 = exp_so3(2 * vec());
      e.q2 = e.q1 * exp_so3(0.8 * vec());
      e.x1 = vec();
      e.x2 = e.x1 + e.q1 * (1.35 * (Vec3::UnitX() + 0.25 * vec()));
      if (k == 3) break;
      EXPECT_GE(beam_bend(s, r, e, set.data()), 0);
    }
    e.v1 = vec();
    e.v2 = vec();
    e.w1 = vec();
    e.w2 = vec();
    r.set = set.data();
    Mat12 K, C = Mat12::Zero(), Kd;
    Vec12 f;
    beam_tangent(s, r, e, false, f, K, &C);
    for (int j = 0; j < 12; ++j) {
      const double h = 1e-7;
      Vec12 a, b;
      beam_force(s, r, moved(e, h * Vec12::Unit(j)), a);
      beam_force(s, r, moved(e, -h * Vec12::Unit(j)), b);
      Kd.col(j) = (a - b) / (2 * h);
    }
    EXPECT_LT((K - Kd).norm(), 1e-6 * Kd.norm()) << "seed " << seed;
    // Without motion from the state of its history, the element dissipates nothing.
    beam_bend(s, r, e, set.data());
    EXPECT_LT(beam_bend(s, r, e, set.data()), 1e-12);
  }
}

}  // namespace hawser::plastic_bending_test
