// Friction between bodies in statics and in the motion that starts from it: crates at rest on slopes, on each
// other and on moving decks; a loaded fender.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/terms/body_contact.hpp"
#include "verification/bodies_rig.hpp"

namespace hawser::test::body_friction_statics {
namespace {

constexpr double kMass = 600, kPress = 1e7, kGravity = 9.80665;

// A crate of 1 x 0.6 x 0.2 m, `gap` [m] above a plane inclined by `slope` [rad] towards x.
std::string crate(double slope, double friction, double gap, const std::string& statics) {
  const double s = std::sin(slope);
  const double c = std::cos(slope);
  const double height = 0.1 + gap;
  return fmt::format(R"(hawser: 1
bodies:
  crate:
    position: [{:.15f}, 0, {:.15f}]
    rotation_deg: [0, {:.13f}, 0]
    floating: {{mass: {}, inertia: [20, 52, 68], weight: true}}
volumes:
  slope: {{shape: {{plane: {{point: [0, 0, 0], normal: [{:.15f}, 0, {:.15f}]}}}}, friction: 10}}
  crate:
    shape: {{box: {{centre: [0, 0, 0], size: [1, 0.6, 0.2]}}}}
    body: crate
    normal_stiffness: {{per_point: {}}}
    smoothing: 0
    relative_damping: 0.3
    friction: {}
statics: {}
dynamics: {{duration: 1}}
)",
                     height * s, height * c, slope * 180 / M_PI, kMass, s, c, kPress, friction, statics);
}

constexpr const char* kWithFriction = "{contact_friction: true, relaxation_steps: 300}";

double down(const RigidPose& p, double slope) {
  return p.position.dot(Vec3(std::cos(slope), 0, -std::sin(slope)));
}

// The crate moves by the flexibility of its four friction springs, k_t = k, and of its normal springs, on
// which it tilts: u = F/4k (1 + h²/a²) with the arms h = 0.1 m and a = 0.5 m of its centre. The motion starts
// at rest.
TEST(BodyFrictionStatics, CrateOnASlopeRests) {
  const double slope = 20 * M_PI / 180;
  BodiesRun r(crate(slope, 0.4, 0, kWithFriction));
  r.sim.solve_statics();
  const RigidPose rest = r.poses(r.sim.state().at_rest())[0];
  const double u = kMass * kGravity * std::sin(slope) / (4 * kPress) * (1 + 0.01 / 0.25);
  EXPECT_NEAR(down(rest, slope), u, 0.01 * u);
  r.start();
  double moved = 0, fast = 0;
  r.move(1, [&](const StepInfo&) {
    const RigidPose now = r.poses()[0];
    moved = std::max(moved, (now.position - rest.position).norm());
    fast = std::max(fast, now.velocity.norm());
  });
  EXPECT_LT(moved, 1e-3 * u);
  EXPECT_LT(fast, 1e-6);
  EXPECT_LT(std::abs(r.energy().friction), 1e-6);
}

// Statics finds equilibrium 0.1 degrees below atan(mu), and none 0.1 degrees above it.
TEST(BodyFrictionStatics, HoldsUpToTheAngleOfFriction) {
  const double mu = 0.4;
  const double limit = std::atan(mu);
  const double step = 0.1 * M_PI / 180;
  BodiesRun holds(crate(limit - step, mu, 0, kWithFriction));
  BodiesRun slides(crate(limit + step, mu, 0, kWithFriction));
  EXPECT_NO_THROW(holds.sim.solve_statics());
  try {
    slides.sim.solve_statics();
    ADD_FAILURE() << "it rests";
  } catch (const SolveError& e) {
    EXPECT_NE(std::string(e.what()).find("crate"), std::string::npos) << e.what();
  }
}

// A crate above the slope comes to rest on it. Without friction in statics it is held at its start, and a
// note reports this.
TEST(BodyFrictionStatics, CrateAboveASlope) {
  const double slope = 10 * M_PI / 180;
  BodiesRun r(crate(slope, 0.4, 0.3, kWithFriction));
  r.sim.solve_statics();
  const RigidPose rest = r.poses(r.sim.state().at_rest())[0];
  const double height = rest.position.dot(Vec3(std::sin(slope), 0, std::cos(slope)));
  EXPECT_NEAR(height, 0.1 - kMass * kGravity * std::cos(slope) / (4 * kPress), 1e-6);

  BodiesRun held(crate(slope, 0.4, 0, "true"));
  held.sim.solve_statics();
  EXPECT_LT((held.poses(held.sim.state().at_rest())[0].position - held.c.bodies[0].position).norm(), 1e-4);
  int reported = 0;
  for (const std::string& n : held.sim.notes()) reported += n.find("without its weight") != std::string::npos;
  EXPECT_EQ(reported, hawser::rank_of(MPI_COMM_WORLD) == 0);
  for (const std::string& n : r.sim.notes()) EXPECT_EQ(n.find("without its weight"), std::string::npos) << n;
}

// A crate starts 3 m above a deck of 5 cm and comes to rest on the deck, however long the steps of dynamic
// relaxation are.
TEST(BodyFrictionStatics, CrateAboveAThinDeck) {
  BodiesRun r(R"(hawser: 1
bodies:
  crate: {position: [0.3, 0.2, 3], floating: {mass: 600, inertia: [20, 52, 68], weight: true}}
volumes:
  deck: {shape: {box: {centre: [0, 0, -0.025], size: [6, 6, 0.05]}}, normal_stiffness: {per_length: 1e8}, friction: 0.4}
  crate: {shape: {box: {centre: [0, 0, 0], size: [1, 0.6, 0.2]}}, body: crate, normal_stiffness: {per_point: 1e7}, smoothing: 0, friction: 0.4}
statics: {contact_friction: true}
dynamics: {duration: 1}
)");
  r.sim.solve_statics();
  EXPECT_NEAR(r.poses(r.sim.state().at_rest())[0].position.z(), 0.1 - kMass * kGravity / (4 * kPress), 1e-6);
}

// Only the corners or edges of the deck touch, and the crate lies, or falls from 3 m, between them.
TEST(BodyFrictionStatics, CrateBetweenTheCornersOfADeck) {
  for (const char* basis : {"per_point", "per_length"})
    for (const double thickness : {0.5, 0.05})
      for (const double height : {0.12, 3.0}) {
        BodiesRun r(fmt::format(R"(hawser: 1
bodies:
  crate: {{position: [0.3, 0.2, {}], floating: {{mass: 600, inertia: [20, 52, 68], weight: true}}}}
volumes:
  deck: {{shape: {{box: {{centre: [0, 0, {}], size: [6, 6, {}]}}}}, normal_stiffness: {{{}: 1e7}}, friction: 0.4}}
  crate: {{shape: {{box: {{centre: [0, 0, 0], size: [1, 0.6, 0.2]}}}}, body: crate, normal_stiffness: {{per_area: 1e8}}, friction: 0.4}}
statics: {{contact_friction: true}}
)",
                                height, -0.5 * thickness, thickness, basis));
        std::string what;
        try {
          r.sim.solve_statics();
        } catch (const SolveError& e) {
          what = e.what();
        }
        EXPECT_NE(
            what.find(
                "m, but the contact points (corners and edges) of volume deck penetrate by 0 m at most; "
                "give them stiffnesses per_area"),
            std::string::npos)
            << basis << ", " << thickness << " m, from " << height << " m: " << what;
      }
}

