// Slack and floating lines at rest: dynamic relaxation, and start shapes on the water or the bed. Hose as in
// Silva, Corrêa & Jacob, OMAE2006-92155: 0.12 t/m, displaces 0.20 t/m, so 0.6 of its section is submerged.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "support/rig.hpp"

namespace hawser::test::relaxation {
namespace {

constexpr double kLength = 278.5, kDiameter = 0.49843453365368695, kDensity = 1025, kGravity = 9.80665;
constexpr double kDraught = 0.5788680969001064 * kDiameter;  // circular segment of 0.6 of the area
constexpr double kEA = 6.178e7, kEI = 1.961e5;

struct AtRest {
  Vec3 middle = Vec3::Zero();      // m
  double tension = 0;              // N, at end A
  double lowest = 0, highest = 0;  // m, z between the ends
  StaticsReport report;
};

AtRest at_rest(const model::Case& c) {
  Simulation s(PETSC_COMM_WORLD, c);
  AtRest out;
  out.report = s.solve_statics();
  const int last = s.mesh().nodes() - 1;
  double sums[4] = {0, 0, 0, 0}, ends[2] = {-1e300, -1e300};
  for (int n = 0; n < s.local().owned; ++n) {
    const size_t i = static_cast<size_t>(n);
    const int global = s.local().global[i];
    const Vec3& x = s.state().x[i];
    if (global == last / 2) {
      sums[0] = x.x();
      sums[1] = x.y();
      sums[2] = x.z();
    }
    if (global == 0)
      sums[3] = Eigen::Map<const Vec3>(s.system().reactions().data() + 3 * s.local().block[i]).norm();
    if (global > last / 10 && global < last - last / 10) {
      ends[0] = std::max(ends[0], -x.z());
      ends[1] = std::max(ends[1], x.z());
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 4, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, ends, 2, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  out.middle = Vec3(sums[0], sums[1], sums[2]);
  out.tension = sums[3];
  out.lowest = -ends[0];
  out.highest = ends[1];
  return out;
}

model::Case floating(double span, double EI, double speed, double direction) {
  model::LineType t = EI > 0 ? beam_type(kEA, EI, EI, 120) : cable_type(kEA, 120);
  t.outer_diameter = t.contact_diameter = kDiameter;
  t.Cd_normal = 1.2;
  // The ends are at the height of the floating hose.
  const double level = 0.5 * kDiameter - kDraught;
  model::Case c = one_line(t, kLength, 100, anchor({0, 0, level}), anchor({span, 0, level}));
  c.environment.gravity = kGravity;
  c.environment.water.present = true;
  c.environment.water.density = kDensity;
  if (speed > 0) c.environment.water.current.profile = {{0, speed, direction}};
  return c;
}

// Lateral current, no bending: a catenary of constant tension a D, D the drag of the submerged part.
TEST(Relaxation, AHoseFloatsInACurrentAcross) {
  const double drag = 0.6 * 0.5 * kDensity * 1.2 * kDiameter * 0.72 * 0.72;
  for (const double span : {200.0, 80.0}) {
    double a = 1;  // 2 a sinh(span/2a) = L
    for (double low = 1e-3, high = 1e5; high - low > 1e-12 * high;) {
      a = 0.5 * (low + high);
      (span / a < 1000 && 2 * a * std::sinh(span / (2 * a)) < kLength ? high : low) = a;
    }
    const double sag = a * (std::cosh(span / (2 * a)) - 1);
    for (const auto relaxation : {model::Relaxation::never, model::Relaxation::always}) {
      model::Case c = floating(span, 0, 0.72, -M_PI / 2);
      c.statics.relaxation = relaxation;
      const AtRest r = at_rest(c);
      SCOPED_TRACE(testing::Message() << "span " << span);
      EXPECT_EQ(r.report.relaxation_steps > 0, relaxation == model::Relaxation::always);
      EXPECT_NEAR(r.tension, a * drag, 3e-3 * a * drag);
      EXPECT_NEAR(r.middle.y(), -sag, 3e-3 * sag);
      EXPECT_NEAR(r.highest, 0.5 * kDiameter - kDraught, 1e-5);
      EXPECT_NEAR(r.lowest, 0.5 * kDiameter - kDraught, 1e-5);
    }
  }
}

// In still water only bending resists the thrust: Euler's elastica between hinges. With the modulus k of its
// end slope, span/L = 2 E/K - 1, its height is L k/K and the thrust EI (2K/L)².
TEST(Relaxation, AHoseFloatsInStillWater) {
  for (const double span : {200.0, 30.0}) {
    double k = 0.5;
    for (double low = 0, high = 1 - 1e-12; high - low > 1e-14;) {
      k = 0.5 * (low + high);
      (2 * std::comp_ellint_2(k) / std::comp_ellint_1(k) - 1 > span / kLength ? low : high) = k;
    }
    const double K = std::comp_ellint_1(k);
    for (const auto relaxation : {model::Relaxation::automatic, model::Relaxation::always}) {
      model::Case c = floating(span, kEI, 0, 0);
      c.statics.relaxation = relaxation;
      const AtRest r = at_rest(c);
      SCOPED_TRACE(testing::Message() << "span " << span);
      EXPECT_NEAR(std::abs(r.middle.y()), kLength * k / K, 1e-3 * kLength * k / K);
      EXPECT_NEAR(r.tension, kEI * std::pow(2 * K / kLength, 2), 2e-3 * kEI * std::pow(2 * K / kLength, 2));
      EXPECT_NEAR(r.highest, 0.5 * kDiameter - kDraught, 1e-5);
      EXPECT_EQ(r.report.negative_eigenvalues, 0);
    }
  }
}

// In a current along the chord the hose lies downstream of both ends, with little drag along it.
TEST(Relaxation, AHoseFloatsInACurrentAlong) {
  for (const auto relaxation : {model::Relaxation::automatic, model::Relaxation::always}) {
    model::Case c = floating(10, kEI, 0.72, 0);
    c.statics.relaxation = relaxation;
    const AtRest r = at_rest(c);
    EXPECT_GT(r.middle.x(), 0.4 * kLength);
    EXPECT_NEAR(r.highest, 0.5 * kDiameter - kDraught, 1e-4);
    EXPECT_EQ(r.report.negative_eigenvalues, 0);
  }
}

model::Case on_the_floor(bool beam, double depth_of_ends) {
  model::LineType t = beam ? beam_type(kEA, 1e4, 1e4, 300) : cable_type(kEA, 300);
  t.outer_diameter = t.contact_diameter = kDiameter;
  model::Case c = one_line(t, 200, 100, anchor({0, 0, -depth_of_ends}), anchor({30, 0, -depth_of_ends}));
  c.environment.gravity = kGravity;
  c.environment.water.present = true;
  c.environment.water.density = kDensity;
  c.environment.water.depth = 100;
  c.environment.seabed.present = true;
  c.environment.seabed.depth = 100;
  c.environment.seabed.normal_stiffness = 1e5;
  return c;
}

// A line six times longer than the distance of its ends, with ends on the bed or above it: its middle lies at
// the height where the bed carries its weight.
TEST(Relaxation, SlackLinesLieOnTheBed) {
  const double weight = kGravity * (300 - kDensity * M_PI / 4 * kDiameter * kDiameter);
  const double rest = -100 + 0.5 * kDiameter - weight / (1e5 * kDiameter);
  for (const bool beam : {false, true})
    for (const double depth : {100 - 0.5 * kDiameter, 80.0})
      for (const auto relaxation : {model::Relaxation::automatic, model::Relaxation::always}) {
        model::Case c = on_the_floor(beam, depth);
        c.statics.relaxation = relaxation;
        SCOPED_TRACE(testing::Message() << (beam ? "beam" : "cable") << ", ends at " << depth << " m");
        const AtRest r = at_rest(c);
        EXPECT_NEAR(r.middle.z(), rest, 1e-3);
        EXPECT_LE(r.report.negative_eigenvalues, 0);
        // From 80 m: the end carries the suspended 20 m, and a little for the bend.
        if (depth == 80.0) {
          EXPECT_GT(r.tension, 18.5 * weight);
          EXPECT_LT(r.tension, 22 * weight);
        }
      }
}

// Newton's iteration does not converge from a catenary below the bed; dynamic relaxation does, out of the
// plane.
TEST(Relaxation, WhatNewtonCannotDo) {
  if (ranks_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  model::Case c = on_the_floor(false, 100 - 0.5 * kDiameter);
  c.lines[0].sections[0].elements = 40;
  c.lines[0].start = model::Start::catenary;
  c.statics.relaxation = model::Relaxation::never;
  EXPECT_THROW(at_rest(c), SolveError);
  c.statics.relaxation = model::Relaxation::automatic;
  const AtRest r = at_rest(c);
  const double weight = kGravity * (300 - kDensity * M_PI / 4 * kDiameter * kDiameter);
  EXPECT_GT(r.report.relaxation_steps, 0);
  EXPECT_NEAR(r.middle.z(), -100 + 0.5 * kDiameter - weight / (1e5 * kDiameter), 1e-3);
}

TEST(Relaxation, ItReportsThePlaceWithoutRest) {
  model::Case c = floating(100, kEI, 0.72, 1.5);
  c.lines[0].start = model::Start::catenary;
  c.statics.relaxation = model::Relaxation::always;
  c.statics.relaxation_steps = 3;
  try {
    at_rest(c);
    ADD_FAILURE();
  } catch (const SolveError& e) {
    EXPECT_NE(std::string(e.what()).find("not at rest after"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("line line, arc length"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace hawser::test::relaxation
