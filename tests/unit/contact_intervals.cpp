// Intervals of contact along an axis against gaps with known roots.
#include "hawser/kernels/contact_intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace hawser::contact_intervals_test {
namespace {

struct Gap {
  std::function<double(double)> value, slope;
  int calls = 0;
  AxisGap operator()(double xi, double within) {
    ++calls;
    const double v = value(xi);
    return v > within ? AxisGap{within, 0} : AxisGap{v, slope(xi)};
  }
};

// Straight element of length L along x past a circle of radius R at (c, depth below the axis: height).
Gap circle(double L, double c, double height, double R) {
  Gap g;
  g.value = [=](double xi) { return std::hypot(L * xi - c, height) - R; };
  g.slope = [=](double xi) { return L * (L * xi - c) / std::hypot(L * xi - c, height); };
  return g;
}

TEST(ContactIntervals, FindsARollerAnywhere) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  int most = 0;
  for (int i = 0; i < 20000; ++i) {
    const double L = 0.2 + 4 * u(random);
    const double R = 0.3 + 0.2 * u(random);
    const double c = L * (1.4 * u(random) - 0.2);
    const double height = R * (1 - std::pow(10, -8 * u(random)));
    const double half = std::sqrt(R * R - height * height);
    const double from = std::max(0.0, (c - half) / L);
    const double to = std::min(1.0, (c + half) / L);
    Gap g = circle(L, c, height, R);
    const auto found = contact_intervals(g, {L}, contact_levels(L, 0.16));
    most = std::max(most, g.calls);
    if (from >= to) {
      EXPECT_TRUE(found.empty());
      continue;
    }
    ASSERT_EQ(found.size(), 1u) << L << " " << c << " " << R << " " << height;
    // Accuracy of a root: eps of the gap over its slope.
    EXPECT_NEAR(found[0].from, from, 1e-13 + 1e-15 * R / half);
    EXPECT_NEAR(found[0].to, to, 1e-13 + 1e-15 * R / half);
    EXPECT_EQ(found[0].from_moves, from > 0);
    EXPECT_EQ(found[0].to_moves, to < 1);
    Gap bounded = circle(L, c, height, R);
    const auto same = contact_intervals(bounded, {L, R, 0}, contact_levels(L, 0.16));
    most = std::max(most, bounded.calls);
    ASSERT_EQ(same.size(), 1u);
    EXPECT_NEAR(same[0].from, found[0].from, 1e-13 + 1e-15 * R / half);
    EXPECT_NEAR(same[0].to, found[0].to, 1e-13 + 1e-15 * R / half);
  }
  printf("  at most %d distances for an element\n", most);
  EXPECT_LE(most, 80);
}

TEST(ContactIntervals, FarCostsOneDistance) {
  Gap g = circle(1, 0.5, 3, 0.5);
  EXPECT_TRUE(contact_intervals(g, {1}, 5).empty());
  EXPECT_EQ(g.calls, 1);
}

double depth(const Gap& g, double L, const std::vector<ContactInterval>& intervals) {  // m², integrated
  double sum = 0;
  for (const ContactInterval& s : split_intervals(intervals, 2))
    for (size_t i = 0; i < kContactPoints; ++i) {
      const double xi = s.from + (s.to - s.from) * ContactRule::unit[i];
      sum += L * (s.to - s.from) * ContactRule::weight[i] * std::max(-g.value(xi), 0.0);
    }
  return sum;
}

// Two round humps move along below an axis: within a step the depth, integrated over the contact, changes by
// at most 0.1 % of its largest value, wherever the humps and the inactive interval between them are, and
// whether that interval opens or closes. Between steps it may change by the quadrature error of the inactive
// interval.
TEST(ContactIntervals, HumpsComeAndGoSmoothly) {
  const double L = 1.3, R = 7, r = 0.25, move = 1e-4;
  double within = 0, between_steps = 0, most = 0;
  int filled_ever = 0, parted = 0;
  for (const double between : {0.1, 0.148, 0.35, 0.5, 0.8})
    for (const double rise : {0.0, 3e-8, -3e-8}) {  // of the humps in a step
      double last = -1;
      double height = R + r - 4e-4;
      const auto humps = [&](double c) {
        Gap a = circle(L, c, height, R + r);
        Gap b = circle(L, c + between, height + 1e-4, R + r);
        Gap g;
        g.value = [=](double xi) { return std::min(a.value(xi), b.value(xi)); };
        g.slope = [=](double xi) { return a.value(xi) < b.value(xi) ? a.slope(xi) : b.slope(xi); };
        return g;
      };
      for (double c = -1; c < L; c += move, height += rise) {
        Gap moved_back = humps(c - move);
        const auto before = contact_intervals(moved_back, {L, r, 0}, 4);
        Gap g = humps(c);
        std::vector<InactiveInterval> filled;
        const auto now = as_split_before(
            contact_intervals(g, {L, r, 0}, 2, middles(inactive_intervals(before))), before, filled);
        const double d = depth(g, L, now);
        std::vector<InactiveInterval> none;
        within = std::max(within, std::abs(d - depth(moved_back, L, as_split_before(before, before, none))));
        EXPECT_TRUE(none.empty());
        if (last >= 0) between_steps = std::max(between_steps, std::abs(d - last));
        last = d;
        most = std::max(most, d);
        filled_ever += !filled.empty();
        parted += before.size() > 1;
      }
    }
  printf(
      "  integral up to %.3g m², changes by at most %.2g m² in a step, %.2g m² between steps; filled %d of "
      "%d\n",
      most, within, between_steps, filled_ever, parted);
  EXPECT_LT(within, 1e-3 * most);
  EXPECT_LT(between_steps, 0.1 * most);
  EXPECT_GT(filled_ever, 10);
}

