// Location of events within a step: number of trials, and order of several events.
#include "hawser/solve/event_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace hawser::test::event_search_test {
namespace {

constexpr double kShortest = 1e-6;

struct Found {
  double h = 0, value = -HUGE_VAL;
  int tries = 0;  // after the first
};

// A step from t = 0 to at most `longest`, as tried by Dynamics.
Found find(const std::function<std::vector<double>(double)>& g, double longest) {
  EventSearch search;
  Found f;
  for (double h = longest; h != f.h && f.tries < 100; ++f.tries) {
    f.h = h;
    h = search.next(h, kShortest, g(h), g(0));
    EXPECT_GT(h, 0);
    EXPECT_LE(h, longest);
  }
  --f.tries;
  for (const double value : g(f.h)) f.value = std::max(f.value, value);
  return f;
}

TEST(EventSearch, AStepWithoutAnEventStays) {
  const Found f = find([](double t) { return std::vector<double>{t - 2, -1}; }, 1);
  EXPECT_EQ(f.h, 1);
  EXPECT_EQ(f.tries, 0);
  EXPECT_EQ(find([](double) { return std::vector<double>{}; }, 1).h, 1);
}

TEST(EventSearch, WithinTheToleranceAStepStays) {
  EXPECT_EQ(find([](double t) { return std::vector<double>{10 * t - 9.5}; }, 1).h, 1);
}

TEST(EventSearch, AStraightRiseIsFoundInOneTry) {
  const Found f = find([](double t) { return std::vector<double>{1000 * (t - 0.3)}; }, 1);
  EXPECT_EQ(f.tries, 1);
  EXPECT_NEAR(f.value, 0.5, 1e-9);
}

// Conditions that rise by a thousand tolerances or more, early and late in the step, with either curvature or
// with slopes that change tenfold at the event: at most 13 trials.
TEST(EventSearch, BentRisesTakeFewTries) {
  for (const double root : {0.02, 0.3, 0.77, 0.999}) {
    const std::vector<std::function<double(double)>> rises{
        [&](double t) { return 1000 * (t * t - root * root); },
        [&](double t) { return 1000 * (std::sqrt(t) - std::sqrt(root)); },
        [&](double t) { return 100 * (std::exp(3 * t) - std::exp(3 * root)); },
        [&](double t) { return 1000 * std::tanh(5 * (t - root)); },
        [&](double t) { return (t < root ? 1e3 : 1e4) * (t - root); },
        [&](double t) { return (t < root ? 1e4 : 1e3) * (t - root); }};
    for (size_t i = 0; i < rises.size(); ++i) {
      const Found f = find([&](double t) { return std::vector<double>{rises[i](t)}; }, 1);
      EXPECT_GE(f.value, 0);
      EXPECT_LE(f.value, 1);
      EXPECT_LE(f.tries, 13) << "rise " << i << " through zero at " << root;
    }
  }
}

// If the condition jumps, no step ends within the tolerance; the found step ends just after the jump.
TEST(EventSearch, AJumpIsFoundToTheShortestStep) {
  const Found f = find([](double t) { return std::vector<double>{t < 0.3 ? -500.0 : 200.0}; }, 1);
  EXPECT_GE(f.h, 0.3);
  EXPECT_LE(f.h, 0.3 + 2 * kShortest);
  EXPECT_LE(f.tries, 40);
}

TEST(EventSearch, TheFirstOfSeveralIsFound) {
  const Found f = find(
      [](double t) {
        return std::vector<double>{1e3 * (t - 0.7), 1e3 * (std::sqrt(t) - std::sqrt(0.3)), 1e2 * (t - 0.5)};
      },
      1);
  EXPECT_NEAR(f.h, 0.3, 2e-3);
  EXPECT_GE(f.value, 0);
  EXPECT_LE(f.value, 1);
}

// A condition met at the start of the step is no event of this step.
TEST(EventSearch, WhatIsThereFromTheStartDoesNotRise) {
  EXPECT_EQ(find([](double t) { return std::vector<double>{5 + t, -10 * t}; }, 1).h, 1);
}

}  // namespace
}  // namespace hawser::test::event_search_test
