#include "hawser/kernels/beam.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

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
  Mat3 Rm;          // element axes to space
  Vec3 y, psi;      // chord in the mean frame, relative rotation
  Mat3 Psi1, Psi2;  // psi' = Psi1 theta1' + Psi2 theta2'
  Mat3 B;           // mean spin = B' theta1' + B theta2'
  double tau, tau1, eta, eta1;
  double l, a2, a3;     // |y|, y2/l, y3/l
  Vec3 d, da2, da3;     // gradients of l, a2, a3
  Vec3 eps_y, eps_psi;  // gradients of the strain
  double strain;        // from the stress-free state
  double k2, k3;        // 12 EI/(L (1 + P))
  Vec3 D;               // (GJ, EI2, EI3)/L
  double N, m2, m3;     // stresses: axial, antisymmetric bending about 2 (with a3), about 3 (with a2)
  Vec3 mpsi;            // symmetric bending and torsion moments, D (psi - psi0 + beta psi')
  Vec3 n, m;            // dW/dy, dW/dpsi
  Vec3 yd, psid;        // rates, with damping only
  double epsd;
};

void kinematics(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool rates, Local& o) {
  Quat q1 = e.q1, q2 = e.q2;
  if (!r.aligned) {
    const Quat a(r.axes);
    q1 = q1 * a, q2 = q2 * a;
  }
  o.psi = log_so3(q1.conjugate() * q2);
  o.Rm = (q1 * exp_so3(0.5 * o.psi)).toRotationMatrix();
  o.y.noalias() = o.Rm.transpose() * (e.x2 - e.x1);
  const double t2 = o.psi.squaredNorm();
  mean_spin_coefficient(t2, o.tau, o.tau1);
  inverse_jacobian_coefficient(t2, o.eta, o.eta1);
  const Mat3 h = hat(o.psi);
  // hat² = psi psi' - t2 I
  const Mat3 even = (1 - o.eta * t2) * Mat3::Identity() + o.eta * o.psi * o.psi.transpose();
  o.Psi2 = even + 0.5 * h;
  o.Psi1 = 0.5 * h - even;
  o.B = 0.5 * Mat3::Identity() + (0.5 * o.tau) * h;

  o.l = o.y.norm();
  const double il = 1 / o.l;
  o.d = il * o.y;
  o.a2 = o.d.y(), o.a3 = o.d.z();
  o.da2 = il * (Vec3::UnitY() - o.a2 * o.d);
  o.da3 = il * (Vec3::UnitZ() - o.a3 * o.d);
  o.eps_y = o.d / s.length + 0.2 * (o.a2 * o.da2 + o.a3 * o.da3);
  o.eps_psi = Vec3(0, o.psi.y() / 12, o.psi.z() / 12);
  o.strain = (o.l - s.length) / s.length + 0.1 * (o.a2 * o.a2 + o.a3 * o.a3) +
             (o.psi.y() * o.psi.y() + o.psi.z() * o.psi.z()) / 24 - r.strain;
  const double shear = s.GA > 0 ? 12 / (s.GA * s.length * s.length) : 0;
  o.k2 = 12 * s.EI2 / (s.length * (1 + shear * s.EI2));
  o.k3 = 12 * s.EI3 / (s.length * (1 + shear * s.EI3));
  o.D = Vec3(s.GJ, s.EI2, s.EI3) / s.length;

  o.N = s.EA * o.strain;
  o.m2 = o.k2 * o.a3;
  o.m3 = o.k3 * o.a2;
  o.mpsi = o.D.cwiseProduct(o.psi - r.psi);
  if (rates) {
    Vec3 w1 = e.w1, w2 = e.w2;
    if (!r.aligned) w1 = r.axes.transpose() * w1, w2 = r.axes.transpose() * w2;
    o.psid = o.Psi1 * w1 + o.Psi2 * w2;
    o.yd = o.Rm.transpose() * (e.v2 - e.v1) + o.y.cross(o.B.transpose() * w1 + o.B * w2);
    o.epsd = o.eps_y.dot(o.yd) + o.eps_psi.dot(o.psid);
    o.N += s.beta * s.EA * o.epsd;
    o.m2 += s.beta * o.k2 * o.da3.dot(o.yd);
    o.m3 += s.beta * o.k3 * o.da2.dot(o.yd);
    o.mpsi += s.beta * o.D.cwiseProduct(o.psid);
  }
  o.n = (o.N * s.length) * o.eps_y + o.m3 * o.da2 + o.m2 * o.da3;
  o.m = (o.N * s.length) * o.eps_psi + o.mpsi;
}