// Two free crates, one on the other; two ranks have one each.
TEST(BodyFrictionStatics, StackOnASlope) {
  const double slope = 15 * M_PI / 180;
  const double s = std::sin(slope);
  const double c = std::cos(slope);
  std::string yaml = fmt::format(R"(hawser: 1
bodies:
)");
  for (const auto& [name, height, mass] : {std::tuple("lower", 0.1, 600), {"upper", 0.3, 200}})
    yaml += fmt::format(R"(  {}:
    position: [{:.15f}, 0, {:.15f}]
    rotation_deg: [0, 15, 0]
    floating: {{mass: {}, inertia: [20, 52, 68], weight: true}}
)",
                        name, height * s, height * c, mass);
  yaml += fmt::format(R"(volumes:
  slope: {{shape: {{plane: {{point: [0, 0, 0], normal: [{:.15f}, 0, {:.15f}]}}}}, friction: 0.5}}
  lower: {{shape: {{box: {{centre: [0, 0, 0], size: [1.2, 0.8, 0.2]}}}}, body: lower, normal_stiffness: {{per_length: 1e7}}, friction: 0.5, relative_damping: 0.3}}
  upper: {{shape: {{box: {{centre: [0, 0, 0], size: [1, 0.6, 0.2]}}}}, body: upper, normal_stiffness: {{per_point: 1e7}}, friction: 0.5, relative_damping: 0.3}}
statics: {{contact_friction: true}}
dynamics: {{duration: 0.5}}
)",
                      s, c);
  BodiesRun r(yaml);
  r.sim.solve_statics();
  const std::vector<RigidPose> rest = r.poses(r.sim.state().at_rest());
  EXPECT_LT(std::abs(down(rest[0], slope)), 1e-3);
  EXPECT_LT(std::abs(down(rest[1], slope)), 1e-3);
  r.start();
  r.move(0.5);
  const std::vector<RigidPose> end = r.poses();
  for (size_t b = 0; b < 2; ++b) EXPECT_LT((end[b].position - rest[b].position).norm(), 1e-6) << b;
}

