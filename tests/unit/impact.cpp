// Step lengths before and during contact, and the time for which oscillations after an impact are resolved,
// against closed forms.
#include "hawser/kernels/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "hawser/solve/generalized_alpha.hpp"
#include "hawser/solve/step_control.hpp"

namespace hawser::impact_test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSlow = 0.01, kSignificantDepth = 1e-3;  // s, m
constexpr double kStep = 2 * M_PI / 25 * kSlow;           // s, 25 in a period

constexpr auto kAlone = [](std::span<double>) {};
constexpr double kMass = 2, kMost = 0.3;  // kg, s

// Of the lines of a whole model.
std::vector<double> tolerance_of(std::span<const LineMotion> lines) {
  const auto with_impacts =
      std::count_if(lines.begin(), lines.end(), [](const LineMotion& l) { return l.has_impacts(); });
  return energy_tolerance(lines, static_cast<int>(with_impacts));
}

StepLimit limit_of(const ImpactEvent& s) {
  const double tolerance = kErrorOfStep * s.energy();
  return impact_limited_step({&s, 1}, {&tolerance, 1}, kMost, kAlone);
}

// The whole moving line takes part in the impact.
double longest(double gap, double closing, double acceleration = 0, bool last = true) {
  const auto s = impact_event(kSlow, kSignificantDepth, kMass, {gap, closing, acceleration, last});
  return s ? limit_of(*s).longest : kNever;
}

// The step is found by bisection.
void expect_step(double found, double length) { EXPECT_NEAR(found, length, 2e-4 * length); }
// The step may end after the onset or end of contact, as long as the lost or created energy is negligible.
void expect_until(double found, double length) {
  EXPECT_GE(found, (1 - 1e-5) * length);
  EXPECT_LT(found, (1 + 3e-3) * length);
}

TEST(Impact, WhatIsSlowIsNone) {
  // A speed of 0.09 m/s gives a penetration of 0.9 mm, and so do 9 m/s² from equilibrium.
  EXPECT_EQ(longest(-0.01, 0.09), kNever);
  EXPECT_EQ(longest(0.01, 0.09), kNever);
  EXPECT_EQ(longest(-0.01, 0, 9), kNever);
  expect_step(longest(-0.01, 0.11), kStep);
  expect_step(longest(-0.01, 0, -11), kStep);
  expect_step(longest(-0.01, 0.08, 8), kStep);  // both together exceed 1 mm
}

TEST(Impact, StepsEndAtTheTouch) {
  expect_until(longest(0.2, 2), 0.1);
  expect_until(longest(0.01, 2), 0.005);
  // With an acceleration away from the surface, v t - a t²/2 = gap, and with one towards it.
  const double t = longest(0.01, 2, 5);
  EXPECT_NEAR(2 * t - 2.5 * t * t, 0.01, 5e-6);
  const double u = longest(0.01, 2, -5);
  EXPECT_NEAR(2 * u + 2.5 * u * u, 0.01, 5e-6);
  // The line reverses before contact; accelerations change, so the gap is checked again during the approach.
  expect_until(longest(0.2, 2, 50), 0.2);
  // In contact except for rounding.
  expect_step(longest(1e-6, 2), kStep);
  expect_step(longest(0, 2), kStep);
  EXPECT_EQ(longest(0.2, -2), kNever);
  expect_step(longest(0.2, -2, 20), kStep);  // the vibration has the frequency of the contact
  expect_until(longest(1, 2), 0.25);         // half way: one step of 0.3 s does not reach the surface
  EXPECT_EQ(longest(1.3, 2), kNever);        // nor do two steps
}

TEST(Impact, StepsEndAtItsEnd) {
  // By the trapezoidal rule: the contact force acts at the start of the step, not at its end.
  const double p = 0.004, u = 2, a = 40;
  const double t = longest(-p, -u, a);
  EXPECT_NEAR(-p + t * u + t * t / 4 * a, 0, 2e-5);
  EXPECT_LT(t, kStep);
  // The end of contact is not within one step but within two, so the step is half of it; farther away the
  // step is the longest.
  const double far = 2 * 0.008 / (u + std::sqrt(u * u + a * 0.008));
  ASSERT_TRUE(far > kStep && far < 2 * kStep);
  expect_until(longest(-0.008, -u, a), far / 2);
  expect_step(longest(-0.3, -u, a), kStep);
  expect_until(longest(-p, -u), p / u);
  expect_step(longest(-p, -u, -2000), kStep);  // accelerated towards the surface again
  // Other parts of the contact are deeper, or the line has separated except for rounding.
  expect_step(longest(-p, -u, a, false), kStep);
  expect_step(longest(-1e-6, -u, a), kStep);
}

