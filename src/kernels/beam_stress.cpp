// Beam element: section moments and energy, force on a feeder, plastic history, stress-free reference.
#include <cmath>

#include "beam_local.hpp"
#include "hawser/math/clones.hpp"

namespace hawser {

using namespace beam_local;

HAWSER_CLONES BeamStress beam_stress(const BeamSection& s, const BeamReference& r, const BeamEnds& e) {
  Local o;
  kinematics(s, r, e, s.beta > 0, o);
  BeamStress out;
  out.tension = o.N;
  out.shear = std::hypot(o.m2, o.m3) / s.length;
  const Row p = o.psi - load(r.psi);
  const double axial = s.tension ? 2 * o.axial_energy : s.EA * o.strain * o.strain;
  out.strain_energy = 0.5 * s.length * axial;
  if (s.bends_by_law())
    out.strain_energy += 0.5 * o.D[0] * p[0] * p[0] + bending_by_law(s, r, o).energy;
  else
    out.strain_energy += 0.5 * (o.k3 * o.a2 * o.a2 + o.k2 * o.a3 * o.a3 + dot(p, o.D * p));
  if (s.beta > 0) {
    const double r2 = dot(o.da2, o.yd);
    const double r3 = dot(o.da3, o.yd);
    out.dissipation = s.beta * (s.EA * s.length * o.epsd * o.epsd + o.k3 * r2 * r2 + o.k2 * r3 * r3 +
                                dot(o.psid, o.D * o.psid));
  }
  const auto kinematic = [&](double xi) {
    const Curvature c = curvature_at(s, r, o, xi);
    return Vec3(p[0] / s.length, c.about2, c.about3);
  };
  if (s.moment) {
    const auto at = [&](double xi, Vec3& moment, Vec3& curvature) {
      curvature = kinematic(xi);
      const BendingMoment m = by_table(s, curvature.y(), curvature.z());
      moment = Vec3(o.mpsi[0], m.m[0], m.m[1]);
    };
    at(-1, out.moment1, out.curvature1);
    at(1, out.moment2, out.curvature2);
    return out;
  }
  // The chord turns by +y3/l about axis 2 and by -y2/l about axis 3 relative to the mean frame. For plastic
  // bending, whose history is inside the element, these are the linear moments that do the same work.
  const Vec3 bend(0, 0.5 * o.m2, -0.5 * o.m3);
  const Vec3 mean = vec(o.mpsi);
  out.moment1 = mean - bend;
  out.moment2 = mean + bend;
  if (s.plastic) {
    out.curvature1 = kinematic(-1);
    out.curvature2 = kinematic(1);
    if (!r.set) return out;
    const auto residual = [&](size_t place) {
      const auto [c2, c3] = s.plastic->residual(r.set + place * s.plastic->memory());
      return std::hypot(c2, c3);
    };
    out.residual1 = residual(0);
    out.residual2 = residual(kBendingPlaces - 1);
    return out;
  }
  const Vec3 EI(s.GJ, s.EI2, s.EI3);
  for (int i = 0; i < 3; ++i) {
    out.curvature1[i] = EI[i] > 0 ? out.moment1[i] / EI[i] : 0;
    out.curvature2[i] = EI[i] > 0 ? out.moment2[i] / EI[i] : 0;
  }
  return out;
}

// f = -dU/dL of the strain energy U = EA L e²/2 + (k3 a2² + k2 a3² + p·D p)/2 with e = l/L - 1, where D
// varies as 1/L, k as 1/(L (1 + P)) and the flexibility in shear P as 1/L²:
//   f = N l/L - EA e²/2 + [k3 a2² (1 - P3)/(1 + P3) + k2 a3² (1 - P2)/(1 + P2) + p·D p]/(2 L)
//   df/dl = EA l/L²
BeamFeed beam_feed(const BeamSection& s, const BeamReference& r, const BeamEnds& e) {
  Local o;
  kinematics(s, r, e, false, o);
  const double iL = 1 / s.length;
  const double axial = s.tension ? o.axial_energy : 0.5 * s.EA * o.strain * o.strain;
  BeamFeed out;
  out.force = o.N * o.l * iL - axial;
  out.by_chord = o.EA * o.l * iL * iL;
  out.slope = -out.by_chord * o.l * iL;
  const Row p = o.psi - load(r.psi);
  if (s.plastic) {
    const double torsion = o.D[0] * p[0] * p[0];
    out.force += 0.5 * torsion * iL;
    out.slope -= torsion * iL * iL;
    return out;
  }
  const auto bend = [&](double EI, double twice) {  // twice the energy of antisymmetric bending
    const double P = flexibility(s, EI);
    out.force += 0.5 * twice * iL * (1 - P) / (1 + P);
    out.slope -= twice * iL * iL * (1 - 3 * P) / ((1 + P) * (1 + P));
  };
  bend(s.EI3, o.k3 * o.a2 * o.a2);
  bend(s.EI2, o.k2 * o.a3 * o.a3);
  const double twice = dot(p, o.D * p);
  out.force += 0.5 * twice * iL;
  out.slope -= twice * iL * iL;
  return out;
}

double beam_bow(const BeamReference& r, const BeamEnds& e) {
  BeamSection s;
  s.length = 1;
  Local o;
  kinematics(s, r, e, false, o);
  return o.strain + r.strain - (o.l - 1);
}

double beam_bend(const BeamSection& s, const BeamReference& r, const BeamEnds& e, double* set) {
  Local o;
  kinematics(s, r, e, false, o);
  double dissipated = 0;
  for (int k = 0; k < kBendingPlaces; ++k) {
    const Curvature c = curvature_at(s, r, o, kGauss[k]);
    dissipated += kWeight[k] * s.length *
                  s.plastic->bend(c.about2, c.about3, set + static_cast<size_t>(k) * s.plastic->memory());
  }
  return dissipated;
}

BeamReference beam_reference(const BeamSection& s, const BeamEnds& e) {
  BeamReference r;
  Local o;
  kinematics(s, r, e, false, o);
  r.psi = vec(o.psi);
  r.strain = o.strain;
  return r;
}

}  // namespace hawser