void force(const Local& o, const BeamReference& r, double* f) {
  const Vec3 q = o.n.cross(o.y);
  const Vec3 fd = o.Rm * o.n;
  Vec3 f1 = o.B * q + o.Psi1.transpose() * o.m;
  Vec3 f2 = o.B.transpose() * q + o.Psi2.transpose() * o.m;
  if (!r.aligned) f1 = r.axes * f1, f2 = r.axes * f2;
  Eigen::Map<Vec3>(f + 0) = -fd;
  Eigen::Map<Vec3>(f + 3) = f1;
  Eigen::Map<Vec3>(f + 6) = fd;
  Eigen::Map<Vec3>(f + 9) = f2;
}

// Hessian of a_k = y_k/|y| (Crisfield's lateral chord components).
Mat3 slope_hessian(const Vec3& axis, double a, const Vec3& d, double l) {
  const double c = 1 / (l * l);
  Mat3 h = (3 * a * c) * d * d.transpose();
  h.noalias() -= c * (axis * d.transpose() + d * axis.transpose());
  h.diagonal().array() -= a * c;
  return h;
}

using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

// Blocks of a 9x9 in (d, theta1, theta2), d in the mean frame, to the 12x12 in space axes.
struct Blocks {
  Mat3 dd, d1, d2, one_d, one_one, one_two, two_d, two_one, two_two;
};

void expand(const Local& o, const BeamReference& r, Blocks& b, double* out) {
  Eigen::Map<Mat12> K(out);
  const Mat3 dd = o.Rm * b.dd * o.Rm.transpose();
  Mat3 d1 = o.Rm * b.d1, d2 = o.Rm * b.d2;
  Mat3 a = b.one_d * o.Rm.transpose(), c = b.two_d * o.Rm.transpose();
  if (!r.aligned) {
    const Mat3& A = r.axes;
    d1 = d1 * A.transpose(), d2 = d2 * A.transpose();
    a = A * a, c = A * c;
    for (Mat3* m : {&b.one_one, &b.one_two, &b.two_one, &b.two_two}) *m = (A * *m * A.transpose()).eval();
  }
  K.block<3, 3>(0, 0) = dd, K.block<3, 3>(0, 6) = -dd, K.block<3, 3>(6, 0) = -dd, K.block<3, 3>(6, 6) = dd;
  K.block<3, 3>(0, 3) = -d1, K.block<3, 3>(6, 3) = d1, K.block<3, 3>(0, 9) = -d2, K.block<3, 3>(6, 9) = d2;
  K.block<3, 3>(3, 0) = -a, K.block<3, 3>(3, 6) = a, K.block<3, 3>(9, 0) = -c, K.block<3, 3>(9, 6) = c;
  K.block<3, 3>(3, 3) = b.one_one, K.block<3, 3>(3, 9) = b.one_two;
  K.block<3, 3>(9, 3) = b.two_one, K.block<3, 3>(9, 9) = b.two_two;
}

// Derivative of (I -+ hat/2 + eta hat²) m with respect to psi; `sign` is that of the hat term.
Mat3 inverse_jacobian_derivative(const Local& o, const Vec3& m, double sign) {
  const Vec3 pm = o.psi.cross(m);
  Mat3 d = (-0.5 * sign) * hat(m);
  d.noalias() += o.eta1 * o.psi.cross(pm) * o.psi.transpose();
  // -(hat(psi x m) + hat(psi) hat(m)), with hat(a)hat(b) = b a' - (a.b) I
  d.noalias() -= o.eta * (hat(pm) + m * o.psi.transpose());
  d.diagonal().array() += o.eta * o.psi.dot(m);
  return d;
}

// Derivative of B q with respect to psi.
Mat3 mean_spin_derivative(const Local& o, const Vec3& q) {
  Mat3 d = (-0.5 * o.tau) * hat(q);
  d.noalias() += (0.5 * o.tau1) * o.psi.cross(q) * o.psi.transpose();
  return d;
}

}  // namespace

void beam_force(const BeamSection& s, const BeamReference& r, const BeamEnds& e, double* f) {
  Local o;
  kinematics(s, r, e, s.beta > 0, o);
  force(o, r, f);
}