TEST(Impact, HasAPeriodWhileItTouches) {
  expect_step(limit_of(*impact_event(kSlow, kSignificantDepth, kMass, {-0.01, 1, 0})).period,
              2 * M_PI * kSlow);
  EXPECT_EQ(limit_of(*impact_event(kSlow, kSignificantDepth, kMass, {0.01, 1, 0})).period, kNever);
}

// Time until the vibration of an impact with all energy of the line has decayed to the tolerance.
double decay_of(double damping) {
  return limit_of(*impact_event(kSlow, kSignificantDepth, kMass, {-0.01, 1, 0, true, damping})).decay;
}

TEST(Impact, HasAVibrationThatDecays) {
  const double longest = kPeriodsAfterImpact * 2 * M_PI * kSlow;
  const double of_energy = std::log(1 / kErrorOfStep) * kSlow / 2;  // s, E exp(-2 zeta omega t), for zeta = 1
  EXPECT_NEAR(decay_of(0), longest, 2e-4 * longest);
  EXPECT_NEAR(decay_of(0.01), longest, 2e-4 * longest);
  EXPECT_NEAR(decay_of(0.1), of_energy / 0.1, 2e-4 * longest);
  EXPECT_NEAR(decay_of(1), of_energy, 2e-4 * longest);
  EXPECT_NEAR(decay_of(7), of_energy, 2e-4 * longest);  // no oscillation
}

// Energy lost or created by the trapezoidal rule in a step across the onset or end of contact.
TEST(Impact, HasTheEnergyOfACrossing) {
  const double k = kMass / (kSlow * kSlow);
  for (const double h : {0.0015, 0.003, 0.0045})
    for (const double gap : {0.002, 0.006}) {
      const double z = 0.5 * h / kSlow;
      const double in = (2 * h - gap) / (1 + z * z);
      const double a = k / kMass * in;
      const double v = 2 - 0.5 * h * a;
      const double lost = 0.5 * kMass * (4 - v * v) - 0.5 * k * in * in;
      EXPECT_NEAR(impact_event(kSlow, kSignificantDepth, kMass, {gap, 2, 0})->crossed(h), in > 0 ? lost : 0,
                  1e-12)
          << h;
      // The line separates, pushed by the spring alone.
      const double p = gap;
      const double push = k / kMass * p;
      const double out = 2 * h + 0.25 * push * h * h - p;
      const double w = 2 + 0.5 * h * push;
      const double made = 0.5 * kMass * (w * w - 4) - 0.5 * k * p * p;
      EXPECT_NEAR(impact_event(kSlow, kSignificantDepth, kMass, {-p, -2, push})->crossed(h),
                  out > 0 ? made : 0, 1e-12)
          << h;
    }
}

TEST(Impact, OnlyWhatMattersCutsAStep) {
  // 10 kg oscillate at 3 m/s, of which a part has an impact at 2 m/s.
  const auto of = [&](double mass, double drift) {
    std::vector<LineMotion> lines(1);
    lines[0].add(5, {3, drift, 0});
    lines[0].add(5, {-3, drift, 0});
    const auto s = impact_event(kSlow, kSignificantDepth, mass, {-0.01, 2, 0});
    lines[0].impact_energy = s->energy();
    const auto tolerance = tolerance_of(lines);
    EXPECT_NEAR(tolerance[0], kErrorOfStep * (45 + 2 * mass), 1e-9);  // uniform motion does not count
    return impact_limited_step({&*s, 1}, tolerance, kMost, kAlone);
  };
  // 2 J per kilogram against 2e-5 of 45 J.
  EXPECT_EQ(of(0.000449, 0).longest, kNever);
  EXPECT_EQ(of(0.000449, 0).period, kNever);
  expect_step(of(0.000451, 0).longest, kStep);
  expect_step(of(0.000451, 0).period, 2 * M_PI * kSlow);
  expect_step(of(0.000451, 1000).longest, kStep);
  EXPECT_EQ(of(0.000449, 1000).longest, kNever);
}

