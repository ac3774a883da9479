// Internal force and exact tangent of the beam element, with stiffness-proportional damping and a length that
// may follow a force.
#include "hawser/kernels/beam.hpp"

#include <algorithm>

#include "beam_local.hpp"
#include "hawser/math/clones.hpp"

namespace hawser {
namespace {

using namespace beam_local;

// f_x2 = -f_x1 = R n,  f_theta1 = B q + Psi1' m,  f_theta2 = B' q + Psi2' m,  q = n x y
// (docs/theory/beam.md#force).
inline void force(const Local& o, const BeamReference& r, Vec12& f) {
  const Row q = cross(o.n, o.y);
  const Row fd = times(o.Rm, o.n);
  Vec3 f1 = vec(times(o.B, q) + left(o.m, o.Psi1));
  Vec3 f2 = vec(left(q, o.B) + left(o.m, o.Psi2));
  if (r.axes) {
    f1 = *r.axes * f1;
    f2 = *r.axes * f2;
  }
  for (int i = 0; i < 3; ++i) {
    f[i] = -fd[i];
    f[3 + i] = f1[i];
    f[6 + i] = fd[i];
    f[9 + i] = f2[i];
  }
}

// Hessian of a_k = 2 y_k/(l + y1), k = 2, 3.
inline Mat slope_hessian(const Local& o, double a, Row da) {
  const double inverse = 1 / (o.l + o.y[0]), c = a * inverse / o.l;
  return outer(c * o.d, o.d) - identity(c) - outer(inverse * da, o.g) - outer(inverse * o.g, da);
}

// Converts blocks of a 9x9 in (d, theta1, theta2), d in the mean frame, to the 12x12 in space axes.
struct Blocks {
  Mat dd, d1, d2, one_d, one_one, one_two, two_d, two_one, two_two;
};

inline void expand(const Local& o, const BeamReference& r, const Blocks& b, Mat12& to) {
  const Mat Rt = transpose(o.Rm);
  const Mat dd = o.Rm * b.dd * Rt;
  Mat d1 = o.Rm * b.d1, d2 = o.Rm * b.d2, a = b.one_d * Rt, c = b.two_d * Rt;
  Mat m11 = b.one_one, m12 = b.one_two, m21 = b.two_one, m22 = b.two_two;
  if (r.axes) {
    const Mat A = load(*r.axes), At = transpose(A);
    d1 = d1 * At;
    d2 = d2 * At;
    a = A * a;
    c = A * c;
    m11 = A * m11 * At;
    m12 = A * m12 * At;
    m21 = A * m21 * At;
    m22 = A * m22 * At;
  }
  put(to, 0, 0, dd);
  put(to, 0, 2, -dd);
  put(to, 2, 0, -dd);
  put(to, 2, 2, dd);
  put(to, 0, 1, -d1);
  put(to, 2, 1, d1);
  put(to, 0, 3, -d2);
  put(to, 2, 3, d2);
  put(to, 1, 0, -a);
  put(to, 1, 2, a);
  put(to, 3, 0, -c);
  put(to, 3, 2, c);
  put(to, 1, 1, m11);
  put(to, 1, 3, m12);
  put(to, 3, 1, m21);
  put(to, 3, 3, m22);
}

// Derivative of (I -+ hat/2 + eta hat²) m with respect to psi; `sign` is that of the hat term.
inline Mat inverse_jacobian_derivative(const Local& o, Row m, double sign) {
  const Row pm = cross(o.psi, m);
  // -(hat(psi x m) + hat(psi) hat(m)), with hat(a)hat(b) = b a' - (a.b) I
  return hat((-0.5 * sign) * m - o.eta * pm) + outer(o.eta1 * cross(o.psi, pm) - o.eta * m, o.psi) +
         identity(o.eta * dot(o.psi, m));
}

// Derivative of B q with respect to psi.
inline Mat mean_spin_derivative(const Local& o, Row q) {
  return hat((-0.5 * o.tau) * q) + outer((0.5 * o.tau1) * cross(o.psi, q), o.psi);
}

// Damping metric in (y, psi), and changes of the strain rates with the configuration.
struct Damping {
  Mat Gyy, Gyp, Gpp, Yd, Y1, Y2, R1, R2;
};

// Adds the rate terms at fixed strain rates to the Hessian, and computes those of changing strain rates.
void damping(const BeamSection& s, const BeamReference& r, const BeamEnds& e, const Local& o,
             const Mat& eps_yy, const Mat& h2, const Mat& h3, const Mat& Z1, const Mat& Z2, Mat& Hyy,
             Mat& Hyp, Mat& Hpy, Mat& Hpp, Damping& g) {
  const double b = s.beta, EAL = s.EA * s.length;
  g.Gyy = b * (EAL * outer(o.eps_y, o.eps_y) + o.k3 * outer(o.da2, o.da2) + o.k2 * outer(o.da3, o.da3));
  g.Gyp = (b * EAL) * outer(o.eps_y, o.eps_psi);
  g.Gpp = (b * EAL) * outer(o.eps_psi, o.eps_psi);
  for (int i = 0; i < 3; ++i) g.Gpp.r[i] += b * o.D[i] * unit(i);
  const Row ey = times(eps_yy, o.yd);
  const Row ep = Row{0, o.psid[1] / 12, o.psid[2] / 12, 0};
  Hyy += b * (EAL * outer(o.eps_y, ey) + o.k3 * outer(o.da2, times(h2, o.yd)) +
              o.k2 * outer(o.da3, times(h3, o.yd)));
  Hyp += (b * EAL) * outer(o.eps_y, ep);
  Hpy += (b * EAL) * outer(o.eps_psi, ey);
  Hpp += (b * EAL) * outer(o.eps_psi, ep);

  Row w1, w2;
  spins(r, e, w1, w2);
  const Row wm = left(w1, o.B) + times(o.B, w2);
  const Row vd = left(load(Vec3(e.v2 - e.v1)), o.Rm);
  // y' = vd + y x wm: varies by vd x dm + dy x wm + y x dwm, dwm = d(B)(w2 - w1)
  const Mat W = hat_times(o.y, mean_spin_derivative(o, w2 - w1));
  g.Yd = hat(-wm);
  g.Y1 = hat_times(vd, transpose(o.B)) - hat_times(wm, Z1) + W * o.Psi1;
  g.Y2 = hat_times(vd, o.B) - hat_times(wm, Z2) + W * o.Psi2;
  const Mat R = inverse_jacobian_derivative(o, w2, 1) - inverse_jacobian_derivative(o, w1, -1);
  g.R1 = R * o.Psi1;
  g.R2 = R * o.Psi2;
}

// Derivatives by the unstretched length of the gradients (n, m) of the energy, at fixed chord and rotations.
struct ByLength {
  Row n, m;
};

ByLength by_length(const BeamSection& s, const Local& o) {
  const double iL = 1 / s.length;
  // Derivative of 12 EI/(L (1 + P)) divided by it.
  const auto bend = [&](double EI) {
    const double P = flexibility(s, EI);
    return -iL * (1 - P) / (1 + P);
  };
  const double tension = o.N - o.EA * o.l * iL;  // d(N L)/dL
  if (s.plastic)                                 // plastic bending does not act on the feeder: beam_feed
    return {tension * o.eps_y - (o.N * iL) * o.d, tension * o.eps_psi - iL * Row{o.mpsi[0], 0, 0, 0}};
  return {tension * o.eps_y - (o.N * iL) * o.d + (bend(s.EI3) * o.m3) * o.da2 + (bend(s.EI2) * o.m2) * o.da3,
          tension * o.eps_psi - iL * o.mpsi};
}

// Adds plastic bending, which does not act on the feeder: curvatures are proportional to 1/L.
ByLength with_bends(const BeamSection& s, const BeamReference& r, const Local& o, ByLength by) {
  const Bending b = bending_by_law(s, r, o);
  const double q[4] = {o.psi[1] - r.psi[1], o.psi[2] - r.psi[2], o.a3, o.a2};
  double g[4] = {};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) g[i] -= b.H[i][j] * q[j] / s.length;
  by.n += g[2] * o.da3 + g[3] * o.da2;
  by.m += Row{0, g[0], g[1], 0};
  return by;
}

}  // namespace