void beam_tangent(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool convex, double* f,
                  double* K, double* C) {
  Local o;
  const bool damped = s.beta > 0;
  kinematics(s, r, e, damped, o);
  force(o, r, f);

  const double EAL = s.EA * s.length;
  const double NL = (convex ? std::max(o.N, 0.0) : o.N) * s.length;
  const Mat3 h2 = slope_hessian(Vec3::UnitY(), o.a2, o.d, o.l);
  const Mat3 h3 = slope_hessian(Vec3::UnitZ(), o.a3, o.d, o.l);
  Mat3 eps_yy = 0.2 * (o.da2 * o.da2.transpose() + o.da3 * o.da3.transpose() + o.a2 * h2 + o.a3 * h3);
  const double c = 1 / (o.l * s.length);
  eps_yy.noalias() -= c * o.d * o.d.transpose();
  eps_yy.diagonal().array() += c;

  // Hessian of W; with damping the rate terms at fixed strain rates join it.
  Mat3 Hyy = EAL * o.eps_y * o.eps_y.transpose() + NL * eps_yy + o.k3 * o.da2 * o.da2.transpose() +
             o.m3 * h2 + o.k2 * o.da3 * o.da3.transpose() + o.m2 * h3;
  Mat3 Hyp = EAL * o.eps_y * o.eps_psi.transpose();
  Mat3 Hpp = EAL * o.eps_psi * o.eps_psi.transpose();
  Hpp.diagonal() += o.D + Vec3(0, NL / 12, NL / 12);
  Mat3 Hpy = Hyp.transpose();

  const Vec3 q = o.n.cross(o.y);
  const Mat3 yhat = hat(o.y), nhat = hat(o.n);
  const Mat3 Z1 = yhat * o.B.transpose(), Z2 = yhat * o.B;
  const Mat3 S = mean_spin_derivative(o, q);
  const Mat3 P1 = S - inverse_jacobian_derivative(o, o.m, 1);   // of B q + Psi1' m
  const Mat3 P2 = inverse_jacobian_derivative(o, o.m, -1) - S;  // of B' q + Psi2' m

  // The damping metric in (y, psi), and the change of the strain rates with the configuration.
  Mat3 Gyy, Gyp, Gpp, Yd, Y1, Y2, R1, R2;
  if (damped) {
    const double b = s.beta;
    Gyy = b * (EAL * o.eps_y * o.eps_y.transpose() + o.k3 * o.da2 * o.da2.transpose() +
               o.k2 * o.da3 * o.da3.transpose());
    Gyp = b * EAL * o.eps_y * o.eps_psi.transpose();
    Gpp = b * EAL * o.eps_psi * o.eps_psi.transpose();
    Gpp.diagonal() += b * o.D;
    const Vec3 ey = eps_yy * o.yd;
    const Vec3 ep(0, o.psid.y() / 12, o.psid.z() / 12);
    Hyy += b * (EAL * o.eps_y * ey.transpose() + o.k3 * o.da2 * (h2 * o.yd).transpose() +
                o.k2 * o.da3 * (h3 * o.yd).transpose());
    Hyp += b * EAL * o.eps_y * ep.transpose();
    Hpy += b * EAL * o.eps_psi * ey.transpose();
    Hpp += b * EAL * o.eps_psi * ep.transpose();

    Vec3 w1 = e.w1, w2 = e.w2;
    if (!r.aligned) w1 = r.axes.transpose() * w1, w2 = r.axes.transpose() * w2;
    const Vec3 wm = o.B.transpose() * w1 + o.B * w2;
    const Vec3 vd = o.Rm.transpose() * (e.v2 - e.v1);
    // y' = vd + y x wm: varies by vd x dm + dy x wm + y x dwm, dwm = d(B)(w2 - w1)
    const Mat3 W = yhat * mean_spin_derivative(o, w2 - w1);
    const Mat3 V = hat(vd), wh = hat(wm);
    Yd = -wh;
    Y1 = V * o.B.transpose() - wh * Z1 + W * o.Psi1;
    Y2 = V * o.B - wh * Z2 + W * o.Psi2;
    const Mat3 R = inverse_jacobian_derivative(o, w2, 1) - inverse_jacobian_derivative(o, w1, -1);
    R1 = R * o.Psi1, R2 = R * o.Psi2;
  }

  // dn and dm (of the potential's gradients) for each of d, theta1, theta2
  Mat3 nd = Hyy, n1 = Hyy * Z1 + Hyp * o.Psi1, n2 = Hyy * Z2 + Hyp * o.Psi2;
  Mat3 md = Hpy, m1 = Hpy * Z1 + Hpp * o.Psi1, m2 = Hpy * Z2 + Hpp * o.Psi2;
  if (damped) {
    nd.noalias() += Gyy * Yd;
    n1.noalias() += Gyy * Y1 + Gyp * R1;
    n2.noalias() += Gyy * Y2 + Gyp * R2;
    md.noalias() += Gyp.transpose() * Yd;
    m1.noalias() += Gyp.transpose() * Y1 + Gpp * R1;
    m2.noalias() += Gyp.transpose() * Y2 + Gpp * R2;
  }
  // dq = dn x y + n x dy
  const Mat3 qd = nhat - yhat * nd, q1 = nhat * Z1 - yhat * n1, q2 = nhat * Z2 - yhat * n2;
  const Mat3 Bt = o.B.transpose(), Psi1t = o.Psi1.transpose(), Psi2t = o.Psi2.transpose();
  Blocks k;
  k.dd = nd;
  k.d1 = n1 - nhat * Bt;
  k.d2 = n2 - nhat * o.B;
  k.one_d = o.B * qd + Psi1t * md;
  k.one_one = o.B * q1 + Psi1t * m1 + P1 * o.Psi1;
  k.one_two = o.B * q2 + Psi1t * m2 + P1 * o.Psi2;
  k.two_d = Bt * qd + Psi2t * md;
  k.two_one = Bt * q1 + Psi2t * m1 + P2 * o.Psi1;
  k.two_two = Bt * q2 + Psi2t * m2 + P2 * o.Psi2;
  expand(o, r, k, K);

  if (damped && C) {
    const Mat3 c1 = Gyy * Z1 + Gyp * o.Psi1, c2 = Gyy * Z2 + Gyp * o.Psi2;
    const Mat3 p1 = Gyp.transpose() * Z1 + Gpp * o.Psi1, p2 = Gyp.transpose() * Z2 + Gpp * o.Psi2;
    Blocks g;
    g.dd = Gyy, g.d1 = c1, g.d2 = c2;
    const Mat3 T1 = Z1.transpose(), T2 = Z2.transpose();  // theta row: Z' dn + Psi' dm
    g.one_d = T1 * Gyy + Psi1t * Gyp.transpose();
    g.one_one = T1 * c1 + Psi1t * p1;
    g.one_two = T1 * c2 + Psi1t * p2;
    g.two_d = T2 * Gyy + Psi2t * Gyp.transpose();
    g.two_one = T2 * c1 + Psi2t * p1;
    g.two_two = T2 * c2 + Psi2t * p2;
    expand(o, r, g, C);
  }
}

