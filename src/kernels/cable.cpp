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

struct Local {
  Vec3 t, dv;  // unit chord, v2 - v1
  double l, strain, rate, tension;
  ResponseCurve::Value axial;  // response at the strain
  bool damped;  // the element is taut, and the damper is within its limit, the spring's tension
  // d tension/d strain over that of the spring: 2 where the damper is at its upper limit, the spring's
  // tension.
  double slope_factor;
};

inline Local local(const CableSection& s, const CableEnds& e) {
  Local o;
  const Vec3 d = e.x2 - e.x1;
  o.l = d.norm();
  o.t = o.l > 0 ? Vec3(d / o.l) : Vec3(0, 0, 0);
  o.strain = (o.l - s.length) / s.length - s.free_strain;
  o.dv = e.v2 - e.v1;
  o.rate = (o.t.dot(o.dv) - s.length_rate * o.l / s.length) / s.length;
  o.tension = 0;
  o.damped = false;
  o.slope_factor = 1;
  if (o.strain > 0) {
    o.axial = s.axial(o.strain);
    const double damper = s.EA * s.beta * o.rate;
    o.damped = s.beta > 0 && std::abs(damper) < o.axial.force;
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
// fraction s of the path on which the element is taut. For a linear cable the mean is 1/2 EA (p0 + p1) s
// with p = max(strain, 0).
struct Elastic {
  double mean, slope, taut_fraction;  // s: of the strain's change, over which the element is taut
};

Elastic elastic_mean(const CableSection& s, double e0, double e1) {
  const double p0 = std::max(e0, 0.0), p1 = std::max(e1, 0.0), grown = p1 - p0, strain_change = e1 - e0;
  if (p0 == 0 && p1 == 0) return {0, 0, 0};
  const double taut_fraction = e0 > 0 && e1 > 0 ? 1 : grown / strain_change;
  double taut, end;  // mean over the taut part; tension at the end
  if (!s.tension) {
    taut = 0.5 * s.EA * (p0 + p1);
    end = s.EA * p1;
    if (taut_fraction == 1) return {taut, 0.5 * s.EA, 1};
  } else {
    const ResponseCurve::Value b = s.axial(p1);
    end = b.force;
    constexpr double kNear =
        1e-4;  // below it the difference of energies loses digits; Simpson's rule does not
    if (std::abs(grown) <= kNear * std::max(p0, p1)) {
      const ResponseCurve::Value a = s.axial(p0), m = s.axial(0.5 * (p0 + p1));
      return {(a.force + 4 * m.force + b.force) / 6, (2 * m.slope + b.slope) / 6, taut_fraction};
    }
    taut = (b.energy - s.axial(p0).energy) / grown;
  }
  const double mean = taut_fraction * taut;
  return {mean, (end - mean) / strain_change, taut_fraction};
}

// S = T* n, n = (d0 + d1)/(l0 + l1) (docs/theory/time-integration.md#cables), with
//   T* = (V1 - V0)/(l1 - l0) + EA beta*/h (p1 - p0)/L + chi EA/L (dp - s min(1, h/h') dp') >= 0.
// Symbols: d0, l0 start.chord, start.length; d1 chord; l1 o.l; L s.length; p = max(l - L, 0) elongation
// (l - L less the free strain, if there is one); V
// strain energy; beta* `beta`; h step.h; h' the length of the step before; chi step.filter; s
// e.taut_fraction; dp/L = (p1 - p0)/L o.strain_increment; min(1, h/h') dp'/L start.strain_increment, which
// the caller has scaled.
Mean mean_of(const CableSection& s, const CableStart& start, const CableStep& step, const Vec3& chord) {
  Mean o;
  o.l = chord.norm();
  o.t = o.l > 0 ? Vec3(chord / o.l) : Vec3(0, 0, 0);
  o.n = start.length + o.l > 0 ? Vec3((start.chord + chord) / (start.length + o.l)) : Vec3(0, 0, 0);
  const double strain = (o.l - s.length) / s.length - s.free_strain;
  const Elastic e = elastic_mean(s, start.strain, strain);
  o.strain_increment = std::max(strain, 0.0) - std::max(start.strain, 0.0);
  o.elastic = e.mean;
  const double beta = std::min(start.beta, kRigid * step.h);
  o.damper = s.EA * beta / step.h * o.strain_increment;
  o.filter = step.filter * s.EA * (o.strain_increment - e.taut_fraction * start.strain_increment);
  o.tension = o.elastic + o.damper + o.filter;
  if (o.tension <= 0) {
    o.tension = o.damper = o.filter = 0;
    return o;
  }
  const double strain_change = strain - start.strain;
  o.slope = e.slope;
  if (strain > 0) o.slope += s.EA * (beta / step.h + step.filter);
  // If only a part of the change is taut, that fraction depends on the strain at the end:
  // ds/de1 = ([e1 > 0] - s)/(e1 - e0).
  if (e.taut_fraction < 1 && strain_change != 0)
    o.slope -= step.filter * s.EA * start.strain_increment * ((strain > 0 ? 1 : 0) - e.taut_fraction) /
               strain_change;
  return o;
}

}  // namespace

CableStart cable_start(const CableSection& s, const Vec3& x1, const Vec3& x2, double strain_increment,
                       double previous_h) {
  CableStart o;
  o.chord = x2 - x1;
  o.length = o.chord.norm();
  o.strain = (o.length - s.length) / s.length - s.free_strain;
  o.strain_increment = strain_increment;
  o.unstretched_length = s.length;
  if (o.strain > 0) {
    // EA beta |e'| <= T(e)
    const double damper = previous_h > 0 ? s.EA * s.beta * std::abs(strain_increment) / previous_h : 0,
                 spring = s.axial(o.strain).force;
    o.beta = damper > spring ? s.beta * spring / damper : s.beta;
  }
  return o;
}

Vec3 cable_mean_force(const CableSection& s, const CableStart& start, const CableStep& step, const Vec3& x1,
                      const Vec3& x2) {
  const Mean m = mean_of(s, start, step, x2 - x1);
  return m.tension * m.n;
}

void cable_mean_force(const CableSection& s, const CableStart& start, const CableStep& step, const Vec3& x1,
                      const Vec3& x2, CableForce& out) {
  const Mean m = mean_of(s, start, step, x2 - x1);
  const double across = m.tension > 0 ? m.tension / (start.length + m.l) : 0;
  out.force = m.tension * m.n;
  // d strain = (dl - (l/L) dL) / L
  const Vec3 along = (m.slope / s.length * (1 - m.l / s.length * s.length_by_chord)) * m.t;
  out.k = m.n * along.transpose() - (across * m.n) * m.t.transpose();
  out.k.diagonal().array() += across;
  out.c.setZero();
}

CableLoss cable_loss(const CableSection& s, const CableStart& start, const CableStep& step, const Vec3& x1,
                     const Vec3& x2) {
  const Mean m = mean_of(s, start, step, x2 - x1);
  // If the unstretched length changes, the change of the chord has two parts: the mean of the unstretched
  // lengths at start and end times the change of strain, on which the material's forces do work, and the mean
  // ratio of stretched to unstretched length times the paid-out length (docs/theory/feeders.md#energy).
  // `elongation` is the first part.
  const double fed_length = s.length - start.unstretched_length,
               length_ratio =
                   1 + s.free_strain + 0.5 * (start.strain + (m.l - s.length) / s.length - s.free_strain);
  const double elongation = m.l - start.length - length_ratio * fed_length;
  const double energy = fed_length == 0
                            ? 0
                            : 0.5 * (s.axial(std::max(start.strain, 0.0)).energy +
                                     s.axial(std::max(m.l / s.length - 1 - s.free_strain, 0.0)).energy);
  const double fed = (energy - m.tension * length_ratio) * fed_length;
  // The element would push, so its tension is 0. The work of the spring is then counted as loss of the
  // damper, or of the filter if there is no damper.
  if (m.tension == 0) {
    const double spent = -m.elastic * elongation;
    return start.beta > 0 ? CableLoss{spent, 0, 0, fed} : CableLoss{0, spent, 0, fed};
  }
  return {m.damper * elongation, m.filter * elongation,
          m.l > s.length * (1 + s.free_strain) ? m.strain_increment : 0.0, fed};
}

Vec3 cable_force(const CableSection& s, const CableEnds& e) {
  const Local o = local(s, e);
  return o.tension * o.t;
}

void cable_force(const CableSection& s, const CableEnds& e, double slack, CableForce& out) {
  const Local o = local(s, e);
  out.force = o.tension * o.t;
  const bool taut = o.tension > 0;
  const double ea = s.EA / s.length, across = taut ? o.tension / o.l : 0;
  const double stiff = taut ? o.slope_factor * o.axial.slope / s.length : slack * ea;
  Vec3 along = (stiff - across) * o.t;
  // rate = (t.dv - L' l/L)/L. t turns with the chord, so the gradient is (dv - t (t.dv))/(l L) - L' t/L².
  if (o.damped)
    along +=
        (ea * s.beta / o.l) * (o.dv - o.t * o.t.dot(o.dv)) - (ea * s.beta * s.length_rate / s.length) * o.t;
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
