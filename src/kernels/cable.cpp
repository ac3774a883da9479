// The cable element: tension and tangent at one instant (`cable_force`: statics, output), and the
// energy-conserving mean force over a time step (`cable_mean_force`) with damping, with numerical damping
// of axial vibrations that are too fast for the step, and with changes between taut and slack.
#include "hawser/kernels/cable.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

// Upper limit of beta/h. With a larger beta the damper would reach the spring's tension when the strain
// changes by less than 1 % of its value in a step, and the element would be effectively rigid.
constexpr double kRigid = 100;

// State at one instant.
struct CableState {
  Vec3 t, dv;  // unit chord, v2 - v1
  double l, strain, rate, tension;
  ResponseCurve::Value axial;  // response at the strain
  bool damped;  // the element is taut, and the damper is within its limit, the spring's tension
  // d tension/d strain over that of the spring: 2 where the damper is at its upper limit, the spring's
  // tension.
  double slope_factor;
};

inline CableState cable_state(const CableSection& section, const CableEnds& e) {
  CableState o;
  const Vec3 d = e.x2 - e.x1;
  o.l = d.norm();
  o.t = o.l > 0 ? Vec3(d / o.l) : Vec3(0, 0, 0);
  o.strain = section.strain(o.l);
  o.dv = e.v2 - e.v1;
  o.rate = (o.t.dot(o.dv) - section.length_rate * o.l / section.length) / section.length;
  o.tension = 0;
  o.damped = false;
  o.slope_factor = 1;
  if (o.strain > 0) {
    o.axial = section.axial(o.strain);
    const double damper = section.EA * section.beta * o.rate;
    o.damped = section.beta > 0 && std::abs(damper) < o.axial.force;
    if (damper >= o.axial.force) o.slope_factor = 2;
    o.tension = o.axial.force + std::clamp(damper, -o.axial.force, o.axial.force);
  }
  return o;
}

// The mean tension of a step and its parts.
struct Mean {
  Vec3 n;                         // mean chord over the mean length; shorter than 1 if the element turned
  Vec3 t;                         // unit chord at the end
  double l = 0;                   // m, chord at the end
  double tension = 0, slope = 0;  // N, never negative; its derivative by the strain at the end
  double elastic = 0, damper = 0, filter = 0;  // N, parts of the tension; the last two are 0 if it is 0
  double strain_increment = 0;                 // change of the taut part of the strain in the step
};

// Mean of the elastic tension between two strains, (V1 - V0)/(l1 - l0), its derivative by the second, and the
// fraction s of the path on which the element is taut. With the taut strains e = max(strain, 0) = p/L
//   s = (e1 - e0)/(strain1 - strain0),
// and the mean for a linear cable is 1/2 EA (e0 + e1) s.
struct Elastic {
  double mean, slope;    // N
  double taut_fraction;  // s
};

Elastic elastic_mean(const CableSection& section, double strain0, double strain1) {
  const double e0 = std::max(strain0, 0.0);
  const double e1 = std::max(strain1, 0.0);
  const double taut_change = e1 - e0;
  const double strain_change = strain1 - strain0;
  if (e0 == 0 && e1 == 0) return {0, 0, 0};
  const double taut_fraction = strain0 > 0 && strain1 > 0 ? 1 : taut_change / strain_change;
  double mean_while_taut, at_end;  // N, the second at the end
  if (!section.tension) {
    mean_while_taut = 0.5 * section.EA * (e0 + e1);
    at_end = section.EA * e1;
    if (taut_fraction == 1) return {mean_while_taut, 0.5 * section.EA, 1};
  } else {
    const ResponseCurve::Value response1 = section.axial(e1);
    at_end = response1.force;
    constexpr double kNear =
        1e-4;  // below it the difference of energies loses digits; Simpson's rule does not
    if (std::abs(taut_change) <= kNear * std::max(e0, e1)) {
      const ResponseCurve::Value response0 = section.axial(e0);
      const ResponseCurve::Value middle = section.axial(0.5 * (e0 + e1));
      return {(response0.force + 4 * middle.force + response1.force) / 6,
              (2 * middle.slope + response1.slope) / 6, taut_fraction};
    }
    mean_while_taut = (response1.energy - section.axial(e0).energy) / taut_change;
  }
  const double mean = taut_fraction * mean_while_taut;
  return {mean, (at_end - mean) / strain_change, taut_fraction};
}