TEST(Impact, ManySmallOnesTogetherDo) {
  const auto impacts = [](int n, double inverse_frequency) {
    std::vector<ImpactEvent> out(static_cast<size_t>(n),
                                 *impact_event(inverse_frequency, 1e-9, 1e-3, {-0.01, 2, 0}));
    for (ImpactEvent& s : out) s.line = 0;
    return out;
  };
  const double tolerance = 0.0200001;  // tolerance for ten impacts
  EXPECT_EQ(impact_limited_step(impacts(10, kSlow), {&tolerance, 1}, kMost, kAlone).longest, kNever);
  expect_step(impact_limited_step(impacts(11, kSlow), {&tolerance, 1}, kMost, kAlone).longest, kStep);
  // Few short impacts among many longer ones: the step resolves only the longer ones.
  std::vector<ImpactEvent> both = impacts(11, kSlow);
  std::vector<ImpactEvent> fast = impacts(9, kSlow / 10);
  both.insert(both.end(), fast.begin(), fast.end());
  expect_step(impact_limited_step(both, {&tolerance, 1}, kMost, kAlone).longest, kStep);
  expect_step(impact_limited_step(both, {&tolerance, 1}, kMost, kAlone).period, 2 * M_PI * kSlow);
}

TEST(Impact, AThousandLinesAreAsOne) {
  // Each line tolerates a fraction of its own energy; lines without impacts change nothing.
  std::vector<LineMotion> lines(1001);
  std::vector<ImpactEvent> impacts;
  for (int l = 0; l < 1000; ++l) {
    LineMotion& line = lines[static_cast<size_t>(l)];
    line.add(1, {1.0 + l, 0, 0});
    line.add(1, {-1.0 - l, 0, 0});
    impacts.push_back(
        *impact_event(kSlow, kSignificantDepth, 0.5 * (1 + l) * (1 + l), {0.02 * (1 + l % 7), 2, 0}));
    impacts.back().line = l;
    line.impact_energy = impacts.back().energy();
  }
  lines[1000].add(1000, {5, 0, 0});
  lines[1000].add(1000, {-5, 0, 0});
  const double together = impact_limited_step(impacts, tolerance_of(lines), kMost, kAlone).longest;
  for (LineMotion& l : lines)
    if (&l != &lines[6]) l.impact_energy = 0;
  const double alone = impact_limited_step({&impacts[6], 1}, tolerance_of(lines), kMost, kAlone).longest;
  // The first impact of all is at 0.01 s, that of line 6 alone at 0.07 s.
  EXPECT_NEAR(together, 0.01, 5e-5);
  expect_until(alone, 0.07);
}

// Unresolved impact: penetration of 10 mm at one end of the step, separation of 50 mm at the other.
TEST(Impact, UnresolvedCrossings) {
  const double k = kMass / (kSlow * kSlow), depth = 0.01, gap = 0.05;
  const auto error = [&](double path, double speed) {
    return crossing_error(kSlow, kSignificantDepth, k * depth, 0.5 * k * depth * depth, path, speed);
  };
  const double e = 0.5 * k * depth * gap;
  EXPECT_NEAR(error(depth + gap, 5), e, 1e-12 * e);
  EXPECT_EQ(error(depth + gap, -5), 0);                                // moving away
  EXPECT_EQ(error(depth + gap, 0.99 * kSignificantDepth / kSlow), 0);  // slow: lifted or laid down
  EXPECT_GT(error(depth + gap, 1.01 * kSignificantDepth / kSlow), 0);
  EXPECT_EQ(error(0.9 * depth, 5), 0);  // in contact during the whole step
  const std::vector<UnresolvedImpact> two{
      {0, -1, e}, {1, 0, e}};  // the second impact is between its line and the first line
  for (const auto& [tolerance, within] : {std::pair(1.99, false), {2.01, true}})
    EXPECT_EQ(within_tolerance(two, std::vector<double>{tolerance * e, 10 * e}, kAlone), within);
  EXPECT_TRUE(resolves_contact(kSlow, 0.25 * kStep));
  EXPECT_FALSE(resolves_contact(kSlow, 0.26 * kStep));
}

