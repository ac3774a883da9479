#include "hawser/kernels/cable.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

struct Local {
  Vec3 t, dv;  // unit chord, v2 - v1
  double l, strain, rate, tension;
  StiffnessTable::Value axial;  // of the strain
  bool damped;                  // the damping acts: taut, and tension not cut off at zero
};

inline Local local(const CableSection& s, const CableEnds& e) {
  Local o;
  const Vec3 d = e.x2 - e.x1;
  o.l = d.norm();
  o.t = d / o.l;
  o.strain = (o.l - s.length) / s.length - s.free_strain;
  o.dv = e.v2 - e.v1;
  o.rate = o.t.dot(o.dv) / s.length;
  o.tension = 0;
  o.damped = false;
  if (o.strain > 0) {
    o.axial = s.axial(o.strain);
    const double full = o.axial.force + s.EA * s.beta * o.rate;
    o.damped = s.beta > 0 && full > 0;
    o.tension = std::max(full, 0.0);
  }
  return o;
}

}  // namespace

Vec3 cable_pull(const CableSection& s, const CableEnds& e) {
  const Local o = local(s, e);
  return o.tension * o.t;
}

void cable_pull(const CableSection& s, const CableEnds& e, bool convex, CablePull& out) {
  const Local o = local(s, e);
  out.force = o.tension * o.t;
  const bool taut = o.tension > 0;
  const double ea = s.EA / s.length, across = o.tension / o.l;
  const double stiff = taut ? o.axial.slope / s.length : ea;
  Vec3 along = (taut || convex ? stiff : 0.0) * o.t - across * o.t;
  // rate = t.dv/L turns with the chord: its gradient is (dv - t (t.dv))/(l L)
  if (o.damped) along += (ea * s.beta / o.l) * (o.dv - o.t * o.t.dot(o.dv));
  const Vec3 damped = (o.damped ? ea * s.beta : 0.0) * o.t;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      out.k(i, j) = o.t[i] * along[j] + (i == j ? across : 0.0);
      out.c(i, j) = o.t[i] * damped[j];
    }
}

CableStress cable_stress(const CableSection& s, const CableEnds& e) {
  const Local o = local(s, e);
  CableStress out;
  out.tension = o.tension;
  if (o.strain > 0) {
    out.strain_energy = s.length * o.axial.energy;
    out.dissipation = (o.tension - o.axial.force) * o.rate * s.length;
  }
  return out;
}

}  // namespace hawser