TEST(ContactIntervals, LyingAndArching) {
  Gap g;
  g.value = [](double) { return -1e-3; };
  g.slope = [](double) { return 0.0; };
  auto found = contact_intervals(g, {1}, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(g.calls, 3);
  EXPECT_FALSE(found[0].from_moves || found[0].to_moves);
  // An arch over the second half: roots of -1e-3 + 0.1 (x - 0.6)(0.9 - x) in closed form.
  g.value = [](double x) { return -1e-3 + 0.1 * (x - 0.6) * (0.9 - x); };
  g.slope = [](double x) { return 0.1 * (1.5 - 2 * x); };
  found = contact_intervals(g, {1}, 1);
  ASSERT_EQ(found.size(), 2u);
  const double half = std::sqrt(0.15 * 0.15 - 0.01);
  EXPECT_NEAR(found[0].to, 0.75 - half, 1e-13);
  EXPECT_NEAR(found[1].from, 0.75 + half, 1e-13);
  const auto panels = split_intervals(found, 1);
  ASSERT_EQ(panels.size(), 3u);
  EXPECT_EQ(panels[0].to, 0.5);
  EXPECT_TRUE(panels[1].to_moves);
  EXPECT_FALSE(panels[1].from_moves);
  double length = 0;
  for (const ContactInterval& s : split_intervals(found, 5)) length += s.to - s.from;
  EXPECT_NEAR(length, 1 - 2 * half, 1e-12);
}

// A shallow inactive interval that begins near the end of a piece and ends in a kink, as over two facets of a
// hull, is found whether the end of the piece is in it or just before it.
TEST(ContactIntervals, AHollowWithAKinkIsFoundFromTheFirst) {
  const double move = 1e-4;
  for (const double rise : {2e-3, 6e-3, 0.03})
    for (const double fall : {0.02, 0.09, 0.4}) {
      double last = -1;
      for (double c = 0.24033; c < 0.2503; c += move) {
        const double kink = c + 0.01;  // the inactive interval begins at c and ends behind the kink
        Gap g;
        const auto bottom = [&](double x) { return x < kink ? -1 : -0.004 + 0.01 * (x - 0.6) * (x - 0.6); };
        const auto top = [&](double x) {
          return x < kink ? rise * (x - c) : rise * (kink - c) - fall * (x - kink);
        };
        g.value = [&](double x) { return std::max(top(x), bottom(x)); };
        g.slope = [&](double x) { return top(x) < bottom(x) ? 0.02 * (x - 0.6) : x < kink ? rise : -fall; };
        double length = 0;
        for (const ContactInterval& s : contact_intervals(g, {1, 0.15, 0}, 2)) length += s.to - s.from;
        const double inactive = (kink - c) * (1 + rise / fall);
        EXPECT_NEAR(length, 1 - inactive, 1e-12) << rise << " " << fall << " " << c;
        if (last >= 0) {
          EXPECT_LT(std::abs(length - last), move);
        }
        last = length;
      }
    }
}

TEST(ContactIntervals, TwoRollersUnderOneElement) {
  Gap g;
  const auto one = [](double x, double c) { return std::hypot(4 * x - c, 0.4) - 0.41; };
  const auto slope = [](double x, double c) { return 4 * (4 * x - c) / std::hypot(4 * x - c, 0.4); };
  g.value = [&](double x) { return std::min(one(x, 0.0), one(x, 2.0)); };
  g.slope = [&](double x) { return slope(x, one(x, 0.0) < one(x, 2.0) ? 0.0 : 2.0); };
  const auto found = contact_intervals(g, {4}, contact_levels(4, 0.16));
  ASSERT_EQ(found.size(), 2u);  // both ends of the first half are in contact, its middle is not
  EXPECT_NEAR(found[0].to, std::sqrt(0.41 * 0.41 - 0.16) / 4, 1e-13);
  EXPECT_NEAR(found[1].from + found[1].to, 1, 1e-13);
}

TEST(LineContactRule, IsExactToTheSeventhDegree) {
  for (int n = 0; n < 9; ++n) {
    double sum = 0;
    for (size_t q = 0; q < kContactPoints; ++q)
      sum += ContactRule::weight[q] * std::pow(ContactRule::unit[q], n);
    if (n < 8)
      EXPECT_NEAR(sum, 1.0 / (n + 1), 1e-15);
    else
      EXPECT_GT(std::abs(sum - 1.0 / 9), 1e-6);
  }
}

}  // namespace
}  // namespace hawser::contact_intervals_test
