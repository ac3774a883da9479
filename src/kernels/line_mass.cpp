#include "hawser/kernels/line_mass.hpp"

#include <algorithm>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// Hermite mass and load in (x1, L t1, x2, L t2), per m L and per w L.
constexpr double kMass[4][4] = {{156. / 420, 22. / 420, 54. / 420, -13. / 420},
                                {22. / 420, 4. / 420, 13. / 420, -3. / 420},
                                {54. / 420, 13. / 420, 156. / 420, -22. / 420},
                                {-13. / 420, -3. / 420, -22. / 420, 4. / 420}};
constexpr double kLoad[4] = {0.5, 1. / 12, 0.5, -1. / 12};

using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

struct Local {
  Mat3 R[2];
  Vec3 c;        // tangent in node axes
  Vec3 g[2];     // t'' in node axes: alpha x c + w x (w x c)
  Vec3 A[4];     // accelerations of (x1, L t1, x2, L t2)
  Vec3 F[4];     // forces conjugate to them
  Vec3 back[2];  // Q' F of the tangents
  Mat3 J;        // rotary inertia of half the element, node axes
};

void kinematics(const MassSection& s, const MassEnds& e, const Vec3& load, Local& o) {
  const double L = s.length, mL = s.mass_per_length * L;
  o.R[0] = e.q1.toRotationMatrix(), o.R[1] = e.q2.toRotationMatrix();
  o.c = s.axes.col(0);
  const Vec3 *w[2] = {&e.w1, &e.w2}, *al[2] = {&e.alpha1, &e.alpha2};
  for (int i = 0; i < 2; ++i) o.g[i] = al[i]->cross(o.c) + w[i]->cross(w[i]->cross(o.c));
  o.A[0] = e.a1, o.A[2] = e.a2;
  o.A[1] = L * (o.R[0] * o.g[0]), o.A[3] = L * (o.R[1] * o.g[1]);
  for (int i = 0; i < 4; ++i) {
    o.F[i] = -(kLoad[i] * L) * load;
    for (int j = 0; j < 4; ++j) o.F[i] += (kMass[i][j] * mL) * o.A[j];
  }
  o.back[0] = o.R[0].transpose() * o.F[1], o.back[1] = o.R[1].transpose() * o.F[3];
  o.J = (0.5 * L) * s.axes * s.rotary.asDiagonal() * s.axes.transpose();
}

void force(const MassSection& s, const MassEnds& e, const Local& o, double* f) {
  const Vec3 *w[2] = {&e.w1, &e.w2}, *al[2] = {&e.alpha1, &e.alpha2};
  for (int i = 0; i < 2; ++i) {
    Eigen::Map<Vec3>(f + 6 * i) = o.F[2 * i];
    Eigen::Map<Vec3>(f + 6 * i + 3) =
        s.length * o.c.cross(o.back[i]) + o.J * *al[i] + w[i]->cross(o.J * *w[i]);
  }
}

}  // namespace

void beam_mass_force(const MassSection& s, const MassEnds& e, const Vec3& load, double* f) {
  Local o;
  kinematics(s, e, load, o);
  force(s, e, o, f);
}

