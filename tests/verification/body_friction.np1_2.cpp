// Friction between bodies: closed forms of boxes, balls and bars on slopes; momentum of two bodies.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/bodies_rig.hpp"

namespace hawser::test::body_friction {
namespace {

constexpr double kGravity = 9.80665;

struct Motion {
  std::vector<RigidPose> end;  // of the bodies
  double friction = 0;         // J, dissipated
};

Motion run(const std::string& yaml) {
  BodiesRun r(yaml);
  r.run_without_statics();
  return {r.poses(), r.energy().friction};
}

constexpr double kMass = 600, kPress = 1e7;  // kg; N/m, N/m² or N/m³

// A body on a plane inclined by `slope` [rad] towards x, its frame `height` [m] above the plane.
std::string on_slope(double slope, double friction, const std::string& shape, const std::string& basis,
                     double height, const std::string& inertia, double duration) {
  const double s = std::sin(slope);
  const double c = std::cos(slope);
  return fmt::format(R"(hawser: 1
bodies:
  load:
    position: [{:.12f}, 0, {:.12f}]
    rotation_deg: [0, {:.12f}, 0]
    floating: {{mass: {}, inertia: {}, weight: true}}
volumes:
  slope: {{shape: {{plane: {{point: [0, 0, 0], normal: [{:.15f}, 0, {:.15f}]}}}}, friction: 10}}
  load:
    shape: {}
    body: load
    normal_stiffness: {{{}: {}}}
    relative_damping: 0.3
    smoothing: 1e-3
    friction: {{axial: {}, mobilisation_length: 1e-6}}
statics: false
dynamics: {{duration: {}}}
)",
                     height * s, height * c, slope * 180 / M_PI, kMass, inertia, s, c, shape, basis, kPress,
                     friction, duration);
}

// m between the surfaces at rest, within the smoothing ramp of half width s = 1e-3 m: F = k (s - g)²/(4 s)
// for each of `count` points, metres or m².
double gap_at_rest(double slope, double count) {
  const double F = kMass * kGravity * std::cos(slope) / count;
  return 1e-3 - std::sqrt(4e-3 * F / kPress);
}

constexpr const char* kBox = "{box: {centre: [0, 0, 0], size: [1, 0.6, 0.2]}}";
constexpr const char* kBoxInertia = "[20, 52, 68]";
constexpr double kCorners = 4, kEdges = 3.2;

double down(const Motion& m, double slope) {
  return m.end[0].position.dot(Vec3(std::cos(slope), 0, -std::sin(slope)));
}

// Friction at corners and edges holds a box up to the slope arctan(mu). Above it the box slides with g (sin -
// mu cos).
TEST(BodyFriction, BoxOnASlope) {
  const double mu = 0.4;
  const double limit = std::atan(mu);
  for (const auto& [basis, count] : {std::pair("per_point", kCorners), {"per_length", kEdges}}) {
    const auto moved = [&](double slope, double duration) {
      const double height = 0.1 + gap_at_rest(slope, count);
      return down(run(on_slope(slope, mu, kBox, basis, height, kBoxInertia, duration)), slope);
    };
    EXPECT_LT(std::abs(moved(limit - 0.1 * M_PI / 180, 1)), 1e-3) << basis;
    const double over = limit + 0.1 * M_PI / 180;
    const double slow = kGravity * (std::sin(over) - mu * std::cos(over));
    EXPECT_NEAR(moved(over, 1), 0.5 * slow, 0.3 * 0.5 * slow) << basis;
    const double slope = 35 * M_PI / 180;
    const double a = kGravity * (std::sin(slope) - mu * std::cos(slope));
    EXPECT_NEAR(moved(slope, 0.5), 0.125 * a, 0.005 * 0.125 * a) << basis;
  }
}

// Contact of faces has thousands of points, so this run is short.
TEST(BodyFriction, FaceOnASlope) {
  int size = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (size > 1) GTEST_SKIP() << "long; on 1 rank";
  const double mu = 0.4;
  const double slope = 35 * M_PI / 180;
  const double a = kGravity * (std::sin(slope) - mu * std::cos(slope));
  const Motion m =
      run(on_slope(slope, mu, kBox, "per_area", 0.1 + gap_at_rest(slope, 0.6), kBoxInertia, 0.03));
  EXPECT_NEAR(m.end[0].velocity.norm(), 0.03 * a, 0.04 * 0.03 * a);
}

// The friction energy is the loss of potential energy less the kinetic energy.
TEST(BodyFriction, WorkOnASlope) {
  const double mu = 0.4, slope = 35 * M_PI / 180;
  for (const auto& [basis, count] : {std::pair("per_point", kCorners), {"per_length", kEdges}}) {
    const double height = 0.1 + gap_at_rest(slope, count);
    const Motion m = run(on_slope(slope, mu, kBox, basis, height, kBoxInertia, 0.5));
    const double work = kMass * kGravity * mu * std::cos(slope) * down(m, slope);
    EXPECT_NEAR(m.friction, work, 0.005 * work) << basis;
  }
}

// A ball rolls with g sin / (1 + 2/5) if mu > 2/7 tan; otherwise it slides with g (sin - mu cos) and its
// angular acceleration is 5/2 mu g cos / r. The same for a bar with J = m r²/2: g sin / (1 + 1/2).
TEST(BodyFriction, BallsAndBarsRoll) {
  const double r = 0.5, slope = 30 * M_PI / 180, g = kGravity;
  const auto check = [&](const char* shape, const char* basis, double count, double inertia, double mu) {
    const double share = inertia / (600 * r * r);
    const double rolling = g * std::sin(slope) / (1 + share);
    const bool rolls = mu > std::tan(slope) * share / (1 + share);
    const double a = rolls ? rolling : g * (std::sin(slope) - mu * std::cos(slope));
    const double turn = rolls ? a / r : mu * g * std::cos(slope) / (share * r);
    const double height = r + gap_at_rest(slope, count);
    const Motion m = run(on_slope(slope, mu, shape, basis, height, fmt::format("[60, {}, 60]", inertia), 1));
    const std::string what = fmt::format("{}, mu {}", shape, mu);
    EXPECT_NEAR(down(m, slope), 0.5 * a, 0.005 * a) << what;
    EXPECT_NEAR(m.end[0].angular_velocity.y(), turn, 0.005 * turn) << what;
  };
  for (const double mu : {0.6, 0.1}) {
    check("{sphere: {centre: [0, 0, 0], radius: 0.5}}", "per_point", 1, 60, mu);
    for (const char* basis : {"per_point", "per_length"})
      check("{capsule: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.5}}", basis, 2, 75, mu);
  }
}

// A sticking body vibrates on its friction springs k_t with the contact's damping: four corners, each with c
// = 2 zeta sqrt(k_t m), have w = sqrt(4 k_t/m) and the damping ratio 2 zeta. The friction energy is the
// kinetic energy at the start.
TEST(BodyFriction, WhatSticksIsDamped) {
  const double zeta = 0.05;
  const double k = 2.5e6;
  const double speed = 0.02;
  const double w = std::sqrt(4 * k / kMass);
  const double D = 2 * zeta;
  const std::string yaml = fmt::format(R"(hawser: 1
bodies:
  load:
    position: [0, 0, {:.15f}]
    floating: {{mass: {}, inertia: [1e9, 1e9, 1e9], weight: true, velocity: [{}, 0, 0]}}
volumes:
  floor: {{shape: {{plane: {{point: [0, 0, 0], normal: [0, 0, 1]}}}}, friction: 1}}
  load:
    shape: {}
    body: load
    normal_stiffness: {{per_point: {}}}
    relative_damping: {}
    smoothing: 1e-3
    friction: {{axial: 1, shear_stiffness: {}}}
statics: false
dynamics: {{duration: 1, max_step: 2e-4, rho_infinity: 1}}
)",
                                       0.1 + gap_at_rest(0, kCorners), kMass, speed, kBox, kPress, zeta, k);
  BodiesRun r(yaml);
  r.start();
  double error = 0;
  r.move(0.3, [&](const StepInfo&) {
    const double t = r.sim.dynamics().committed_kinematics().time;
    const double wd = w * std::sqrt(1 - D * D);
    const double x = speed / wd * std::exp(-D * w * t) * std::sin(wd * t);
    error = std::max(error, std::abs(r.poses()[0].position.x() - x));
  });
  EXPECT_LT(error, 0.01 * speed / w);
  r.move(1);
  const double energy = 0.5 * kMass * speed * speed;
  EXPECT_NEAR(r.energy().friction, energy, 0.005 * energy);
}

