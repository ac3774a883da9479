// Automatic contact stiffness of lines on volumes and on lines, against hand calculations of the penetration
// under weight and tension.
#include "hawser/terms/automatic_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::contact_stiffness_test {
namespace {

using Bend = advice::StiffnessReason::Bend;

TEST(ContactStiffness, Automatic) {
  // A hose of 250 m, 273.4 kg/m, 0.85 m: the force of its hanging tension on a bend of 1 m radius has a
  // penetration of 0.5 % of the hose radius.
  const double weight = 273.4 * 9.80665;
  StiffnessDemand d{0.425, weight, 250 * weight, 9.505e8, 0, 0, 0};
  const AutomaticStiffness a = automatic_contact_stiffness(d);
  EXPECT_NEAR(a.per_length * 0.005 * 0.425, weight * 251, 1e-6);
  EXPECT_TRUE(a.reason.has_weight);
  // On the drum of a reel, 1 cm allowed.
  model::Volume drum;
  drum.shape = CylinderShape{Vec3::Zero(), Vec3::UnitY(), 3.6};
  d.bend = bending_radius(drum, d.radius);
  d.allowed_penetration = 0.01;
  EXPECT_EQ(d.bend, 4.025);
  const AutomaticStiffness b = automatic_contact_stiffness(d);
  EXPECT_NEAR(b.per_length * 0.01, weight * (1 + 250 / 4.025), 1e-6);
  EXPECT_EQ(b.reason.bend, Bend::of_shape);
  EXPECT_TRUE(b.reason.penetration_given);
  EXPECT_EQ(b.reason.penetration, 0.01);
  drum.shape = PlaneShape{};
  EXPECT_EQ(bending_radius(drum, d.radius), 10);
  drum.shape = BoxShape{};
  EXPECT_EQ(bending_radius(drum, d.radius), 0);
  // A mass of 273.4 kg on 1e6 N/m.
  EXPECT_NEAR(contact_period(1e6, 273.4), 0.10389, 1e-5);
}

// A pipe of 4 m, 200 x 10 mm: its weight of 1.84 kN bends it to a radius of at least 2 sqrt(EI/T) = 111 m, on
// a mesh and on a drum. EA determines the tension only if the pipe has no weight.
TEST(ContactStiffness, OfAStiffPipe) {
  const double weight = 460;
  const double tension = 4 * weight;
  StiffnessDemand d{0.1, weight, tension, 1.256e9, 5.7e6, 0, 0};
  const double bend = 2 * std::sqrt(5.7e6 / tension);
  EXPECT_NEAR(bend, 111.3, 0.1);
  EXPECT_NEAR(automatic_contact_stiffness(d).per_length * 0.005 * 0.1, weight + tension / bend, 1e-6);
  EXPECT_EQ(automatic_contact_stiffness(d).reason.bend, Bend::over_edge);
  d.bend = 4;
  EXPECT_NEAR(automatic_contact_stiffness(d).per_length * 0.005 * 0.1, weight + tension / bend, 1e-6);
  d.weight = 0;
  d.line_weight = 0;
  EXPECT_NEAR(automatic_contact_stiffness(d).per_length * 0.005 * 0.1,
              1.256e5 / (2 * std::sqrt(5.7e6 / 1.256e5)), 1e-6);
}

// A contact of one diameter, 0.118 m, is as stiff as a rope of this length.
TEST(ContactStiffness, EndOn) {
  const double along = 1.53e7 / 0.118;
  EXPECT_NEAR(largest_stiffness_end_on(1.53e7, 0.059) * 0.118, along, 1e-9 * along);
}

// The weight of a line gives a penetration of 0.5 % of its radius; 1 % of its EA, bent to its radius, gives a
// penetration of a quarter of the radius.
TEST(ContactStiffness, OfLinesOnLines) {
  const double r = 0.05;
  const double s = 0.25 * r;
  EXPECT_NEAR(stiffness_by_weight(60, r) * 0.005 * r, 60 * 9.80665, 1e-9);
  EXPECT_NEAR(cubic_stiffness(250e6, r) * s * s * s, 2.5e6 / r, 1e-3);
}

}  // namespace
}  // namespace hawser::contact_stiffness_test