// Linear spring without damping and trapezoidal rule (rho = 1): with adapted steps an impact conserves energy
// for any start of the steps; with fixed steps of a sixth of the period it does not.
TEST(Impact, MakesNoEnergy) {
  const double w = 1 / kSlow;
  const auto bounce = [&](double start, bool cut) {
    double x = start;
    double v = -2;
    double a = 0;
    double made = 0;
    for (int n = 0; n < 200 && x < 0.2; ++n) {
      const double h = cut ? std::min(kStep, longest(x, -v, a)) : 2 * M_PI / 6 * kSlow;
      // x1 = x + h (v + v1)/2, v1 = v + h (a + a1)/2, a1 = -w² x1 in contact.
      const double free = x + h * v + h * h / 4 * a;
      const double x1 = free < 0 ? free / (1 + w * w * h * h / 4) : free;
      const double a1 = x1 < 0 ? -w * w * x1 : 0;
      v += h / 2 * (a + a1);
      x = x1;
      a = a1;
      made = (v * v + (x < 0 ? w * w * x * x : 0)) / 4 - 1;
    }
    EXPECT_GT(x, 0);
    return made;
  };
  double cut = 0, uncut = 0;
  for (int i = 0; i < 20; ++i) {
    const double start = 0.05 + 0.001 * i;
    cut = std::max(cut, std::abs(bounce(start, true)));
    uncut = std::max(uncut, std::abs(bounce(start, false)));
  }
  std::printf("energy of an impact: %.1e cut, %.1e not\n", cut, uncut);
  EXPECT_LT(cut, 1e-2);
  EXPECT_GT(uncut, 0.1);
}

// Masses fall on springs one after the other, with common steps: the number of steps for a thousand equals
// that for thirty, and the remaining energy is right.
TEST(Impact, StepsForManyAreNoMoreThanForFew) {
  struct Outcome {
    int steps = 0;
    double made = 0;  // part of the energy
  };
  const auto fall = [](int n) {
    const double w = 1 / kSlow, end = 0.2;
    std::vector<double> x;
    std::vector<double> v;
    std::vector<double> a(static_cast<size_t>(n), 0.0);
    double phase = 0;
    for (int i = 0; i < n; ++i) {
      phase = std::fmod(phase + 0.6180339887498949, 1.0);
      x.push_back(0.01 + 0.2 * phase);
      v.push_back(-2);
    }
    Outcome out;
    for (double t = 0; t < end; ++out.steps) {
      std::vector<ImpactEvent> impacts;
      LineMotion line;
      for (size_t i = 0; i < x.size(); ++i) {
        line.add(1, {v[i], 0, 0});
        ImpactEvents to;
        to.add(impact_event(kSlow, kSignificantDepth, 1, {x[i], -v[i], a[i]}), 0);
        for (const ImpactEvent& s : to.list) {
          impacts.push_back(s);
          line.impact_energy += s.energy();
        }
      }
      double h = std::min(0.02, end - t);
      h = std::min(h, impact_limited_step(impacts, tolerance_of({&line, 1}), 0.02, kAlone).longest);
      for (size_t i = 0; i < x.size(); ++i) {
        const double free = x[i] + h * v[i] + h * h / 4 * a[i];
        x[i] = free < 0 ? free / (1 + w * w * h * h / 4) : free;
        const double next = x[i] < 0 ? -w * w * x[i] : 0;
        v[i] += h / 2 * (a[i] + next);
        a[i] = next;
      }
      t += h;
    }
    for (size_t i = 0; i < x.size(); ++i)
      out.made += ((v[i] * v[i] + (x[i] < 0 ? w * w * x[i] * x[i] : 0)) / 4 - 1) / n;
    return out;
  };
  const Outcome few = fall(30);
  const Outcome many = fall(1000);
  const Outcome more = fall(3000);
  std::printf("energy of 30, 1000, 3000 impacts: %.1e, %.1e, %.1e in %d, %d, %d steps\n", few.made, many.made,
              more.made, few.steps, many.steps, more.steps);
  EXPECT_LT(std::abs(few.made), 1e-2);
  EXPECT_LT(std::abs(many.made), 1e-2);
  EXPECT_LT(std::abs(more.made), 1e-2);
  EXPECT_LT(many.steps, 200);
  EXPECT_LT(more.steps, 1.05 * many.steps);
}