void beam_mass_tangent(const MassSection& s, const MassEnds& e, const Vec3& load, double* f, double* pK,
                       double* pC, double* pM) {
  Local o;
  kinematics(s, e, load, o);
  force(s, e, o, f);
  Eigen::Map<Mat12> K(pK), C(pC), M(pM);
  K.setZero(), C.setZero(), M.setZero();
  const double L = s.length, mL = s.mass_per_length * L;
  const Mat3 ch = hat(o.c), I = Mat3::Identity();
  const Vec3* w[2] = {&e.w1, &e.w2};
  // Columns of the tangent's acceleration: L Q (-hat(g), G, -hat(c)) by theta, w, alpha.
  Mat3 T[2], W[2], A[2];
  for (int i = 0; i < 2; ++i) {
    const Mat3 R = L * o.R[i];
    T[i].noalias() = -R * hat(o.g[i]);
    const Mat3 G = -hat(w[i]->cross(o.c)) - hat(*w[i]) * ch;
    W[i].noalias() = R * G;
    A[i].noalias() = -R * ch;
  }
  for (int i = 0; i < 2; ++i) {
    const Mat3 row = L * ch * o.R[i].transpose();  // tangent force to moment
    for (int j = 0; j < 2; ++j) {
      const double xx = mL * kMass[2 * i][2 * j], xt = mL * kMass[2 * i][2 * j + 1],
                   tx = mL * kMass[2 * i + 1][2 * j], tt = mL * kMass[2 * i + 1][2 * j + 1];
      M.block<3, 3>(6 * i, 6 * j) = xx * I;
      M.block<3, 3>(6 * i, 6 * j + 3) = xt * A[j];
      M.block<3, 3>(6 * i + 3, 6 * j) = tx * row;
      M.block<3, 3>(6 * i + 3, 6 * j + 3).noalias() = tt * row * A[j];
      C.block<3, 3>(6 * i, 6 * j + 3) = xt * W[j];
      C.block<3, 3>(6 * i + 3, 6 * j + 3).noalias() = tt * row * W[j];
      K.block<3, 3>(6 * i, 6 * j + 3) = xt * T[j];
      K.block<3, 3>(6 * i + 3, 6 * j + 3).noalias() = tt * row * T[j];
    }
    K.block<3, 3>(6 * i + 3, 6 * i + 3).noalias() += L * ch * hat(o.back[i]);
    C.block<3, 3>(6 * i + 3, 6 * i + 3).noalias() += hat(*w[i]) * o.J - hat(o.J * *w[i]);
    M.block<3, 3>(6 * i + 3, 6 * i + 3) += o.J;
  }
}

double beam_kinetic_energy(const MassSection& s, const MassEnds& e) {
  const double mL = s.mass_per_length * s.length;
  const Vec3 c = s.axes.col(0);
  const Vec3 V[4] = {e.v1, s.length * (e.q1 * e.w1.cross(c)), e.v2, s.length * (e.q2 * e.w2.cross(c))};
  double twice = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) twice += mL * kMass[i][j] * V[i].dot(V[j]);
  for (const Vec3& w : {e.w1, e.w2}) {
    const Vec3 local = s.axes.transpose() * w;
    twice += 0.5 * s.length * local.dot(s.rotary.cwiseProduct(local));
  }
  return 0.5 * twice;
}

double beam_load_work(const MassSection& s, const Vec3& x1, const Quat& q1, const Vec3& x2, const Quat& q2,
                      const Vec3& load) {
  const Vec3 c = s.axes.col(0);
  const double L = s.length;
  return load.dot((0.5 * L) * (x1 + x2) + (L * L / 12) * (q1 * c - q2 * c));
}

void cable_mass_force(const MassSection& s, const Vec3& a1, const Vec3& a2, const Vec3& load, double* f) {
  const double m = s.mass_per_length * s.length / 12;
  const Vec3 half = (0.5 * s.length) * load;
  Eigen::Map<Vec3>(f + 0) = m * (5 * a1 + a2) - half;
  Eigen::Map<Vec3>(f + 3) = m * (a1 + 5 * a2) - half;
}

void cable_mass_tangent(const MassSection& s, double* M) {
  const double m = s.mass_per_length * s.length / 12;
  std::fill(M, M + 36, 0.0);
  for (int i = 0; i < 6; ++i) {
    M[7 * i] = 5 * m;
    M[6 * i + (i + 3) % 6] = m;
  }
}

double cable_kinetic_energy(const MassSection& s, const Vec3& v1, const Vec3& v2) {
  return s.mass_per_length * s.length / 24 * (5 * v1.squaredNorm() + 2 * v1.dot(v2) + 5 * v2.squaredNorm());
}

}  // namespace hawser
