// Common parts of force, tangent and stresses of a beam element: the co-rotational frame, strains and
// stresses in it, and nonlinear bending.
#pragma once

#include <cmath>

#include "hawser/kernels/beam.hpp"
#include "hawser/math/gauss_points.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser::beam_local {

using namespace wide;  // rows, matrices and hat() of the local element

// tan(t/4)/t and its (d/dt)/t: the skew part of the mean spin.
inline void mean_spin_coefficient(double t2, double& tau, double& tau1) {
  if (t2 < 0.05) {
    tau = 0.25 + t2 * (1.0 / 192 + t2 * (1.0 / 7680 + t2 * (17.0 / 5160960)));
    tau1 = 1.0 / 96 + t2 * (1.0 / 1920 + t2 * (17.0 / 860160 + t2 * 6.674e-7));
  } else {
    const double t = std::sqrt(t2);
    const double c = std::cos(t / 4);
    const double g = std::tan(t / 4);
    tau = g / t;
    tau1 = (0.25 / (c * c) - tau) / t2;
  }
}

// Quantities of the local element that force and tangent share, in element axes.
struct Local {
  Mat Rm;          // element axes to space
  Row y, psi;      // chord in the mean frame, relative rotation
  Mat Psi1, Psi2;  // psi' = Psi1 theta1' + Psi2 theta2'
  Mat B;           // mean spin = B' theta1' + B theta2'
  double tau, tau1, eta, eta1;
  double l, a2, a3;     // |y|, 2 y2/(l + y1), 2 y3/(l + y1)
  Row d, da2, da3;      // gradients of l, a2, a3
  Row g;                // gradient of l + y1
  Row eps_y, eps_psi;   // gradients of the strain
  double strain;        // from the stress-free state
  double k2, k3;        // 12 EI/(L (1 + P))
  Row D;                // (GJ, EI2, EI3)/L
  double N, m2, m3;     // stresses: axial, antisymmetric bending about 2 (with a3), about 3 (with a2)
  double EA;            // tangent of the axial stress, N
  double axial_energy;  // J/m
  Row mpsi;             // symmetric bending and torsion moments, D (psi - psi0 + beta psi')
  Row n, m;             // dW/dy, dW/dpsi
  Row yd, psid;         // rates, with damping only
  double epsd;
};

// Angular velocities of the ends in element axes.
inline void spins(const BeamReference& r, const BeamEnds& e, Row& w1, Row& w2) {
  w1 = load(e.w1);
  w2 = load(e.w2);
  if (r.axes) {
    w1 = load(Vec3(r.axes->transpose() * e.w1));
    w2 = load(Vec3(r.axes->transpose() * e.w2));
  }
}

// Nonlinear bending: gradient and Hessian of its energy in (psi2, psi3, a3, a2).
struct Bending {
  double energy = 0, g[4] = {}, H[4][4] = {};
};

// Moment M(kappa) in the direction of the curvature; stiffness M' along it and M/kappa across it.
inline BendingMoment by_table(const BeamSection& s, double c2, double c3) {
  const double c = std::hypot(c2, c3);
  const double linear = s.EI2 - s.moment->initial();
  const ResponseCurve::Value v = s.moment->at(c);
  const double secant = c > 0 ? v.force / c : s.moment->initial();
  // Secant across the curvature, tangent along it.
  const double curvature_factor = c > 0 ? (v.slope - secant) / (c * c) : 0;
  BendingMoment o;
  o.energy = v.energy + 0.5 * linear * c * c;
  o.m[0] = (secant + linear) * c2;
  o.m[1] = (secant + linear) * c3;
  o.K[0][0] = secant + linear + curvature_factor * c2 * c2;
  o.K[1][1] = secant + linear + curvature_factor * c3 * c3;
  o.K[0][1] = o.K[1][0] = curvature_factor * c2 * c3;
  return o;
}

// Plastic moment plus the excess of EI2 = EI3 over the initial slope, which is elastic: a bend stiffener.
inline BendingMoment with_memory(const BeamSection& s, double c2, double c3, const double* set) {
  BendingMoment o = s.plastic->at(c2, c3, set);
  const double linear = s.EI2 - s.plastic->initial();
  o.energy += 0.5 * linear * (c2 * c2 + c3 * c3);
  o.m[0] += linear * c2;
  o.m[1] += linear * c3;
  o.K[0][0] += linear;
  o.K[1][1] += linear;
  return o;
}

// The curvature is linear along the element, (psi2 + 6 xi a3, psi3 - 6 xi a2)/L with xi from -1 to 1: that of
// the cubic deflection, which for a constant EI has the energy of the linear law.
inline constexpr auto& kGauss = GaussPoints<kBendingPlaces>::centred;
inline constexpr auto& kWeight = GaussPoints<kBendingPlaces>::weight;

struct Curvature {
  double about2, about3;  // 1/m
};
inline Curvature curvature_at(const BeamSection& s, const BeamReference& r, const Local& o, double xi) {
  const double z = 6 * xi;
  const double iL = 1 / s.length;
  return {iL * (o.psi[1] - r.psi[1] + z * o.a3), iL * (o.psi[2] - r.psi[2] - z * o.a2)};
}