// A ship of 2000 t is pressed on a quay by N = 100 kN at its corners, at rest on their springs, and pulled
// along it by F < mu N. It sticks: the corners move by s = F/(4 k) against friction, and the ship turns by
// -F b/(4 k_n l²), k_n = k a/(2 d) on the ramp of half width d at the distance a = sqrt(4 d N/(4 k)) from its
// beginning; b: half the beam, l: half the length. Its dampers, four times 2 zeta sqrt(k m), are critical.
// Far from the origin positions have larger rounding errors.
TEST(BodyFriction, ShipSticksOnAQuay) {
  const double k = 1e8;
  const double ramp = 0.01;
  const double push = 1e5;
  const double pull = 2e4;
  const double a = std::sqrt(ramp * push / k);
  const double normal_stiffness = k * a / (2 * ramp);
  const double slip = pull / (4 * k);
  const double turn = -pull * 5 / (4 * normal_stiffness * 30 * 30);
  for (const double x : {0.0, 300.0}) {
    const std::string yaml = fmt::format(R"(hawser: 1
bodies:
  ship:
    position: [{0}, {1:.15f}, 0]
    floating:
      mass: 2.0e6
      inertia: [8.0e7, 8.0e7, 1.5e8]
      stiffness: [0, 0, 2.0e6]
      damping: [0, 0, 1.0e6]
      turning_stiffness: [1.0e8, 1.0e8, 0]
      turning_damping: [1.0e8, 1.0e8, 0]
      loads: [{{force: [{2}, {3}, 0]}}]
volumes:
  quay: {{friction: 0.3, shape: {{box: {{centre: [{0}, -10, 0], size: [200, 20, 20]}}}}}}
  ship:
    body: ship
    friction: 0.3
    normal_stiffness: {{per_point: {4}}}
    relative_damping: 0.5
    shape: {{box: {{centre: [0, 0, 0], size: [60, 10, 6]}}}}
statics: false
dynamics: {{duration: 20, min_step: 1.0e-4}}
)",
                                         x, 5 + ramp - a, pull, -push, k);
    BodiesRun r(yaml);
    r.start();
    int steps = 0;
    r.move(20, [&](const StepInfo&) { ++steps; });
    EXPECT_LT(steps, 2000) << x;
    const RigidPose end = r.poses()[0];
    const Vec3 corner = end.to_space(Vec3(0, -5, 0));
    EXPECT_NEAR(corner.x() - x, slip, 1e-3 * slip) << x;
    EXPECT_NEAR(2 * end.rotation.z(), turn, 1e-3 * std::abs(turn)) << x;
    EXPECT_LT(end.velocity.norm(), 1e-7) << x;
  }
}