BeamStress beam_stress(const BeamSection& s, const BeamReference& r, const BeamEnds& e) {
  Local o;
  kinematics(s, r, e, s.beta > 0, o);
  BeamStress out;
  out.tension = o.N;
  const Vec3 p = o.psi - r.psi;
  out.strain_energy = 0.5 * (s.EA * s.length * o.strain * o.strain + o.k3 * o.a2 * o.a2 + o.k2 * o.a3 * o.a3 +
                             p.dot(o.D.cwiseProduct(p)));
  if (s.beta > 0) {
    const double r2 = o.da2.dot(o.yd), r3 = o.da3.dot(o.yd);
    out.dissipation = s.beta * (s.EA * s.length * o.epsd * o.epsd + o.k3 * r2 * r2 + o.k2 * r3 * r3 +
                                o.psid.dot(o.D.cwiseProduct(o.psid)));
  }
  // The chord turns by +y3/l about axis 2 and by -y2/l about axis 3 against the mean frame.
  const Vec3 bend(0, 0.5 * o.m2, -0.5 * o.m3);
  out.moment1 = o.mpsi - bend;
  out.moment2 = o.mpsi + bend;
  const Vec3 EI(s.GJ, s.EI2, s.EI3);
  for (int i = 0; i < 3; ++i) {
    out.curvature1[i] = EI[i] > 0 ? out.moment1[i] / EI[i] : 0;
    out.curvature2[i] = EI[i] > 0 ? out.moment2[i] / EI[i] : 0;
  }
  return out;
}

BeamReference beam_reference(const BeamSection& s, const BeamEnds& e, const Mat3& axes) {
  BeamReference r;
  r.axes = axes;
  r.aligned = axes.isIdentity(0);
  Local o;
  kinematics(s, r, e, false, o);
  r.psi = o.psi;
  r.strain = o.strain;
  return r;
}

}  // namespace hawser
