// A pipe that falls onto a point support under its middle, for the methods of contact at the nodes.
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
  c.contact.between_lines.enabled = false;  // so that the line is cut between ranks
  c.dynamics.enabled = true;
  c.dynamics.step = step;
  return c;
}

inline std::shared_ptr<const Surface> point_support() {
  return std::make_shared<CylinderSurface>(Vec3(0, -1, -0.25), Vec3(0, 1, -0.25), 0.25);
}

}  // namespace hawser::test
