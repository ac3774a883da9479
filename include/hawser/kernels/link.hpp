// Force of a spring and a damper between two points, along the straight line between them. See
// docs/theory/links.md.
#pragma once

#include <memory>

#include "hawser/kernels/monotone_cubic.hpp"
#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// Tension by elongation and by speed, each linear or from a table.
struct LinkLaw {
  double rest_length = 0;                       // m
  double stiffness = 0;                         // N/m
  double damping = 0;                           // N s/m
  std::shared_ptr<const MonotoneCubic> spring;  // N over m of elongation; null: linear
  std::shared_ptr<const ResponseCurve> damper;  // N over m/s; null: linear
  // The link goes slack: no force where spring and damper together would push. A table's first force is then
  // >= 0.
  bool tension_only = false;

  // Largest slope of the spring, N/m.
  double max_stiffness() const { return spring ? spring->largest_slope() : stiffness; }
};

// Tension at a length [m] and its rate [m/s].
struct LinkTension {
  double tension = 0;                  // N, negative: compression
  double by_length = 0, by_speed = 0;  // N/m, N s/m: its derivatives
  double energy = 0;                   // J, of the spring from its rest length (or from slack)
  double dissipated = 0;               // W, never negative
};
// For a link that can go slack T = max(0, S(e) + D(v)), where the spring S is continued linearly below its
// first row: T is continuous, and the dissipation (T - max(0, S)) v is never negative.
LinkTension link_tension(const LinkLaw& law, double length, double speed);

// Force between points with the differences (second minus first) d [m] of positions and w [m/s] of
// velocities.
struct LinkForce {
  LinkTension along;
  double length = 0, speed = 0;  // m, m/s
  Vec3 pull = Vec3::Zero();      // N, residual of the second point; minus that of the first
  Mat3 by_place = Mat3::Zero(), by_rate = Mat3::Zero();  // derivatives by d and w
};
// convex: derivatives for the search of an equilibrium, without indefinite parts, and zero for a slack link.
// If the points coincide there is no direction and no force.
LinkForce link_force(const LinkLaw& law, const Vec3& d, const Vec3& w, bool convex = false);

}  // namespace hawser