// A fender with a force table between two hulls, pressed by 8e5 N: its depth is that of the table at this
// force, and its friction carries the force along the hulls.
TEST(BodyFrictionStatics, FenderByItsTable) {
  BodiesRun r(R"(hawser: 1
environment: {gravity: 0}
bodies:
  north:
    position: [0, 0, 0]
    floating: {mass: 1e7, inertia: [4e8, 5e8, 6e8], stiffness: [1e6, 1e6, 1e6], turning_stiffness: [1e9, 1e9, 1e9]}
  south:
    position: [62, 0, 0]
    floating:
      mass: 2e7
      inertia: [8e8, 1e9, 1.2e9]
      turning_stiffness: [1e9, 1e9, 1e9]
      loads: [{force: [-8e5, 6e4, -8e4]}]
volumes:
  fender:
    shape: {sphere: {centre: [31, 0, 0], radius: 1}}
    body: north
    normal_stiffness: {table: [[0.1, 4e5], [0.3, 9e5], [1.5, 2e6]], per: point}
    relative_damping: 0.2
    friction: 0.3
  hull: {shape: {box: {centre: [0, 0, 0], size: [60, 40, 20]}}, body: south, normal_stiffness: {per_length: 1e9}, friction: 0.3}
statics: {contact_friction: true}
dynamics: {duration: 2}
)");
  r.sim.solve_statics();
  const auto depth = [](const std::vector<RigidPose>& p) {
    const Vec3 centre = p[1].to_body(p[0].to_space(Vec3(31, 0, 0)));
    return 1 - (-30 - centre.x());
  };
  const std::vector<RigidPose> rest = r.poses(r.sim.state().at_rest());
  const ContactForceTable& table = *r.c.volumes[0].force_table;
  // The rotation springs let the hull's surface turn a little; its normal force is 8e5 N within 1e-5.
  EXPECT_NEAR(table.at(depth(rest)).force, 8e5, 1e-3 * 8e5);
  EXPECT_GT(depth(rest), 0.2);
  r.start();
  r.move(2);
  EXPECT_LT((r.poses()[1].position - rest[1].position).norm(), 1e-5);
}

// Two hulls in roll motion with speeds towards each other, fenders and lines of `mass` [kg/m] between them.
std::string hulls(double mass) {
  std::string yaml = R"(hawser: 1
environment: {gravity: 0}
bodies:
  north:
    position: [0, 0, 0]
    floating: {mass: 1e6, inertia: [2e7, 4e7, 5e7], velocity: [0.4, 0.05, 0.1], angular_velocity: [0.05, 0.02, 0]}
  south:
    position: [22.4, 1, 0]
    floating: {mass: 2e6, inertia: [4e7, 8e7, 1e8], velocity: [-0.2, 0, 0], angular_velocity: [-0.03, -0.02, 0.01]}
volumes:
  fore: {shape: {sphere: {centre: [10, 8, 0], radius: 1}}, body: north, normal_stiffness: {per_point: 2e6}, friction: 0.4, relative_damping: 0.1}
  aft: {shape: {capsule: {from: [10, -8, -1], to: [10, -8, 1], radius: 1}}, body: north, normal_stiffness: {per_length: 1e6}, friction: 0.4, relative_damping: 0.1}
  hull: {shape: {box: {centre: [0, 0, 0], size: [20, 40, 12]}}, body: south, normal_stiffness: {per_area: 1e7}, friction: 0.4}
statics: false
dynamics: {duration: 6, tolerance: 1e-11}
)";
  if (mass > 0)
    yaml += fmt::format(R"(line_types:
  hawser: {{outer_diameter: 0.1, mass_per_length: {}, EA: 2e6, bending: false, stiffness_damping: 0.02}}
lines:
  one:
    sections: [{{type: hawser, length: 12.5, elements: 5}}]
    end_a: {{body: north, at: [10, 15, 4]}}
    end_b: {{body: south, at: [-10, 5, 4]}}
  two:
    sections: [{{type: hawser, length: 12.5, elements: 5}}]
    end_a: {{body: north, at: [10, -15, 4]}}
    end_b: {{body: south, at: [-10, -7, 4]}}
contact: {{lines: [], between_lines: false}}
)",
                        mass);
  return yaml;
}