inline Bending bending_by_law(const BeamSection& s, const BeamReference& r, const Local& o) {
  Bending b;
  const double iL = 1 / s.length;
  for (int k = 0; k < kBendingPlaces; ++k) {
    const double z = 6 * kGauss[k];
    const Curvature c = curvature_at(s, r, o, kGauss[k]);
    const double* set = r.set ? r.set + static_cast<size_t>(k) * s.plastic->memory() : nullptr;
    const BendingMoment m =
        s.plastic ? with_memory(s, c.about2, c.about3, set) : by_table(s, c.about2, c.about3);
    b.energy += kWeight[k] * s.length * m.energy;
    // Curvature component and factor of each variable.
    const int component[4] = {0, 1, 0, 1};
    const double factor[4] = {1, 1, z, -z};
    for (int i = 0; i < 4; ++i) {
      b.g[i] += kWeight[k] * factor[i] * m.m[component[i]];
      for (int j = 0; j < 4; ++j)
        b.H[i][j] += kWeight[k] * iL * factor[i] * factor[j] * m.K[component[i]][component[j]];
    }
  }
  return b;
}

inline void axial_by_table(const BeamSection& s, Local& o) {
  const double factor = s.EA / s.tension->initial();
  const ResponseCurve::Value v = s.tension->at(o.strain);
  o.N = factor * v.force;
  o.EA = factor * v.slope;
  o.axial_energy = factor * v.energy;
}

// The strain and the potential W(y, psi) in the mean frame R (docs/theory/beam.md#potential), with l = |y|
// and a_k = 2 y_k/(l + y1):
//   eps = l/L - 1 + (a2² + a3²)/10 + (psi2² + psi3²)/24 - eps0,
//   W   = 1/2 EA L eps² + 1/2 k3 a2² + 1/2 k2 a3² + 1/2 (psi - psi0)' D (psi - psi0),
//   k_i = 12 EI_i/(L (1 + P_i)),  P_i = 12 EI_i/(GA L²),  D = diag(GJ, EI2, EI3)/L,
//   n   = N L eps_y + k3 a2 da2 + k2 a3 da3,  m = N L eps_psi + D (psi - psi0),  N = EA eps;
// with damping each strain e stands for e + beta e'.
inline void kinematics(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool rates,
                       Local& o) {
  Quat q1 = e.q1;
  Quat q2 = e.q2;
  if (r.axes) {
    const Quat a(*r.axes);
    q1 = q1 * a;
    q2 = q2 * a;
  }
  const Quat relative = q1.conjugate() * q2;
  const Vec3 psi = log_so3(relative);
  o.psi = load(psi);
  o.Rm = wide::rotation(q1 * half_rotation(relative));
  o.y = left(load(Vec3(e.x2 - e.x1)), o.Rm);
  const double t2 = psi.squaredNorm();
  mean_spin_coefficient(t2, o.tau, o.tau1);
  inverse_jacobian_coefficient(t2, o.eta, o.eta1);
  const Mat h = hat(o.psi);
  // hat² = psi psi' - t2 I
  const Mat even = identity(1 - o.eta * t2) + o.eta * outer(o.psi, o.psi);
  o.Psi2 = even + 0.5 * h;
  o.Psi1 = 0.5 * h - even;
  o.B = identity(0.5) + (0.5 * o.tau) * h;

  o.l = std::sqrt(dot(o.y, o.y));
  const double il = 1 / o.l;
  const double iL = 1 / s.length;
  o.d = il * o.y;
  o.g = o.d + unit(0);
  const double ic = 1 / (o.l + o.y[0]);
  o.a2 = 2 * ic * o.y[1];
  o.a3 = 2 * ic * o.y[2];
  o.da2 = ic * (2 * unit(1) - o.a2 * o.g);
  o.da3 = ic * (2 * unit(2) - o.a3 * o.g);
  o.eps_y = iL * o.d + 0.2 * (o.a2 * o.da2 + o.a3 * o.da3);
  o.eps_psi = Row{0, psi.y() / 12, psi.z() / 12, 0};
  o.strain = (o.l - s.length) * iL + 0.1 * (o.a2 * o.a2 + o.a3 * o.a3) +
             (psi.y() * psi.y() + psi.z() * psi.z()) / 24 - r.strain;
  const double shear = s.GA > 0 ? 12 * iL * iL / s.GA : 0;
  o.k2 = 12 * iL * s.EI2 / (1 + shear * s.EI2);
  o.k3 = 12 * iL * s.EI3 / (1 + shear * s.EI3);
  o.D = iL * Row{s.GJ, s.EI2, s.EI3, 0};

  o.N = s.EA * o.strain;
  o.EA = s.EA;
  if (s.tension) axial_by_table(s, o);
  o.m2 = o.k2 * o.a3;
  o.m3 = o.k3 * o.a2;
  o.mpsi = o.D * (o.psi - load(r.psi));
  if (s.bends_by_law()) {
    const Bending b = bending_by_law(s, r, o);
    o.m2 = b.g[2];
    o.m3 = b.g[3];
    o.mpsi = Row{o.mpsi[0], b.g[0], b.g[1], 0};
  }
  if (rates) {
    Row w1, w2;
    spins(r, e, w1, w2);
    o.psid = times(o.Psi1, w1) + times(o.Psi2, w2);
    o.yd = left(load(Vec3(e.v2 - e.v1)), o.Rm) + cross(o.y, left(w1, o.B) + times(o.B, w2));
    o.epsd = dot(o.eps_y, o.yd) + dot(o.eps_psi, o.psid);
    o.N += s.beta * s.EA * o.epsd;
    o.m2 += s.beta * o.k2 * dot(o.da3, o.yd);
    o.m3 += s.beta * o.k3 * dot(o.da2, o.yd);
    o.mpsi += s.beta * (o.D * o.psid);
  }
  o.n = (o.N * s.length) * o.eps_y + o.m3 * o.da2 + o.m2 * o.da3;
  o.m = (o.N * s.length) * o.eps_psi + o.mpsi;
}

// P = 12 EI/(GA L²).
inline double flexibility(const BeamSection& s, double EI) {
  return s.GA > 0 ? 12 * EI / (s.GA * s.length * s.length) : 0;
}

}  // namespace hawser::beam_local
