// The beam element: kinematics of the co-rotational frame, internal force and exact tangent,
// stiffness-proportional damping, bending by a table or with memory, section moments, stress-free reference.
#include "hawser/kernels/beam.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/math/clones.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser {
namespace {

using namespace wide;  // rows and matrices of the local element; hat and the rest are theirs

// tan(t/4)/t and (d/dt)/t of it: the skew part of the mean spin.
void mean_spin_coefficient(double t2, double& tau, double& tau1) {
  if (t2 < 0.05) {
    tau = 0.25 + t2 * (1.0 / 192 + t2 * (1.0 / 7680 + t2 * (17.0 / 5160960)));
    tau1 = 1.0 / 96 + t2 * (1.0 / 1920 + t2 * (17.0 / 860160 + t2 * 6.674e-7));
  } else {
    const double t = std::sqrt(t2), c = std::cos(t / 4), g = std::tan(t / 4);
    tau = g / t;
    tau1 = (0.25 / (c * c) - tau) / t2;
  }
}

// Everything of the local element that force and tangent share, in element axes.
struct Local {
  Mat Rm;          // element axes to space
  Row y, psi;      // chord in the mean frame, relative rotation
  Mat Psi1, Psi2;  // psi' = Psi1 theta1' + Psi2 theta2'
  Mat B;           // mean spin = B' theta1' + B theta2'
  double tau, tau1, eta, eta1;
  double l, a2, a3;     // |y|, 2 y2/(l + y1), 2 y3/(l + y1)
  Row d, da2, da3;      // gradients of l, a2, a3
  Row g;                // of l + y1
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
void spins(const BeamReference& r, const BeamEnds& e, Row& w1, Row& w2) {
  w1 = load(e.w1), w2 = load(e.w2);
  if (!r.aligned) w1 = load(Vec3(r.axes.transpose() * e.w1)), w2 = load(Vec3(r.axes.transpose() * e.w2));
}

// Bending that is not linear: gradient and Hessian of its energy in (psi2, psi3, a3, a2).
struct Bending {
  double energy = 0, g[4] = {}, H[4][4] = {};
};

BendingMoment by_table(const BeamSection& s, double c2, double c3) {
  const double c = std::hypot(c2, c3), linear = s.EI2 - s.moment->initial();
  const StiffnessTable::Value v = s.moment->at(c);
  const double secant = c > 0 ? v.force / c : s.moment->initial();
  // Secant across the curvature, tangent along it.
  const double rest = c > 0 ? (v.slope - secant) / (c * c) : 0;
  BendingMoment o;
  o.energy = v.energy + 0.5 * linear * c * c;
  o.m[0] = (secant + linear) * c2, o.m[1] = (secant + linear) * c3;
  o.K[0][0] = secant + linear + rest * c2 * c2, o.K[1][1] = secant + linear + rest * c3 * c3;
  o.K[0][1] = o.K[1][0] = rest * c2 * c3;
  return o;
}

// On top of it what EI2 = EI3 is above its first slope, elastic: a bend stiffener.
BendingMoment with_memory(const BeamSection& s, double c2, double c3, const double* set) {
  BendingMoment o = s.plastic->at(c2, c3, set);
  const double linear = s.EI2 - s.plastic->initial();
  o.energy += 0.5 * linear * (c2 * c2 + c3 * c3);
  o.m[0] += linear * c2, o.m[1] += linear * c3;
  o.K[0][0] += linear, o.K[1][1] += linear;
  return o;
}

// The curvature is linear along the element, (psi2 + 6 xi a3, psi3 - 6 xi a2)/L with xi from -1 to 1: what
// the cubic deflection has, and for a constant EI the energy of the linear law.
constexpr double kGauss[kBendingPlaces] = {-0.7745966692414834, 0, 0.7745966692414834};
constexpr double kWeight[kBendingPlaces] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

struct Curvature {
  double about2, about3;  // 1/m
};
Curvature curvature_at(const BeamSection& s, const BeamReference& r, const Local& o, double xi) {
  const double z = 6 * xi, iL = 1 / s.length;
  return {iL * (o.psi[1] - r.psi[1] + z * o.a3), iL * (o.psi[2] - r.psi[2] - z * o.a2)};
}

Bending bending_by_law(const BeamSection& s, const BeamReference& r, const Local& o) {
  Bending b;
  const double iL = 1 / s.length;
  for (int k = 0; k < kBendingPlaces; ++k) {
    const double z = 6 * kGauss[k];
    const Curvature c = curvature_at(s, r, o, kGauss[k]);
    const double* set = r.set ? r.set + static_cast<size_t>(k) * s.plastic->memory() : nullptr;
    const BendingMoment m =
        s.plastic ? with_memory(s, c.about2, c.about3, set) : by_table(s, c.about2, c.about3);
    b.energy += kWeight[k] * s.length * m.energy;
    // By which of the two curvatures each variable is, and how much.
    const int of[4] = {0, 1, 0, 1};
    const double by[4] = {1, 1, z, -z};
    for (int i = 0; i < 4; ++i) {
      b.g[i] += kWeight[k] * by[i] * m.m[of[i]];
      for (int j = 0; j < 4; ++j) b.H[i][j] += kWeight[k] * iL * by[i] * by[j] * m.K[of[i]][of[j]];
    }
  }
  return b;
}

void axial_by_table(const BeamSection& s, Local& o) {
  const double share = s.EA / s.tension->initial();
  const StiffnessTable::Value v = s.tension->at(o.strain);
  o.N = share * v.force, o.EA = share * v.slope, o.axial_energy = share * v.energy;
}

inline void kinematics(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool rates,
                       Local& o) {
  Quat q1 = e.q1, q2 = e.q2;
  if (!r.aligned) {
    const Quat a(r.axes);
    q1 = q1 * a, q2 = q2 * a;
  }
  const Vec3 psi = log_so3(q1.conjugate() * q2);
  o.psi = load(psi);
  o.Rm = wide::rotation(q1 * exp_so3(0.5 * psi));
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
  const double il = 1 / o.l, iL = 1 / s.length;
  o.d = il * o.y;
  o.g = o.d + unit(0);
  const double ic = 1 / (o.l + o.y[0]);
  o.a2 = 2 * ic * o.y[1], o.a3 = 2 * ic * o.y[2];
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

  o.N = s.EA * o.strain, o.EA = s.EA;
  if (s.tension) axial_by_table(s, o);
  o.m2 = o.k2 * o.a3;
  o.m3 = o.k3 * o.a2;
  o.mpsi = o.D * (o.psi - load(r.psi));
  if (s.bends_by_law()) {
    const Bending b = bending_by_law(s, r, o);
    o.m2 = b.g[2], o.m3 = b.g[3];
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

inline void force(const Local& o, const BeamReference& r, double* f) {
  const Row q = cross(o.n, o.y);
  const Row fd = times(o.Rm, o.n);
  Vec3 f1 = vec(times(o.B, q) + left(o.m, o.Psi1));
  Vec3 f2 = vec(left(q, o.B) + left(o.m, o.Psi2));
  if (!r.aligned) f1 = r.axes * f1, f2 = r.axes * f2;
  for (int i = 0; i < 3; ++i) f[i] = -fd[i], f[3 + i] = f1[i], f[6 + i] = fd[i], f[9 + i] = f2[i];
}

// Hessian of a_k = 2 y_k/(l + y1).
inline Mat slope_hessian(const Local& o, double a, Row da) {
  const double is = 1 / (o.l + o.y[0]), c = a * is / o.l;
  return outer(c * o.d, o.d) - identity(c) - outer(is * da, o.g) - outer(is * o.g, da);
}

// Blocks of a 9x9 in (d, theta1, theta2), d in the mean frame, to the 12x12 in space axes.
struct Blocks {
  Mat dd, d1, d2, one_d, one_one, one_two, two_d, two_one, two_two;
};

inline void expand(const Local& o, const BeamReference& r, const Blocks& b, double* K) {
  const Mat Rt = transpose(o.Rm);
  const Mat dd = o.Rm * b.dd * Rt;
  Mat d1 = o.Rm * b.d1, d2 = o.Rm * b.d2, a = b.one_d * Rt, c = b.two_d * Rt;
  Mat m11 = b.one_one, m12 = b.one_two, m21 = b.two_one, m22 = b.two_two;
  if (!r.aligned) {
    const Mat A = load(r.axes), At = transpose(A);
    d1 = d1 * At, d2 = d2 * At, a = A * a, c = A * c;
    m11 = A * m11 * At, m12 = A * m12 * At, m21 = A * m21 * At, m22 = A * m22 * At;
  }
  const auto put = [K](int i, int j, const Mat& m) { store(m, K + 36 * i + 3 * j, 12); };
  put(0, 0, dd), put(0, 2, -dd), put(2, 0, -dd), put(2, 2, dd);
  put(0, 1, -d1), put(2, 1, d1), put(0, 3, -d2), put(2, 3, d2);
  put(1, 0, -a), put(1, 2, a), put(3, 0, -c), put(3, 2, c);
  put(1, 1, m11), put(1, 3, m12), put(3, 1, m21), put(3, 3, m22);
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

// The damping metric in (y, psi), and the change of the strain rates with the configuration.
struct Damping {
  Mat Gyy, Gyp, Gpp, Yd, Y1, Y2, R1, R2;
};

// Joins the rate terms at fixed strain rates to the Hessian, and gives what the strain rates' change adds.
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
  g.R1 = R * o.Psi1, g.R2 = R * o.Psi2;
}

}  // namespace

HAWSER_CLONES void beam_force(const BeamSection& s, const BeamReference& r, const BeamEnds& e, double* f) {
  Local o;
  kinematics(s, r, e, s.beta > 0, o);
  force(o, r, f);
}

HAWSER_CLONES void beam_tangent(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool convex,
                                double* f, double* K, double* C) {
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

  const Row q = cross(o.n, o.y);
  const Mat Bt = transpose(o.B);
  const Mat Z1 = hat_times(o.y, Bt), Z2 = hat_times(o.y, o.B);
  const Mat S = mean_spin_derivative(o, q);
  const Mat P1 = S - inverse_jacobian_derivative(o, o.m, 1);   // of B q + Psi1' m
  const Mat P2 = inverse_jacobian_derivative(o, o.m, -1) - S;  // of B' q + Psi2' m
  Damping g;
  if (damped) damping(s, r, e, o, eps_yy, h2, h3, Z1, Z2, Hyy, Hyp, Hpy, Hpp, g);

  // dn and dm (of the potential's gradients) for each of d, theta1, theta2
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
    v.dd = g.Gyy, v.d1 = c1, v.d2 = c2;
    v.one_d = T1 * g.Gyy + Psi1t * Gpy;
    v.one_one = T1 * c1 + Psi1t * p1;
    v.one_two = T1 * c2 + Psi1t * p2;
    v.two_d = T2 * g.Gyy + Psi2t * Gpy;
    v.two_one = T2 * c1 + Psi2t * p1;
    v.two_two = T2 * c2 + Psi2t * p2;
    expand(o, r, v, C);
  }
}

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
    const double r2 = dot(o.da2, o.yd), r3 = dot(o.da3, o.yd);
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
  // The chord turns by +y3/l about axis 2 and by -y2/l about axis 3 against the mean frame. Of plastic
  // bending, which is remembered inside the element, the linear moments that do the same work.
  const Vec3 bend(0, 0.5 * o.m2, -0.5 * o.m3), mean = vec(o.mpsi);
  out.moment1 = mean - bend;
  out.moment2 = mean + bend;
  if (s.plastic) {
    out.curvature1 = kinematic(-1), out.curvature2 = kinematic(1);
    if (!r.set) return out;
    const auto left = [&](size_t place) {
      const auto [c2, c3] = s.plastic->residual(r.set + place * s.plastic->memory());
      return std::hypot(c2, c3);
    };
    out.residual1 = left(0), out.residual2 = left(kBendingPlaces - 1);
    return out;
  }
  const Vec3 EI(s.GJ, s.EI2, s.EI3);
  for (int i = 0; i < 3; ++i) {
    out.curvature1[i] = EI[i] > 0 ? out.moment1[i] / EI[i] : 0;
    out.curvature2[i] = EI[i] > 0 ? out.moment2[i] / EI[i] : 0;
  }
  return out;
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

BeamReference beam_reference(const BeamSection& s, const BeamEnds& e, const Mat3& axes) {
  BeamReference r;
  r.axes = axes;
  r.aligned = axes.isIdentity(0);
  Local o;
  kinematics(s, r, e, false, o);
  r.psi = vec(o.psi);
  r.strain = o.strain;
  return r;
}

}  // namespace hawser
