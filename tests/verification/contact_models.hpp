// Cases for the ways of keeping a node out of a volume: a pipe that falls on a point support with its middle,
// and a cable that hangs over a drum.
#pragma once

#include "verification/contact_rig.hpp"

namespace hawser::test {

inline constexpr double kPipeRadius = 0.16195, kSpeed = 1.5, kGravity = 9.81,
                        kMass = 180;       // m, m/s, m/s², kg/m
inline constexpr double kStiffness = 1e7;  // N/m

inline model::Case pipe(model::ContactMethod method, double step) {
  model::LineType type = beam_type(2.570e9, 3.114e7, 2.4e7, kMass);
  type.outer_diameter = type.contact_diameter = 2 * kPipeRadius;
  type.rotary_inertia = Vec3(4.4, 2.2, 2.2);
  model::Case c = one_line(type, 60, 60, {}, {});
  c.environment.gravity = kGravity;
  c.lines[0].start = model::Start::points;
  const double z = kPipeRadius + kSpeed * kSpeed / (2 * kGravity);
  c.lines[0].points = {{-30, 0, z}, {30, 0, z}};
  model::Volume support;
  support.name = "support";
  support.basis = model::StiffnessBasis::per_point;
  support.normal_stiffness = kStiffness;
  c.volumes.push_back(support);
  c.contact.method = method;
  c.dynamics.enabled = true;
  c.dynamics.step = step;
  return c;
}

inline std::shared_ptr<const Surface> point_support() {
  return std::make_shared<CylinderSurface>(Vec3(0, -1, -0.25), Vec3(0, 1, -0.25), 0.25);
}

inline model::Case hung_cable(double stiffness, bool augmented, bool exact) {
  model::LineType type = cable_type(5e7, 204);
  type.outer_diameter = type.contact_diameter = 0.1;
  model::Case c = one_line(type, 17, 60, anchor({-6, 0, -1}), anchor({6, 0, -1}));
  c.environment.gravity = kGravity;
  model::Line& l = c.lines[0];
  l.start = model::Start::points;
  const double r = 3.65;
  l.points = {{-6, 0, -1}};
  for (int i = 0; i <= 40; ++i) {
    const double a = M_PI * (1 - i / 40.0);
    l.points.push_back({r * std::cos(a), 0, r * std::sin(a)});
  }
  l.points.push_back({6, 0, -1});
  model::Volume drum;
  drum.name = "drum";
  drum.basis = model::StiffnessBasis::per_point;
  drum.normal_stiffness = stiffness;
  c.volumes.push_back(drum);
  c.contact.method = model::ContactMethod::nodes;
  c.contact.augmented = augmented;
  c.contact.allowed_penetration = 1e-7;
  c.statics.exact_contact = exact;
  return c;
}

}  // namespace hawser::test