// A slab slides on a free block, both pressed together by 3000 N. Momentum is constant, both end with one
// velocity except for vibration on the friction springs, and friction dissipates the energy of the relative
// motion.
TEST(BodyFriction, SlabOnABlock) {
  const Motion m = run(R"(hawser: 1
environment: {gravity: 0}
bodies:
  block: {position: [0, 0, 0], floating: {mass: 900, inertia: [1e9, 1e9, 1e9], loads: [{force: [0, 0, 3000]}]}}
  slab:
    position: [-0.5, 0, 0.60045]
    floating: {mass: 300, inertia: [26, 58, 68], velocity: [2, 0, 0], loads: [{force: [0, 0, -3000]}]}
volumes:
  block: {shape: {box: {centre: [0, 0, 0], size: [6, 2, 1]}}, body: block, normal_stiffness: {per_length: 1.0e7}, friction: 0.3}
  slab:
    shape: {box: {centre: [0, 0, 0], size: [1, 0.6, 0.2]}}
    body: slab
    normal_stiffness: {per_point: 1.0e7}
    friction: 0.3
    relative_damping: 0.5
statics: false
dynamics: {duration: 1}
)");
  const Vec3 momentum = 900 * m.end[0].velocity + 300 * m.end[1].velocity;
  EXPECT_NEAR(momentum.x(), 600, 1e-6);
  EXPECT_NEAR(m.end[0].velocity.x(), 0.5, 0.005);
  EXPECT_NEAR(m.end[1].velocity.x(), 0.5, 0.015);
  EXPECT_NEAR(m.friction, 450, 5);
}

}  // namespace
}  // namespace hawser::test::body_friction