HAWSER_CLONES void beam_force(const BeamSection& s, const BeamReference& r, const BeamEnds& e, Vec12& f) {
  Local o;
  kinematics(s, r, e, s.beta > 0, o);
  force(o, r, f);
}

HAWSER_CLONES void beam_tangent(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool convex,
                                Vec12& f, Mat12& K, Mat12* C) {
  Local o;
  const bool damped = s.beta > 0;
  kinematics(s, r, e, damped, o);
  force(o, r, f);

  const double EAL = o.EA * s.length;
  const double NL = (convex ? std::max(o.N, 0.0) : o.N) * s.length;
  const Mat h2 = slope_hessian(o, o.a2, o.da2), h3 = slope_hessian(o, o.a3, o.da3);
  const double c = 1 / (o.l * s.length);
  const Mat eps_yy = outer(0.2 * o.da2, o.da2) + outer(0.2 * o.da3, o.da3) + (0.2 * o.a2) * h2 +
                     (0.2 * o.a3) * h3 + identity(c) - outer(c * o.d, o.d);

  // Hessian of W
  Mat Hyy = outer(EAL * o.eps_y, o.eps_y) + NL * eps_yy + o.m3 * h2 + o.m2 * h3;
  Mat Hyp = outer(EAL * o.eps_y, o.eps_psi);
  Mat Hpp = outer(EAL * o.eps_psi, o.eps_psi);
  Row diagonal = o.D + Row{0, NL / 12, NL / 12, 0};
  if (s.bends_by_law()) {
    const Bending b = bending_by_law(s, r, o);
    const Row across[2] = {o.da3, o.da2};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Hyy += outer(b.H[2 + i][2 + j] * across[i], across[j]);
        Hyp += outer(b.H[2 + i][j] * across[i], unit(1 + j));
        Hpp.r[1 + i] += b.H[i][j] * unit(1 + j);
      }
    diagonal = Row{o.D[0], NL / 12, NL / 12, 0};
  } else {
    Hyy += outer(o.k3 * o.da2, o.da2) + outer(o.k2 * o.da3, o.da3);
  }
  for (int i = 0; i < 3; ++i) Hpp.r[i] += diagonal[i] * unit(i);
  Mat Hpy = transpose(Hyp);
  if (s.length_by_force > 0) {
    const ByLength with_bending = by_length(s, o),
                   all = s.plastic ? with_bends(s, r, o, with_bending) : with_bending;
    const Row n = s.length_by_force * all.n, m = s.length_by_force * all.m;
    Hyy += outer(-n, with_bending.n);
    Hyp += outer(-n, with_bending.m);
    Hpy += outer(-m, with_bending.n);
    Hpp += outer(-m, with_bending.m);
  }

  const Row q = cross(o.n, o.y);
  const Mat Bt = transpose(o.B);
  const Mat Z1 = hat_times(o.y, Bt), Z2 = hat_times(o.y, o.B);
  const Mat S = mean_spin_derivative(o, q);
  const Mat P1 = S - inverse_jacobian_derivative(o, o.m, 1);   // of B q + Psi1' m
  const Mat P2 = inverse_jacobian_derivative(o, o.m, -1) - S;  // of B' q + Psi2' m
  Damping g;
  if (damped) damping(s, r, e, o, eps_yy, h2, h3, Z1, Z2, Hyy, Hyp, Hpy, Hpp, g);

  // dn and dm (gradients of the potential) by d, theta1, theta2
  Mat nd = Hyy, n1 = Hyy * Z1 + Hyp * o.Psi1, n2 = Hyy * Z2 + Hyp * o.Psi2;
  Mat md = Hpy, m1 = Hpy * Z1 + Hpp * o.Psi1, m2 = Hpy * Z2 + Hpp * o.Psi2;
  if (damped) {
    nd += g.Gyy * g.Yd;
    n1 += g.Gyy * g.Y1 + g.Gyp * g.R1;
    n2 += g.Gyy * g.Y2 + g.Gyp * g.R2;
    md += transposed_times(g.Gyp, g.Yd);
    m1 += transposed_times(g.Gyp, g.Y1) + g.Gpp * g.R1;
    m2 += transposed_times(g.Gyp, g.Y2) + g.Gpp * g.R2;
  }
  // dq = dn x y + n x dy
  const Mat qd = hat(o.n) - hat_times(o.y, nd);
  const Mat q1 = hat_times(o.n, Z1) - hat_times(o.y, n1), q2 = hat_times(o.n, Z2) - hat_times(o.y, n2);
  Blocks k;
  k.dd = nd;
  k.d1 = n1 - hat_times(o.n, Bt);
  k.d2 = n2 - hat_times(o.n, o.B);
  const Mat Psi1t = transpose(o.Psi1), Psi2t = transpose(o.Psi2);
  k.one_d = o.B * qd + Psi1t * md;
  k.one_one = o.B * q1 + Psi1t * m1 + P1 * o.Psi1;
  k.one_two = o.B * q2 + Psi1t * m2 + P1 * o.Psi2;
  k.two_d = Bt * qd + Psi2t * md;
  k.two_one = Bt * q1 + Psi2t * m1 + P2 * o.Psi1;
  k.two_two = Bt * q2 + Psi2t * m2 + P2 * o.Psi2;
  expand(o, r, k, K);

  if (damped && C) {
    const Mat c1 = g.Gyy * Z1 + g.Gyp * o.Psi1, c2 = g.Gyy * Z2 + g.Gyp * o.Psi2;
    const Mat Gpy = transpose(g.Gyp);
    const Mat p1 = Gpy * Z1 + g.Gpp * o.Psi1, p2 = Gpy * Z2 + g.Gpp * o.Psi2;
    const Mat T1 = transpose(Z1), T2 = transpose(Z2);  // theta row: Z' dn + Psi' dm
    Blocks v;
    v.dd = g.Gyy;
    v.d1 = c1;
    v.d2 = c2;
    v.one_d = T1 * g.Gyy + Psi1t * Gpy;
    v.one_one = T1 * c1 + Psi1t * p1;
    v.one_two = T1 * c2 + Psi1t * p2;
    v.two_d = T2 * g.Gyy + Psi2t * Gpy;
    v.two_one = T2 * c1 + Psi2t * p1;
    v.two_two = T2 * c2 + Psi2t * p2;
    expand(o, r, v, *C);
  }
}

}  // namespace hawser