// Momentum is constant to round-off, also with lines between the hulls, angular momentum without lines, whose
// own error is of second order in the step. Mechanical energy never exceeds its initial value, and the energy
// balance with friction and damping closes within 0.3 % (gain) and 1 % (loss), the error of impacts at
// default steps.
TEST(BodyFrictionStatics, HullsThatRollAgainstEachOther) {
  for (const double mass : {0.0, 8.0}) {
    BodiesRun r(hulls(mass));
    r.start();
    const auto momenta = [&] {
      Kinematics k = r.sim.dynamics().committed_kinematics();
      k.mean = {};  // over a step the inertia of bodies is the change of their momenta
      Momentum m = momentum(r.sim.system(), k);
      MPI_Allreduce(MPI_IN_PLACE, m.linear.data(), 3, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
      MPI_Allreduce(MPI_IN_PLACE, m.angular.data(), 3, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
      return m;
    };
    const Momentum m0 = momenta();
    EXPECT_GT(m0.linear.norm(), 1e5);
    EXPECT_GT(m0.angular.norm(), 1e6);
    const double e0 = total(r.energy());
    const double a0 = r.audit();
    const double p = 1e6 * 0.4;
    double most = 0, made = 0, lost = 0, strain = 0, error = 0, turning = 0;
    r.move(6, [&](const StepInfo&) {
      const double e = total(r.energy());
      const double a = r.audit();
      most = std::max(most, e - e0);
      made = std::max(made, a - a0);
      lost = std::max(lost, a0 - a);
      strain = std::max(strain, r.energy().strain);
      const Momentum m = momenta();
      error = std::max(error, (m.linear - m0.linear).norm());
      turning = std::max(turning, (m.angular - m0.angular).norm());
    });
    const Energy end = r.energy();
    printf(
        "lines of %.1f kg/m: strain %.3g of %.3g J, friction %.3g, damping %.3g; made %.2g, lost %.2g, "
        "momentum %.1e, angular %.1e\n",
        mass, strain, e0, end.friction, end.damping, made / e0, lost / e0, error / p,
        turning / m0.angular.norm());
    EXPECT_LT(error, 1e-9 * p);
    EXPECT_LT(turning, (mass > 0 ? 1e-5 : 1e-9) * m0.angular.norm());
    EXPECT_LE(most, 1e-9 * e0);
    EXPECT_LT(made, 3e-3 * e0);
    EXPECT_LT(lost, 0.01 * e0);
    EXPECT_GT(strain, 0.05 * e0);
    EXPECT_GT(end.friction, 0.1 * e0);
  }
}

// A crate lands at 1 m/s on a deck that heaves, rolls and pitches. It slides, sticks, and then moves with the
// deck.
TEST(BodyFrictionStatics, CrateOnAMovingDeck) {
  BodiesRun r(R"(hawser: 1
bodies:
  deck:
    position: [0, 0, 0]
    motion: {harmonic: {amplitude: [0, 0, 1], rotation_amplitude_deg: [5, 3, 0], period: 8, rotation_phase_deg: [30, 70, 0]}}
  crate:
    position: [0, 1, 1.2]
    floating: {mass: 600, inertia: [20, 52, 68], weight: true, velocity: [1, 0.5, 0.8]}
volumes:
  deck: {body: deck, shape: {box: {centre: [0, 0, 0], size: [20, 12, 2]}}, normal_stiffness: {per_length: 1e8}, friction: 0.4}
  crate:
    shape: {box: {centre: [0, 0, 0], size: [1, 0.6, 0.2]}}
    body: crate
    normal_stiffness: {per_point: 1e7}
    relative_damping: 0.3
    friction: 0.4
statics: false
dynamics: {duration: 10}
)");
  r.start();
  const double a0 = r.audit();
  const auto on_deck = [&] {
    const Kinematics k = r.sim.dynamics().committed_kinematics();
    const RigidPose deck = *r.sim.body_pose(0, k);
    return deck.to_body(r.poses()[1].position);
  };
  double error = 0, size = 0;
  Vec3 at_5 = Vec3::Zero();
  r.move(5, [&](const StepInfo&) {
    error = std::max(error, std::abs(r.audit() - a0));
    size = std::max(size, total(r.energy()));
  });
  at_5 = on_deck();
  double after = 0;
  r.move(10, [&](const StepInfo&) {
    error = std::max(error, std::abs(r.audit() - a0));
    after = std::max(after, (on_deck() - at_5).norm());
  });
  const Energy e = r.energy();
  printf("friction %.1f J, damping %.1f J, error %.2g J; slid to (%.4f, %.4f), later moved %.1e m\n",
         e.friction, e.damping, error, at_5.x(), at_5.y(), after);
  EXPECT_GT(at_5.x(), 0.05);
  EXPECT_LT(after, 1e-3);
  EXPECT_LT(error, 0.01 * (e.friction + e.damping));
}

}  // namespace
}  // namespace hawser::test::body_friction_statics