// S = T* n, n = (d0 + d1)/(l0 + l1) (docs/theory/time-integration.md#cables), with
//   T* = (V1 - V0)/(l1 - l0) + EA beta*/h (p1 - p0)/L + chi EA/L (dp - s min(1, h/h') dp') >= 0.
// Symbols: d0, l0 start.chord, start.length; d1 chord; l1 o.l; L section.length; p = max(l - L, 0) elongation
// (l - L less the free strain, if there is one); V strain energy; beta* = min(start.beta, kRigid h) `beta`; h
// step.h; h' the length of the step before; chi step.filter; s e.taut_fraction; dp/L = (p1 - p0)/L
// o.strain_increment; min(1, h/h') dp'/L start.strain_increment, which the caller has scaled.
Mean mean_of(const CableSection& section, const CableStart& start, const CableStep& step, const Vec3& chord) {
  Mean o;
  o.l = chord.norm();
  o.t = o.l > 0 ? Vec3(chord / o.l) : Vec3(0, 0, 0);
  o.n = start.length + o.l > 0 ? Vec3((start.chord + chord) / (start.length + o.l)) : Vec3(0, 0, 0);
  const double strain = section.strain(o.l);
  const Elastic e = elastic_mean(section, start.strain, strain);
  o.strain_increment = std::max(strain, 0.0) - std::max(start.strain, 0.0);
  o.elastic = e.mean;
  const double beta = std::min(start.beta, kRigid * step.h);
  o.damper = section.EA * beta / step.h * o.strain_increment;
  o.filter = step.filter * section.EA * (o.strain_increment - e.taut_fraction * start.strain_increment);
  o.tension = o.elastic + o.damper + o.filter;
  if (o.tension <= 0) {
    o.tension = o.damper = o.filter = 0;
    return o;
  }
  const double strain_change = strain - start.strain;
  o.slope = e.slope;
  if (strain > 0) o.slope += section.EA * (beta / step.h + step.filter);
  // If only a part of the change is taut, that fraction depends on the strain at the end:
  // ds/dstrain1 = ([strain1 > 0] - s)/(strain1 - strain0).
  if (e.taut_fraction < 1 && strain_change != 0)
    o.slope -= step.filter * section.EA * start.strain_increment * ((strain > 0 ? 1 : 0) - e.taut_fraction) /
               strain_change;
  return o;
}

}  // namespace

CableStart cable_start(const CableSection& section, const Vec3& x1, const Vec3& x2, double strain_increment,
                       double previous_h) {
  CableStart o;
  o.chord = x2 - x1;
  o.length = o.chord.norm();
  o.strain = section.strain(o.length);
  o.strain_increment = strain_increment;
  o.unstretched_length = section.length;
  if (o.strain > 0) {
    // EA beta |e'| <= T(e)
    const double damper =
        previous_h > 0 ? section.EA * section.beta * std::abs(strain_increment) / previous_h : 0;
    const double spring = section.axial(o.strain).force;
    o.beta = damper > spring ? section.beta * spring / damper : section.beta;
  }
  return o;
}

Vec3 cable_mean_force(const CableSection& section, const CableStart& start, const CableStep& step,
                      const Vec3& x1, const Vec3& x2) {
  const Mean m = mean_of(section, start, step, x2 - x1);
  return m.tension * m.n;
}

void cable_mean_force(const CableSection& section, const CableStart& start, const CableStep& step,
                      const Vec3& x1, const Vec3& x2, CableForce& out) {
  const Mean m = mean_of(section, start, step, x2 - x1);
  const double across = m.tension > 0 ? m.tension / (start.length + m.l) : 0;
  out.force = m.tension * m.n;
  // d strain = (dl - (l/L) dL) / L
  const Vec3 along = (m.slope / section.length * (1 - m.l / section.length * section.length_by_chord)) * m.t;
  out.k = m.n * along.transpose() - (across * m.n) * m.t.transpose();
  out.k.diagonal().array() += across;
  out.c.setZero();
}

