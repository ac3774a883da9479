// Force of a spring and a damper between two points: along the straight line that joins them.
#pragma once

#include <memory>

#include "hawser/kernels/monotone_cubic.hpp"
#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// Tension over elongation and over speed, each linear or by a table.
struct LinkLaw {
  double rest_length = 0;                       // m
  double stiffness = 0;                         // N/m
  double damping = 0;                           // N s/m
  std::shared_ptr<const MonotoneCubic> spring;  // N over m of elongation; null: linear
  std::shared_ptr<const ResponseCurve> damper;  // N over m/s; null: linear
  // It goes slack: no force where spring and damper together would push. A table's first force is then not
  // negative.
  bool tension_only = false;

  // Largest slope of the spring, N/m.
  double most_stiffness() const { return spring ? spring->largest_slope() : stiffness; }
};

// At a length [m] and the rate [m/s] at which it grows.
struct LinkTension {
  double tension = 0;                  // N, negative: it pushes
  double by_length = 0, by_speed = 0;  // N/m, N s/m: its derivatives
  double energy = 0;                   // J, of the spring, from its rest length (or from slack) on
  double dissipated = 0;               // W, never negative
};
// Of a link that can go slack T = max(0, S(e) + D(v)) with the spring S going on straight below its first
// row: continuous, and what is not stored, (T - max(0, S)) v, is never negative.
LinkTension link_tension(const LinkLaw& law, double length, double speed);

// The same between points with the difference d [m] of their places and w [m/s] of their velocities (that of
// the second minus that of the first).
struct LinkForce {
  LinkTension along;
  double length = 0, speed = 0;  // m, m/s
  Vec3 pull = Vec3::Zero();      // N, the residual of the second point; minus that of the first
  Mat3 by_place = Mat3::Zero(), by_rate = Mat3::Zero();  // its derivatives by d and w
};
// convex: derivatives for the way to an equilibrium, without what makes them indefinite or, where the link is
// slack, nothing. Where the points meet there is no direction, and no force.
LinkForce link_force(const LinkLaw& law, const Vec3& d, const Vec3& w, bool convex = false);

}  // namespace hawser