// A mass on a spring that is far too stiff for the steps, after a single short step in which contact began:
// the energy stored in the scheme's A, which is scaled with the square of the step, becomes kinetic energy
// unless the growth of steps is limited.
TEST(Impact, StepsGrowNoFasterThanWhatTheyHold) {
  const AlphaCoefficients c(0.8);
  const double w = 1e3;
  const double m1 = (1 - c.am) / (1 - c.af);
  const double m0 = c.am / (1 - c.af);
  const double d0 = c.af / (1 - c.af);
  const auto most = [&](bool bounded) {
    double x = 0;
    double v = 1;
    double a = 0;
    double A = 0;
    double h = 1 / w;
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
      const double end = (-w * w * (x + h * v + h * h * (0.5 - c.beta) * A) - m0 * A + d0 * a) /
                         (m1 + w * w * h * h * c.beta);
      x += h * v + h * h * ((0.5 - c.beta) * A + c.beta * end);
      v += h * ((1 - c.gamma) * A + c.gamma * end);
      A = end;
      a = -w * w * x;
      worst = std::max(worst, v * v + w * w * x * x - 1);
      // The line has another kilogram at rest.
      std::vector<LineMotion> line(1), held(1);
      line[0].add(1, {v, 0, 0});
      line[0].add(1, {0, 0, 0});
      held[0].add(1, {A, 0, 0});
      held[0].add(1, {0, 0, 0});
      h = bounded ? std::min(0.1, growth_limited_step(held, tolerance_of(line), alpha_stored(c), h)) : 0.1;
    }
    return worst;
  };
  std::printf("energy made after a short step: %.1e with steps that grow by what they hold, %.1e at once\n",
              most(true), most(false));
  EXPECT_LT(most(true), 0.05);
  EXPECT_GT(most(false), 1);
  // No limit in other cases: rigid rotation and slow long lines do not restrict the steps.
  std::vector<LineMotion> line(1), held(1);
  line[0].add(1, {2, 0, 0});
  line[0].add(1, {-2, 0, 0});
  held[0].add(2, {0, 0, -9.81});
  EXPECT_EQ(growth_limited_step(held, tolerance_of(line), alpha_stored(c), 0.01), kNever);
  held[0] = {};
  held[0].add(1, {0.1, 0, 0});
  held[0].add(1, {-0.1, 0, 0});
  EXPECT_GT(growth_limited_step(held, tolerance_of(line), alpha_stored(c), 0.01), 1);
  EXPECT_EQ(growth_limited_step(held, tolerance_of(line), alpha_stored(c), 0), kNever);  // no step yet
}

TEST(StepControl, AnImpactIsFollowed) {
  StepSettings s;
  s.first = s.longest = 0.1;
  StepControl c(s);
  EXPECT_DOUBLE_EQ(c.next(0, 1, kNever), 0.1);
  c.limit_by_impact(1, 0.03);
  EXPECT_DOUBLE_EQ(c.next(1, 2, kNever), 0.01);
  EXPECT_DOUBLE_EQ(c.next(1, 2, 0.002), 0.002);
  EXPECT_NEAR(c.next(1.59, 1.69, kNever), 0.01, 1e-12);
  // Then steps at most double until they reach their earlier length.
  EXPECT_NEAR(c.next(1.6, 2.6, kNever), 0.01, 1e-12);
  EXPECT_NEAR(c.next(1.61, 1.71, kNever), 0.02, 1e-12);
  EXPECT_NEAR(c.next(1.63, 1.79, kNever), 0.04, 1e-12);
  EXPECT_NEAR(c.next(1.67, 1.83, kNever), 0.08, 1e-12);
  EXPECT_NEAR(c.next(1.75, 1.85, kNever), 0.1, 1e-12);
  // A softer impact does not lengthen steps during the resolved time or while they grow; it has an effect
  // afterwards.
  c.limit_by_impact(1.2, 0.3);
  c.limit_by_impact(1.2, kNever);
  EXPECT_DOUBLE_EQ(c.next(1.3, 2.3, kNever), 0.01);
  c.limit_by_impact(1.61, 0.15);
  EXPECT_NEAR(c.next(1.61, 1.71, kNever), 0.02, 1e-12);
  c.limit_by_impact(1.7, 0.15);
  EXPECT_DOUBLE_EQ(c.next(1.8, 2.8, kNever), 0.05);
  // The same after a restart.
  StepControl d(s);
  d.restore(c.proposal(), c.wait(), c.impact_period(), c.resolved_until());
  EXPECT_DOUBLE_EQ(d.next(1.8, 2.8, kNever), 0.05);
}

TEST(StepControl, AVibrationThatDecaysIsFollowedForAShorterTime) {
  StepSettings s;
  s.first = s.longest = 0.1;
  StepControl c(s);
  c.limit_by_impact(1, 0.03, 0.04);
  EXPECT_NEAR(c.next(1.04, 1.14, kNever), 0.01, 1e-12);
  EXPECT_NEAR(c.next(1.05, 1.15, kNever), 0.02, 1e-12);
  // It does not end the time of an earlier impact without damping.
  c.limit_by_impact(1.1, 0.03);
  c.limit_by_impact(1.2, 0.03, 0.04);
  EXPECT_NEAR(c.next(1.69, 1.79, kNever), 0.01, 1e-12);
  EXPECT_NEAR(c.next(1.71, 1.81, kNever), 0.02, 1e-12);
}