CableStepResult cable_step_result(const CableSection& section, const CableStart& start, const CableStep& step,
                                  const Vec3& x1, const Vec3& x2) {
  const Mean m = mean_of(section, start, step, x2 - x1);
  // If the unstretched length changes, the change of the chord has two parts: the mean of the unstretched
  // lengths at start and end times the change of strain, on which the material's forces do work, and the mean
  // ratio of stretched to unstretched length times the paid-out length (docs/theory/feeders.md#energy).
  // `elongation` is the first part.
  const double fed_length = section.length - start.unstretched_length;
  const double strain = section.strain(m.l);
  const double length_ratio = 1 + section.free_strain + 0.5 * (start.strain + strain);
  const double elongation = m.l - start.length - length_ratio * fed_length;
  const double energy = fed_length == 0 ? 0
                                        : 0.5 * (section.axial(std::max(start.strain, 0.0)).energy +
                                                 section.axial(std::max(strain, 0.0)).energy);
  const double fed = (energy - m.tension * length_ratio) * fed_length;
  // The element would push, so its tension is 0. The work of the spring is then counted as loss of the
  // damper, or of the filter if there is no damper.
  if (m.tension == 0) {
    const double spent = -m.elastic * elongation;
    return start.beta > 0 ? CableStepResult{spent, 0, 0, fed} : CableStepResult{0, spent, 0, fed};
  }
  return {m.damper * elongation, m.filter * elongation, strain > 0 ? m.strain_increment : 0.0, fed};
}

// F = T t,  T = V'(strain) + clamp(EA beta rate, -V', V') if strain > 0, else 0
//   strain = (l - L)/L - free strain,  rate = (t . dv - L' l/L)/L,  V' = EA strain for a linear cable
Vec3 cable_force(const CableSection& section, const CableEnds& e) {
  const CableState o = cable_state(section, e);
  return o.tension * o.t;
}

// dF/dd of a taut element = t (dT/dd)' + T/l (I - t t'),  dT/dd = (dT/dstrain) t/L + EA beta drate/dd
//   d chord, l its length, t = d/l, dv = v2 - v1; the terms in beta only while the damper is within its limit
//   rate = (t . dv - L' l/L)/L,  drate/dd = (dv - t (t . dv))/(l L) - L' t/L²
// dF/dd of a slack element = slack EA/L t t', in place of 0, which would be singular.
void cable_force(const CableSection& section, const CableEnds& e, double slack, CableForce& out) {
  const CableState o = cable_state(section, e);
  out.force = o.tension * o.t;
  const bool taut = o.tension > 0;
  const double EA_over_L = section.EA / section.length;
  const double across = taut ? o.tension / o.l : 0;
  const double stiff = taut ? o.slope_factor * o.axial.slope / section.length : slack * EA_over_L;
  Vec3 along = (stiff - across) * o.t;
  if (o.damped)
    along += (EA_over_L * section.beta / o.l) * (o.dv - o.t * o.t.dot(o.dv)) -
             (EA_over_L * section.beta * section.length_rate / section.length) * o.t;
  const Vec3 damped = (o.damped ? EA_over_L * section.beta : 0.0) * o.t;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      out.k(i, j) = o.t[i] * along[j] + (i == j ? across : 0.0);
      out.c(i, j) = o.t[i] * damped[j];
    }
}

CableStress cable_stress(const CableSection& section, const CableEnds& e) {
  const CableState o = cable_state(section, e);
  CableStress out;
  out.tension = o.tension;
  if (o.strain > 0) {
    out.strain_energy = section.length * o.axial.energy;
    out.dissipation = (o.tension - o.axial.force) * o.rate * section.length;
  }
  return out;
}

}  // namespace hawser
