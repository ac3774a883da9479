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
  const double inverse = 1 / (o.l + o.y[0]);
  const double c = a * inverse / o.l;
  return outer(c * o.d, o.d) - identity(c) - outer(inverse * da, o.g) - outer(inverse * o.g, da);
}

// Converts blocks of a 9x9 in (d, theta1, theta2), d in the mean frame, to the 12x12 in space axes.
struct Blocks {
  Mat dd, d1, d2, one_d, one_one, one_two, two_d, two_one, two_two;
};

inline void expand(const Local& o, const BeamReference& r, const Blocks& b, Mat12& to) {
  const Mat Rt = transpose(o.Rm);
  const Mat dd = o.Rm * b.dd * Rt;
  Mat d1 = o.Rm * b.d1;
  Mat d2 = o.Rm * b.d2;
  Mat a = b.one_d * Rt;
  Mat c = b.two_d * Rt;
  Mat m11 = b.one_one;
  Mat m12 = b.one_two;
  Mat m21 = b.two_one;
  Mat m22 = b.two_two;
  if (r.axes) {
    const Mat A = load(*r.axes);
    const Mat At = transpose(A);
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

// How increments enter: dy = d + Z1 theta1 + Z2 theta2 with Z1 = hat(y) B', Z2 = hat(y) B, and
// dpsi = Psi1 theta1 + Psi2 theta2.
struct Increments {
  Mat Bt, Z1, Z2, Psi1t, Psi2t;
  explicit Increments(const Local& o)
      : Bt(transpose(o.B)),
        Z1(hat_times(o.y, Bt)),
        Z2(hat_times(o.y, o.B)),
        Psi1t(transpose(o.Psi1)),
        Psi2t(transpose(o.Psi2)) {}
};

// Second derivatives by y of a2, a3 and the strain.
struct ByChord {
  Mat a2, a3, eps;
};

inline ByChord second_by_chord(const BeamSection& s, const Local& o) {
  const Mat h2 = slope_hessian(o, o.a2, o.da2);
  const Mat h3 = slope_hessian(o, o.a3, o.da3);
  const double c = 1 / (o.l * s.length);
  return {h2, h3,
          outer(0.2 * o.da2, o.da2) + outer(0.2 * o.da3, o.da3) + (0.2 * o.a2) * h2 + (0.2 * o.a3) * h3 +
              identity(c) - outer(c * o.d, o.d)};
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

// Derivatives of (n, m), the gradient of W, by (y, psi). They are symmetric but for a length that follows a
// force, and for damping.
struct Hessian {
  Mat yy, yp, py, pp;
};

//   W_yy = EA L eps_y eps_y' + N L eps_yy + k3 (da2 da2' + a2 a2_yy) + k2 (da3 da3' + a3 a3_yy),
//   W_yp = EA L eps_y eps_psi',  W_pp = EA L eps_psi eps_psi' + N L diag(0, 1, 1)/12 + D,
// where bends are linear; by a law k and the bending parts of D are the Hessian of its energy.
inline Hessian hessian(const BeamSection& s, const BeamReference& r, const Local& o, const ByChord& second,
                       bool convex) {
  const double EAL = o.EA * s.length;
  const double NL = (convex ? std::max(o.N, 0.0) : o.N) * s.length;
  Hessian H;
  H.yy = outer(EAL * o.eps_y, o.eps_y) + NL * second.eps + o.m3 * second.a2 + o.m2 * second.a3;
  H.yp = outer(EAL * o.eps_y, o.eps_psi);
  H.pp = outer(EAL * o.eps_psi, o.eps_psi);
  Row diagonal = o.D + Row{0, NL / 12, NL / 12, 0};
  if (s.bends_by_law()) {
    const Bending b = bending_by_law(s, r, o);
    const Row across[2] = {o.da3, o.da2};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        H.yy += outer(b.H[2 + i][2 + j] * across[i], across[j]);
        H.yp += outer(b.H[2 + i][j] * across[i], unit(1 + j));
        H.pp.r[1 + i] += b.H[i][j] * unit(1 + j);
      }
    diagonal = Row{o.D[0], NL / 12, NL / 12, 0};
  } else {
    H.yy += outer(o.k3 * o.da2, o.da2) + outer(o.k2 * o.da3, o.da3);
  }
  for (int i = 0; i < 3; ++i) H.pp.r[i] += diagonal[i] * unit(i);
  H.py = transpose(H.yp);
  if (s.length_by_force > 0) {
    const ByLength with_bending = by_length(s, o);
    const ByLength all = s.plastic ? with_bends(s, r, o, with_bending) : with_bending;
    const Row n = s.length_by_force * all.n;
    const Row m = s.length_by_force * all.m;
    H.yy += outer(-n, with_bending.n);
    H.yp += outer(-n, with_bending.m);
    H.py += outer(-m, with_bending.n);
    H.pp += outer(-m, with_bending.m);
  }
  return H;
}

// Damping adds to n and m the metric G times the rates (y', psi'), with
//   G = beta (EA L eps' eps'' + k3 a2' a2'' + k2 a3' a3'' + D),  ' the gradient by (y, psi).
// Yd, Y1, Y2 and R1, R2: derivatives of y' and psi' by d, theta1, theta2.
struct Damping {
  Mat Gyy, Gyp, Gpp, Yd, Y1, Y2, R1, R2;
};

inline Damping damping(const BeamSection& s, const BeamReference& r, const BeamEnds& e, const Local& o,
                       const Increments& by) {
  Damping g;
  const double b = s.beta;
  const double EAL = s.EA * s.length;
  g.Gyy = b * (EAL * outer(o.eps_y, o.eps_y) + o.k3 * outer(o.da2, o.da2) + o.k2 * outer(o.da3, o.da3));
  g.Gyp = (b * EAL) * outer(o.eps_y, o.eps_psi);
  g.Gpp = (b * EAL) * outer(o.eps_psi, o.eps_psi);
  for (int i = 0; i < 3; ++i) g.Gpp.r[i] += b * o.D[i] * unit(i);

  Row w1, w2;
  spins(r, e, w1, w2);
  const Row wm = left(w1, o.B) + times(o.B, w2);
  const Row vd = left(load(Vec3(e.v2 - e.v1)), o.Rm);
  // y' = vd + y x wm: varies by vd x dm + dy x wm + y x dwm, dwm = d(B)(w2 - w1)
  const Mat W = hat_times(o.y, mean_spin_derivative(o, w2 - w1));
  g.Yd = hat(-wm);
  g.Y1 = hat_times(vd, transpose(o.B)) - hat_times(wm, by.Z1) + W * o.Psi1;
  g.Y2 = hat_times(vd, o.B) - hat_times(wm, by.Z2) + W * o.Psi2;
  const Mat R = inverse_jacobian_derivative(o, w2, 1) - inverse_jacobian_derivative(o, w1, -1);
  g.R1 = R * o.Psi1;
  g.R2 = R * o.Psi2;
  return g;
}

// Adds the derivative of G (y', psi') by (y, psi) at fixed (y', psi').
inline void add_metric_change(const BeamSection& s, const Local& o, const ByChord& second, Hessian& H) {
  const double b = s.beta;
  const double EAL = s.EA * s.length;
  const Row ey = times(second.eps, o.yd);
  const Row ep = Row{0, o.psid[1] / 12, o.psid[2] / 12, 0};
  H.yy += b * (EAL * outer(o.eps_y, ey) + o.k3 * outer(o.da2, times(second.a2, o.yd)) +
               o.k2 * outer(o.da3, times(second.a3, o.yd)));
  H.yp += (b * EAL) * outer(o.eps_y, ep);
  H.py += (b * EAL) * outer(o.eps_psi, ey);
  H.pp += (b * EAL) * outer(o.eps_psi, ep);
}

// Derivatives of the force in (d, theta1, theta2) (docs/theory/beam.md#tangent). g: null without damping.
inline Blocks stiffness_matrix(const Local& o, const Increments& by, const Hessian& H, const Damping* g) {
  const Row q = cross(o.n, o.y);
  const Mat S = mean_spin_derivative(o, q);
  const Mat P1 = S - inverse_jacobian_derivative(o, o.m, 1);   // of B q + Psi1' m by psi
  const Mat P2 = inverse_jacobian_derivative(o, o.m, -1) - S;  // of B' q + Psi2' m
  // dn and dm for each of d, theta1, theta2
  Mat nd = H.yy;
  Mat n1 = H.yy * by.Z1 + H.yp * o.Psi1;
  Mat n2 = H.yy * by.Z2 + H.yp * o.Psi2;
  Mat md = H.py;
  Mat m1 = H.py * by.Z1 + H.pp * o.Psi1;
  Mat m2 = H.py * by.Z2 + H.pp * o.Psi2;
  if (g) {
    nd += g->Gyy * g->Yd;
    n1 += g->Gyy * g->Y1 + g->Gyp * g->R1;
    n2 += g->Gyy * g->Y2 + g->Gyp * g->R2;
    md += transposed_times(g->Gyp, g->Yd);
    m1 += transposed_times(g->Gyp, g->Y1) + g->Gpp * g->R1;
    m2 += transposed_times(g->Gyp, g->Y2) + g->Gpp * g->R2;
  }
  // dq = dn x y + n x dy
  const Mat qd = hat(o.n) - hat_times(o.y, nd);
  const Mat q1 = hat_times(o.n, by.Z1) - hat_times(o.y, n1);
  const Mat q2 = hat_times(o.n, by.Z2) - hat_times(o.y, n2);
  Blocks k;
  k.dd = nd;
  k.d1 = n1 - hat_times(o.n, by.Bt);
  k.d2 = n2 - hat_times(o.n, o.B);
  k.one_d = o.B * qd + by.Psi1t * md;
  k.one_one = o.B * q1 + by.Psi1t * m1 + P1 * o.Psi1;
  k.one_two = o.B * q2 + by.Psi1t * m2 + P1 * o.Psi2;
  k.two_d = by.Bt * qd + by.Psi2t * md;
  k.two_one = by.Bt * q1 + by.Psi2t * m1 + P2 * o.Psi1;
  k.two_two = by.Bt * q2 + by.Psi2t * m2 + P2 * o.Psi2;
  return k;
}

// Derivatives of the force by the velocities (R'(v2 - v1), w1, w2): A' G A, A the rows (1, Z1, Z2) and
// (0, Psi1, Psi2).
inline Blocks damping_matrix(const Local& o, const Increments& by, const Damping& g) {
  const Mat c1 = g.Gyy * by.Z1 + g.Gyp * o.Psi1;
  const Mat c2 = g.Gyy * by.Z2 + g.Gyp * o.Psi2;
  const Mat Gpy = transpose(g.Gyp);
  const Mat p1 = Gpy * by.Z1 + g.Gpp * o.Psi1;
  const Mat p2 = Gpy * by.Z2 + g.Gpp * o.Psi2;
  const Mat T1 = transpose(by.Z1);
  const Mat T2 = transpose(by.Z2);
  Blocks c;
  c.dd = g.Gyy;
  c.d1 = c1;
  c.d2 = c2;
  c.one_d = T1 * g.Gyy + by.Psi1t * Gpy;
  c.one_one = T1 * c1 + by.Psi1t * p1;
  c.one_two = T1 * c2 + by.Psi1t * p2;
  c.two_d = T2 * g.Gyy + by.Psi2t * Gpy;
  c.two_one = T2 * c1 + by.Psi2t * p1;
  c.two_two = T2 * c2 + by.Psi2t * p2;
  return c;
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

  const ByChord second = second_by_chord(s, o);
  Hessian H = hessian(s, r, o, second, convex);
  const Increments by(o);
  Damping g;
  if (damped) {
    g = damping(s, r, e, o, by);
    add_metric_change(s, o, second, H);
  }
  expand(o, r, stiffness_matrix(o, by, H, damped ? &g : nullptr), K);
  if (damped && C) expand(o, r, damping_matrix(o, by, g), *C);
}

}  // namespace hawser
