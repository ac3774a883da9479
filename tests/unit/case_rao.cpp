// Vessel motion by responses, from the case to the body's pose.
#include <gtest/gtest.h>

#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/wave_components.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {
namespace {

// Heave of 1 without lag, pitch of 2 deg/m a quarter early; the ship heads for 30 deg.
TEST(CaseRao, BodyFollowsTheWaves) {
  const std::string text = R"(
hawser: 1
environment:
  water: {depth: 100}
  waves: {regular: {height: 3, period: 9, direction_deg: 75}, ramp: 5}
line_types:
  chain: {outer_diameter: 0.1, mass_per_length: 100, EA: 1e8, bending: false}
bodies:
  ship:
    position: [40, -20, 3]
    rotation_deg: [0, 0, 30]
    motion: {rao: {phase: lead, rows: [[5, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 90, 0, 0], [20, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 90, 0, 0]]}}
lines:
  mooring:
    sections: [{type: chain, length: 120, elements: 4}]
    end_a: {anchor: [100, 0, -50]}
    end_b: {body: ship, at: [0, 0, 0]}
dynamics: {duration: 60}
)";
  const model::Case c = io::read_case_text(text, "/nowhere/case.yaml");
  const Bodies bodies(c.bodies);
  const WaveField w = model::wave_field(c.environment);
  const Vec3 side = Vec3(-std::sin(M_PI / 6), std::cos(M_PI / 6), 0);
  EXPECT_LT((bodies.pose(0, 0).position - Vec3(40, -20, 3)).norm(), 1e-12);  // the ramp's start
  for (double t = 5.5; t < 60; t += 1.3) {
    const RigidPose p = bodies.pose(0, t);
    const double h = 1e-3, now = w.elevation(40, -20, t);
    EXPECT_NEAR(p.position.z() - 3, now, 2e-6) << t;
    EXPECT_NEAR(p.velocity.z(), (w.elevation(40, -20, t + h) - w.elevation(40, -20, t - h)) / (2 * h), 1e-4)
        << t;
    const Vec3 turn = log_so3(p.rotation * exp_so3(Vec3(0, 0, M_PI / 6)).conjugate());
    EXPECT_LT((turn - 2 * M_PI / 180 * w.elevation(40, -20, t + 9. / 4) * side).norm(), 1e-6) << t;
  }
}

}  // namespace
}  // namespace hawser
