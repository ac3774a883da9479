// Scalar normal contact law: force and potential of a gap, once continuously differentiable, with damping
// that increases with the stiffness and never pulls.
#pragma once

#include <algorithm>
#include <cmath>

#include "hawser/kernels/contact_force_table.hpp"

namespace hawser {

// Elastic force at the gap g (negative: penetration): N = k s + k₃ s³ with the smoothed depth s: 0 for g >=
// δ, (δ - g)²/(4 δ) on (-δ, δ), -g below; δ is the smoothing. δ = k₃ = 0: a linear spring, with damping
// Kelvin-Voigt without tension. Units are those of a point; along lines all are per metre. Symbols as in
// docs/theory/contact.md.
struct NormalLaw {
  double stiffness = 0;                      // N/m, k; with a table its largest slope
  double smoothing = 0;                      // m, δ, half width of the ramp; 0 with a table
  double damping = 0;                        // N s/m, c at full stiffness
  const ContactForceTable* table = nullptr;  // replaces ramp and straight line; not owned
  double table_factor = 1;                   // factor on the table's forces
  double cubic = 0;                          // N/m³, k₃; 0 with a table
  bool operator==(const NormalLaw&) const = default;
};

struct NormalForce {
  double force = 0;      // N, elastic plus damping, >= 0
  double elastic = 0;    // N
  double potential = 0;  // J, of the elastic force
  double by_gap = 0;     // N/m, derivative of `force`
  double by_rate = 0;    // N s/m
};

// Force at the gap g [m] and rate [m/s]. The damping force is -c e rate, e = -ds/dg, for a table slope / k.
inline NormalForce normal_force(const NormalLaw& law, double g, double rate) {
  const double k = law.stiffness;
  const double delta = law.smoothing;
  NormalForce r;
  if (g >= delta) return r;
  double fade = 1, fade_by_gap = 0, slope = 0;
  if (law.table) {
    const ContactForceTable::Value v = law.table->at(-g);
    r.elastic = law.table_factor * v.force;
    r.potential = law.table_factor * v.potential;
    fade = law.table_factor * v.slope / k;
    fade_by_gap = -law.table_factor * v.bend / k;
    slope = law.table_factor * v.slope;
  } else {
    // φ = k (integral of s) + k₃ (integral of s³): k a³/(12 δ) + k₃ a⁷/(448 δ³) on the ramp, a = δ - g.
    double depth, area, cubes;  // s; integrals of s and s³ from g to δ
    if (g > -delta) {
      const double a = delta - g;
      depth = a * a / (4 * delta);
      fade = a / (2 * delta);
      fade_by_gap = -1 / (2 * delta);
      area = a * a * a / (12 * delta);
      cubes = depth * depth * depth * a / 7;
    } else {
      depth = -g;
      area = g * g / 2 + delta * delta / 6;
      cubes = g * g * g * g / 4 + delta * delta * delta * delta / 28;
    }
    r.elastic = k * depth + law.cubic * depth * depth * depth;
    r.potential = k * area + law.cubic * cubes;
    slope = fade * (k + 3 * law.cubic * depth * depth);
  }
  r.force = r.elastic - law.damping * fade * rate;
  if (r.force <= 0) {
    r.force = 0;  // damping would pull
    return r;
  }
  r.by_gap = -slope - law.damping * fade_by_gap * rate;
  r.by_rate = -law.damping * fade;
  return r;
}

// Largest tangent stiffness [N/m] reached by an impact of the mass m [kg] at the speed u [m/s] on a contact
// of depth p [m]: k + 3 k₃ max(p, q)², where the spring has absorbed the kinetic energy at the depth q,
// k q²/2 + k₃ q⁴/4 = m u²/2.
inline double stiffness_of_impact(const NormalLaw& law, double p, double m, double u) {
  const double k = law.stiffness;
  const double k3 = law.cubic;
  if (!(k3 > 0)) return k;
  // q² = (-k + sqrt(k² + 2 k₃ m u²))/k₃
  const double by_speed = 2 * m * u * u / (k + std::sqrt(k * k + 2 * k3 * m * u * u));
  return k + 3 * k3 * std::max(p > 0 ? p * p : 0.0, by_speed);
}

// Damping c = 2 ζ sqrt(k m) of a contact spring of stiffness k [N/m] with the mass m [kg].
inline double contact_damping(double zeta, double stiffness, double mass) {
  return 2 * zeta * std::sqrt(stiffness * mass);
}

}  // namespace hawser
