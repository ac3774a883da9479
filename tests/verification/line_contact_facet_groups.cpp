// A pipe rests in a groove of two walls, each a volume of its own. (contact_corner tests facet groups of one
// mesh.)
#include "verification/contact_rig.hpp"

namespace hawser::test::line_contact_facet_groups_test {
namespace {

// The pipe is released beside the bottom and comes to rest there: each wall carries w L / (2 cos a).
TEST(LineContactFacetGroups, BothBear) {
  constexpr double kLength = 10, kMass = 100, kRadius = 0.15;
  for (const double angle : {0.3, 0.8, 1.3}) {  // of the walls' normals to the vertical
    model::LineType type = beam_type(1e8, 1e6, 1e6, kMass);
    type.outer_diameter = type.contact_diameter = 2 * kRadius;
    model::Case c = one_line(type, kLength, 5, {}, {});
    c.environment.gravity = 10;
    // The axis touches both walls at kRadius / cos(angle) above the bottom.
    const double z = kRadius / std::cos(angle) + 0.002;
    c.lines[0].start = model::Start::points;
    c.lines[0].points = {{0, 0.002, z}, {kLength, 0.002, z}};
    std::vector<std::shared_ptr<const Surface>> walls;
    for (const double side : {-1.0, 1.0}) {
      model::Volume v;
      v.name = side < 0 ? "left" : "right";
      v.basis = model::StiffnessBasis::per_length;
      v.normal_stiffness = 1e6;
      v.relative_damping = 0.2;
      c.volumes.push_back(v);
      walls.push_back(
          std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3(0, side * std::sin(angle), std::cos(angle))));
    }
    c.statics.enabled = false;
    c.dynamics.duration = 8;
    Simulation s(PETSC_COMM_WORLD, c, walls);
    Dynamics& d = s.dynamics();
    d.start(s.state());
    int steps = 0;
    d.run(
        8, [](double t) { return t + 100; }, [&](const StepInfo&) { return ++steps < 4000; });
    EXPECT_LT(steps, 4000);
    ActiveContacts touches;
    s.line_volume_contact()->active_contacts(touches);
    double force[2] = {0, 0};
    for (const ActiveContact& t : touches) force[t.volume] += t.force;
    const double each = kMass * 10 * kLength / (2 * std::cos(angle));
    std::printf("groove of %.1f rad: %.2f and %.2f N, expected %.2f N; %d steps\n", angle, force[0], force[1],
                each, steps);
    EXPECT_NEAR(force[0], each, 0.01 * each);
    EXPECT_NEAR(force[1], each, 0.01 * each);
  }
}

}  // namespace
}  // namespace hawser::test::line_contact_facet_groups_test
