// Statics of floating bodies by default: on other bodies without the key contact_friction, on springs and in
// the current.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/mpi.hpp"
#include "verification/bodies_rig.hpp"

namespace hawser::test::bodies_at_rest {
namespace {

constexpr double kMass = 600, kGravity = 9.80665;

// A block of 1 x 0.6 x 0.4 m with its lower face on a plane, both turned by `slope` [rad] about y, and the
// block by `tilt` more about its lower edge.
std::string block(double slope, double tilt, double friction) {
  const double a = slope + tilt;
  const Vec3 edge(0.5 * std::cos(slope), 0, -0.5 * std::sin(slope));
  const Vec3 centre =
      edge + Vec3(-0.5 * std::cos(a) + 0.2 * std::sin(a), 0, 0.5 * std::sin(a) + 0.2 * std::cos(a));
  return fmt::format(R"(hawser: 1
bodies:
  block:
    position: [{:.15f}, 0, {:.15f}]
    rotation_deg: [0, {:.13f}, 0]
    floating: {{mass: {}, inertia: [26, 58, 68], weight: true}}
volumes:
  floor: {{shape: {{plane: {{point: [0, 0, 0], normal: [{:.15f}, 0, {:.15f}]}}}}{}}}
  block:
    shape: {{box: {{centre: [0, 0, 0], size: [1, 0.6, 0.4]}}}}
    body: block
    normal_stiffness: {{per_point: 1e7}}
{}dynamics: {{duration: 1}}
)",
                     centre.x(), centre.z(), a * 180 / M_PI, kMass, std::sin(slope), std::cos(slope),
                     friction > 0 ? ", friction: 10" : "",
                     friction > 0 ? fmt::format("    friction: {}\n", friction) : "");
}

int notes_on_held_bodies(const BodiesRun& r) {
  int count = 0;
  for (const std::string& n : r.sim.notes()) count += n.find("without its weight") != std::string::npos;
  return count;
}

// Largest speed [m/s] of a point at 1 m from the centre in the first half second of motion.
double fastest(BodiesRun& r) {
  double speed = 0;
  r.start();
  r.move(0.5, [&](const StepInfo&) {
    const RigidPose now = r.poses()[0];
    speed = std::max(speed, now.velocity.norm() + now.angular_velocity.norm());
  });
  return speed;
}

// Without friction nothing but the plane supports the block; with it the block rests on a slope, too.
TEST(BodiesAtRest, OnAPlaneAndByFriction) {
  for (const auto& [slope, friction] : {std::pair(0.0, 0.0), std::pair(0.0, 0.4), std::pair(0.3, 0.4)}) {
    BodiesRun r(block(slope, 0, friction));
    r.sim.solve_statics();
    EXPECT_EQ(notes_on_held_bodies(r), 0) << slope << " " << friction;
    // A block that statics holds is pushed out of contact and falls by 1 mm: 0.14 m/s.
    EXPECT_LT(fastest(r), 1e-6) << slope << " " << friction;
  }
}

// A block that would slide or turn onto its face is held where it starts; the note has the remedy.
TEST(BodiesAtRest, HeldWhereItWouldMove) {
  for (const auto& [slope, tilt, friction] :
       {std::tuple(0.3, 0.0, 0.0), std::tuple(0.5, 0.0, 0.4), std::tuple(0.0, 0.03, 0.4)}) {
    BodiesRun r(block(slope, tilt, friction));
    const RigidPose start = r.poses(r.sim.state().at_rest())[0];
    r.sim.solve_statics();
    const RigidPose rest = r.poses(r.sim.state().at_rest())[0];
    EXPECT_LT((rest.position - start.position).norm(), 2e-3) << slope << " " << tilt;
    EXPECT_LT(rest.rotation.angularDistance(start.rotation), 5e-3) << slope << " " << tilt;
    EXPECT_EQ(notes_on_held_bodies(r), rank_of(PETSC_COMM_WORLD) == 0 ? 1 : 0) << slope << " " << tilt;
  }
}

// Without friction a block slides with g sin(slope) from rest; it starts pressed by no more than its weight.
TEST(BodiesAtRest, SlidesFromItsStart) {
  const double slope = 0.3;
  BodiesRun r(block(slope, 0, 0));
  r.sim.solve_statics();
  const Vec3 from = r.poses(r.sim.state().at_rest())[0].position;
  r.start();
  r.move(1, [](const StepInfo&) {});
  const Vec3 along(std::cos(slope), 0, -std::sin(slope));
  EXPECT_NEAR(along.dot(r.poses()[0].position - from), 0.5 * kGravity * std::sin(slope), 0.01);
}

// A free barge in a current: its draught is 2 m, whatever the current.
TEST(BodiesAtRest, AFreeHullInACurrentHasItsDraught) {
  BodiesRun r(R"(hawser: 1
environment: {water: {density: 1025, depth: 100}, current: {speed: 0.5}}
bodies:
  barge: {position: [0, 0, 0.7], floating: {mass: 410000, inertia: [4e6, 1.4e7, 1.7e7], hull: {volumes: [hull]}}}
volumes:
  hull: {shape: {box: {centre: [0, 0, 0], size: [20, 10, 4]}}, body: barge}
dynamics: {duration: 1}
)");
  r.sim.solve_statics();
  EXPECT_NEAR(r.poses(r.sim.state().at_rest())[0].position.z(), 0, 1e-6);
}

// Springs hold bodies against the drag of the current: a column of 50 m in a current that falls linearly from
// 2 m/s to 0 in 100 m, ½ ρ Cd D ∫ u² dz / k, and a neutral buoy, ½ ρ A u² / k.
TEST(BodiesAtRest, OnSpringsInACurrent) {
  BodiesRun column(R"(hawser: 1
environment: {water: {density: 1025, depth: 100}, current: {profile: [{depth: 0, speed: 2}, {depth: 100, speed: 0}]}}
bodies:
  column:
    position: [0, 0, 0]
    floating:
      {mass: 1.0e6, inertia: [1e8, 1e8, 1e8], weight: false, stiffness: [1e6, 1e6, 1e9],
       turning_stiffness: [1e12, 1e12, 1e12], members: [{from: [0, 0, -50], to: [0, 0, 0], diameter: 1, Cd: 1, Ca: 0}]}
dynamics: {duration: 1}
)");
  column.sim.solve_statics();
  const double drag = 0.5 * 1025 * 4 * 100.0 / 3 * (1 - 1.0 / 8);
  EXPECT_NEAR(column.poses(column.sim.state().at_rest())[0].position.x(), drag / 1e6, 1e-4);
  BodiesRun buoy(R"(hawser: 1
environment: {water: {density: 1025, depth: 100}, current: {speed: 1}}
bodies:
  buoy:
    position: [0, 0, -20]
    floating: {mass: 10250, inertia: [1e5, 1e5, 1e5], weight: true, stiffness: [1000, 1000, 0],
               in_water: {volume: 10, height: 2, drag_area: [4, 4, 4]}}
dynamics: {duration: 1}
)");
  buoy.sim.solve_statics();
  EXPECT_NEAR(buoy.poses(buoy.sim.state().at_rest())[0].position.x(), 0.5 * 1025 * 4 / 1000, 1e-6);
}

}  // namespace
}  // namespace hawser::test::bodies_at_rest
