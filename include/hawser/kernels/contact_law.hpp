// Normal contact law, scalar: force and potential of a gap, once continuously differentiable, with damping
// that fades in with the stiffness and never pulls.
#pragma once

#include <cmath>

#include "hawser/kernels/contact_force_table.hpp"

namespace hawser {

// Elastic force of the gap g (negative: penetration): 0 for g >= d, k (d - g)²/(4 d) on (-d, d), -k g below,
// d the smoothing. d = 0: a linear spring; with damping, Kelvin-Voigt without tension.
struct NormalLaw {
  double stiffness = 0;                      // N/m, k; of a table the largest slope
  double smoothing = 0;                      // m, d, half width of the ramp; 0 with a table
  double damping = 0;                        // N s/m, c at full stiffness
  const ContactForceTable* table = nullptr;  // instead of ramp and straight line; not owned
  double table_factor = 1;                   // of its forces
  bool operator==(const NormalLaw&) const = default;
};

struct NormalForce {
  double force = 0;      // N, elastic and damping together, >= 0
  double elastic = 0;    // N
  double potential = 0;  // J, of the elastic part
  double by_gap = 0;     // N/m, derivative of force
  double by_rate = 0;    // N s/m
};

// Gap g [m], its rate [m/s]. The damping force is -c e rate, where e = stiffness at g / k.
inline NormalForce normal_force(const NormalLaw& law, double g, double rate) {
  const double k = law.stiffness, d = law.smoothing;
  NormalForce r;
  if (g >= d) return r;
  double fade = 1, fade_by_gap = 0;
  if (law.table) {
    const ContactForceTable::Value v = law.table->at(-g);
    r.elastic = law.table_factor * v.force;
    r.potential = law.table_factor * v.potential;
    fade = law.table_factor * v.slope / k;
    fade_by_gap = -law.table_factor * v.bend / k;
  } else if (g > -d) {
    const double a = d - g;
    fade = a / (2 * d);
    fade_by_gap = -1 / (2 * d);
    r.elastic = k * a * a / (4 * d);
    r.potential = k * a * a * a / (12 * d);
  } else {
    r.elastic = -k * g;
    r.potential = k * (g * g / 2 + d * d / 6);
  }
  r.force = r.elastic - law.damping * fade * rate;
  if (r.force <= 0) {
    r.force = 0;  // damping would pull
    return r;
  }
  r.by_gap = -k * fade - law.damping * fade_by_gap * rate;
  r.by_rate = -law.damping * fade;
  return r;
}

// c = 2 zeta sqrt(k m): a contact spring of stiffness k [N/m] under the mass m [kg].
inline double contact_damping(double zeta, double stiffness, double mass) {
  return 2 * zeta * std::sqrt(stiffness * mass);
}

}  // namespace hawser
