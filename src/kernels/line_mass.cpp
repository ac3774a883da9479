// Consistent mass matrices of beam and cable elements, gyroscopic terms and rotary inertia, weight and dead
// loads, with exact tangents, kinetic energy and work. Added mass is in morison_points.hpp.
#include "hawser/kernels/line_mass.hpp"

#include "hawser/math/clones.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser {
namespace {

using namespace wide;

// F = M (a1, L t1'', a2, L t2'') - load,  t'' = Q g,  g = alpha x c + w x (w x c); on a position F_x, on a
// rotation L c x Q' F_t + J alpha + w x J w (docs/theory/beam.md#mass). Hermite mass and load in (x1, L t1,
// x2, L t2), per m L and per w L.
constexpr double kMass[4][4] = {{156. / 420, 22. / 420, 54. / 420, -13. / 420},
                                {22. / 420, 4. / 420, 13. / 420, -3. / 420},
                                {54. / 420, 13. / 420, 156. / 420, -22. / 420},
                                {-13. / 420, -3. / 420, -22. / 420, 4. / 420}};
constexpr double kLoad[4] = {0.5, 1. / 12, 0.5, -1. / 12};

struct Local {
  Mat R[2];
  Row c;                        // tangent in node axes
  Row g[2];                     // t'' in node axes: alpha x c + w x (w x c); unused if directors are given
  Row A[4];                     // accelerations of (x1, L t1, x2, L t2)
  Row F[4];                     // forces conjugate to them
  Row back[2];                  // Q' F of the tangents
  Row w[2], alpha[2], spin[2];  // spin: J w
};

inline Mat3 axes(const MassSection& s) { return s.axes ? *s.axes : Mat3::Identity(); }

// Rotary inertia of half the element, node axes.
inline Mat rotary(const MassSection& s) {
  const Mat A = load(axes(s));
  Mat JA = transpose(A);
  for (int i = 0; i < 3; ++i) JA.r[i] *= 0.5 * s.length * s.rotary[i];
  return A * JA;
}

inline void kinematics(const MassSection& s, const MassEnds& e, const Vec3& dead, const Mat& J, Local& o) {
  const double L = s.length;
  const double mL = s.mass_per_length * L;
  o.R[0] = rotation(e.q1);
  o.R[1] = rotation(e.q2);
  o.c = load(Vec3(axes(s).col(0)));
  o.w[0] = load(e.w1);
  o.w[1] = load(e.w2);
  o.alpha[0] = load(e.alpha1);
  o.alpha[1] = load(e.alpha2);
  const Mat3* given[2] = {e.directors1, e.directors2};
  for (int i = 0; i < 2; ++i) {
    if (given[i]) {
      const Mat3& D = *given[i];
      o.A[2 * i + 1] = (L * o.c[0]) * load(Vec3(D.col(0))) + (L * o.c[1]) * load(Vec3(D.col(1))) +
                       (L * o.c[2]) * load(Vec3(D.col(2)));
    } else {
      o.g[i] = cross(o.alpha[i], o.c) + cross(o.w[i], cross(o.w[i], o.c));
      o.A[2 * i + 1] = L * times(o.R[i], o.g[i]);
    }
    o.spin[i] = times(J, o.w[i]);
  }
  o.A[0] = load(e.a1);
  o.A[2] = load(e.a2);
  const Row q = load(dead);
  for (int i = 0; i < 4; ++i) {
    o.F[i] = -(kLoad[i] * L) * q;
    for (int j = 0; j < 4; ++j) o.F[i] += (kMass[i][j] * mL) * o.A[j];
  }
  o.back[0] = left(o.F[1], o.R[0]);
  o.back[1] = left(o.F[3], o.R[1]);
}

inline void force(const MassSection& s, const Local& o, const Mat& J, Vec12& f) {
  for (int i = 0; i < 2; ++i) {
    const Row m = s.length * cross(o.c, o.back[i]) + times(J, o.alpha[i]) + cross(o.w[i], o.spin[i]);
    for (int k = 0; k < 3; ++k) {
      f[6 * i + k] = o.F[2 * i][k];
      f[6 * i + 3 + k] = m[k];
    }
  }
}

}  // namespace

HAWSER_CLONES void beam_mass_force(const MassSection& s, const MassEnds& e, const Vec3& load, Vec12& f) {
  Local o;
  const Mat J = rotary(s);
  kinematics(s, e, load, J, o);
  force(s, o, J, f);
}