// Energy of an oscillation at frequency w when the steps of a third of the contact's period end and steps a
// hundred times as long are requested: maximum over phases, relative to the initial energy. jump: sudden
// factor of the step length; 0: growth by step control.
double energy_after(double rho, double w, double jump) {
  const double third = 0.01;
  const AlphaCoefficients c(rho);
  StepSettings s;
  s.fixed = 100 * third;
  double worst = 0;
  for (int phase = 0; phase < 24; ++phase) {
    StepControl control(s);
    control.restore(control.proposal(), 0, 3 * third, 0);  // the twenty resolved periods are over
    double x = std::cos(phase * M_PI / 24) / w;
    double v = std::sin(phase * M_PI / 24);
    double a = -w * w * x;
    double A = a;
    double t = 0;
    const double m1 = (1 - c.am) / (1 - c.af);
    const double m0 = c.am / (1 - c.af);
    const double d0 = c.af / (1 - c.af);
    for (int i = 0; i < 60; ++i) {
      const double h = jump > 0 ? jump * third : control.next(t, 1e9, kNever);
      const double end = (-w * w * (x + h * v + h * h * (0.5 - c.beta) * A) - m0 * A + d0 * a) /
                         (m1 + w * w * h * h * c.beta);
      x += h * v + h * h * ((0.5 - c.beta) * A + c.beta * end);
      v += h * ((1 - c.gamma) * A + c.gamma * end);
      A = end;
      a = -w * w * x;
      t += h;
      worst = std::max(worst, v * v + w * w * x * x);
    }
  }
  return worst;
}

// Longer steps do not resolve an oscillation and do not add energy to it if they grow gradually. Frequencies
// between a third and six times the period gain some.
TEST(StepControl, LongerStepsAfterAnImpactMakeNoEnergy) {
  for (const auto& [rho, bound] : {std::pair(0.8, 1.005), {0.5, 1.03}, {1.0, 1 + 1e-9}})
    for (const double turns : {0.05, 0.1, 1.0 / 6, 1.0 / 3}) {
      const double w = 2 * M_PI * turns / 0.01;
      const double grown = energy_after(rho, w, 0);
      const double jumped = energy_after(rho, w, 100);
      std::printf(
          "rho %.1f, steps of 1/%.0f of its period, then 100 times as long: energy %.3f, at once %.3f\n", rho,
          1 / turns, grown, jumped);
      EXPECT_LT(grown, bound) << rho << " " << turns;
    }
}

// After a failure growth of steps is delayed; shrinking is not.
TEST(StepControl, StepsShrinkWhileTheyMayNotGrow) {
  StepSettings s;
  s.first = s.longest = 0.1;
  s.error_tolerance = 1e-3;
  StepControl c(s);
  ASSERT_TRUE(c.after_rejected_step(0.1, StepControl::Rejection::invalid, 0));
  EXPECT_DOUBLE_EQ(c.proposal(), 0.05);
  c.after_accepted_step(0.05, 1, 1e-9);
  EXPECT_DOUBLE_EQ(c.proposal(), 0.05);
  c.after_accepted_step(0.05, s.hard_iterations + 1, 1e-9);
  EXPECT_DOUBLE_EQ(c.proposal(), 0.035);
  c.after_accepted_step(0.035, 1, 8e-3);
  EXPECT_DOUBLE_EQ(c.proposal(), 0.035 * 0.9 / 2);
}

TEST(StepControl, FixedStepsAreDividedAtImpactsByDefault) {
  StepSettings s;
  s.fixed = 0.1;
  StepControl c(s);
  EXPECT_TRUE(c.respects_term_limits());
  EXPECT_DOUBLE_EQ(c.next(0, 1, kNever), 0.1);
  EXPECT_DOUBLE_EQ(c.next(0, 1, 0.04), 0.04);
  c.after_accepted_step(0.04, 2, 0);
  EXPECT_DOUBLE_EQ(c.next(0.04, 1.04, kNever), 0.1);  // returns to the requested step
  s.resolve_impacts = false;
  StepControl strict(s);
  EXPECT_FALSE(strict.respects_term_limits());
  strict.limit_by_impact(0, 0.03);
  EXPECT_DOUBLE_EQ(strict.next(0, 1, 0.04), 0.1);
}

}  // namespace
}  // namespace hawser::impact_test