HAWSER_CLONES void beam_mass_tangent(const MassSection& s, const MassEnds& e, const Vec3& load, Vec12& f,
                                     Mat12& K, Mat12& C, Mat12& M) {
  Local o;
  const Mat J = rotary(s);
  kinematics(s, e, load, J, o);
  force(s, o, J, f);
  const double L = s.length;
  const double mL = s.mass_per_length * L;
  const Mat zero{};
  const bool given = e.directors1;
  // Columns of the tangent's acceleration: L Q (-hat(g), G, -hat(c)) by theta, w, alpha; when it is given
  // L Q (-mu hat(w x c), 0, -hat(c)).
  Mat T[2], W[2], A[2];
  for (int i = 0; i < 2; ++i) {
    const Mat R = L * o.R[i];
    const Row rate = cross(o.w[i], o.c);
    T[i] = times_hat(R, given ? -e.director_weight * rate : -o.g[i]);
    W[i] = given ? zero : times_hat(R, -rate) - times_hat(times_hat(R, o.w[i]), o.c);
    A[i] = times_hat(R, -o.c);
  }
  for (int i = 0; i < 2; ++i) {
    const Mat row = L * hat_times(o.c, transpose(o.R[i]));  // tangent force to moment
    for (int j = 0; j < 2; ++j) {
      const double xx = mL * kMass[2 * i][2 * j];
      const double xt = mL * kMass[2 * i][2 * j + 1];
      const double tx = mL * kMass[2 * i + 1][2 * j];
      const double tt = mL * kMass[2 * i + 1][2 * j + 1];
      const Mat moment = tt * row;
      Mat k = moment * T[j];
      Mat c = given ? zero : moment * W[j];
      Mat m = moment * A[j];
      if (i == j) {
        k += L * hat_times(o.c, hat(o.back[i]));
        c += hat_times(o.w[i], J) - hat(o.spin[i]);
        m += J;
      }
      put(M, 2 * i, 2 * j, identity(xx));
      put(M, 2 * i, 2 * j + 1, xt * A[j]);
      put(M, 2 * i + 1, 2 * j, tx * row);
      put(M, 2 * i + 1, 2 * j + 1, m);
      put(C, 2 * i, 2 * j, zero);
      put(C, 2 * i, 2 * j + 1, xt * W[j]);
      put(C, 2 * i + 1, 2 * j, zero);
      put(C, 2 * i + 1, 2 * j + 1, c);
      put(K, 2 * i, 2 * j, zero);
      put(K, 2 * i, 2 * j + 1, xt * T[j]);
      put(K, 2 * i + 1, 2 * j, zero);
      put(K, 2 * i + 1, 2 * j + 1, k);
    }
  }
}

double beam_kinetic_energy(const MassSection& s, const MassEnds& e) {
  const double mL = s.mass_per_length * s.length;
  const Vec3 c = axes(s).col(0);
  const Vec3 V[4] = {e.v1, s.length * (e.q1 * e.w1.cross(c)), e.v2, s.length * (e.q2 * e.w2.cross(c))};
  double twice = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) twice += mL * kMass[i][j] * V[i].dot(V[j]);
  for (const Vec3& w : {e.w1, e.w2}) {
    const Vec3 local = axes(s).transpose() * w;
    twice += 0.5 * s.length * local.dot(s.rotary.cwiseProduct(local));
  }
  return 0.5 * twice;
}

double beam_load_work(const MassSection& s, const Vec3& x1, const Quat& q1, const Vec3& x2, const Quat& q2,
                      const Vec3& load) {
  const Vec3 c = axes(s).col(0);
  const double L = s.length;
  return load.dot((0.5 * L) * (x1 + x2) + (L * L / 12) * (q1 * c - q2 * c));
}

CableMass cable_mass(const MassSection& s) {
  const double twelfth = s.mass_per_length * s.length / 12;
  return {5 * twelfth, twelfth};
}

void cable_mass_force(const MassSection& s, const Vec3& a1, const Vec3& a2, const Vec3& load, Vec6& f) {
  const double m = cable_mass(s).shared;
  const Vec3 half = (0.5 * s.length) * load;
  f.head<3>() = m * (5 * a1 + a2) - half;
  f.tail<3>() = m * (a1 + 5 * a2) - half;
}

double cable_kinetic_energy(const MassSection& s, const Vec3& v1, const Vec3& v2) {
  return s.mass_per_length * s.length / 24 * (5 * v1.squaredNorm() + 2 * v1.dot(v2) + 5 * v2.squaredNorm());
}

}  // namespace hawser
