// Buoyancy, drag and added mass of the water on the nodes of a cable or a beam, with tangents and the
// potential of buoyancy; and the same for balls (buoys, weights). The formula at the Gauss points is in
// morison_points.hpp; cables that are wholly under water are computed in morison_submerged.cpp instead.
#include "hawser/kernels/line_water.hpp"

#include "morison_points.hpp"

namespace hawser {
namespace {

using namespace morison_points;

template <int n>
void put_water(const Water& first, const Water& second, Motion<n>& m) {
  const Water* w[2] = {&first, &second};
  for (int i = 0; i < 2; ++i) {
    m.u[i] = load(w[i]->velocity);
    m.by_height[i] = load(w[i]->by_height);
    m.a[i] = load(w[i]->acceleration);
    m.surface[i] = w[i]->surface;
  }
}

Motion<2> cable_motion(const CableInWater& e) {
  Motion<2> m;
  m.X[0] = load(e.x1);
  m.X[1] = load(e.x2);
  m.V[0] = load(e.v1);
  m.V[1] = load(e.v2);
  m.A[0] = load(e.a1);
  m.A[1] = load(e.a2);
  put_water(e.water1, e.water2, m);
  return m;
}

CableInWater in_place(const WaterEnds& e) {
  const MassEnds& r = e.motion;
  return {e.x1, e.x2, r.v1, r.v2, r.a1, r.a2, e.water1, e.water2};
}

// Motion with the matrices from rotations to the tangents' motion, as in beam_mass_tangent.
struct BeamMotion {
  Motion<4> m;
  Mat Q[2];
  Row c, w[2], rate[2];  // node axis along the line, angular velocity, w x c
  Row g[2];              // acceleration of the tangent in node axes; unused if given
  bool given;
};

void beam_motion(const WaterSection& s, const WaterEnds& e, BeamMotion& o) {
  const MassEnds& r = e.motion;
  const double L = s.length;
  o.c = load(Vec3(Vec3::UnitX()));
  o.Q[0] = rotation(r.q1);
  o.Q[1] = rotation(r.q2);
  o.w[0] = load(r.w1);
  o.w[1] = load(r.w2);
  o.given = r.directors1 != nullptr;
  const Row alpha[2] = {load(r.alpha1), load(r.alpha2)};
  const Mat3* directors[2] = {r.directors1, r.directors2};
  o.m.X[0] = load(e.x1);
  o.m.X[2] = load(e.x2);
  o.m.V[0] = load(r.v1);
  o.m.V[2] = load(r.v2);
  o.m.A[0] = load(r.a1);
  o.m.A[2] = load(r.a2);
  for (int i = 0; i < 2; ++i) {
    o.rate[i] = cross(o.w[i], o.c);
    o.m.X[2 * i + 1] = L * times(o.Q[i], o.c);
    o.m.V[2 * i + 1] = L * times(o.Q[i], o.rate[i]);
    if (o.given) {
      const Vec3 a = directors[i]->col(0);
      o.m.A[2 * i + 1] = L * load(a);
    } else {
      o.g[i] = cross(alpha[i], o.c) + cross(o.w[i], o.rate[i]);
      o.m.A[2 * i + 1] = L * times(o.Q[i], o.g[i]);
    }
  }
  put_water(e.water1, e.water2, o.m);
}

void put_beam_force(const WaterSection& s, const BeamMotion& o, const Row* F, Vec12& f) {
  for (int i = 0; i < 2; ++i) {
    const Row m = s.length * cross(o.c, left(F[2 * i + 1], o.Q[i]));
    for (int k = 0; k < 3; ++k) {
      f[6 * i + k] = F[2 * i][k];
      f[6 * i + 3 + k] = m[k];
    }
  }
}

}  // namespace

void cable_water_force(const WaterSection& s, const CableInWater& e, Vec6& f) {
  Forces<2> o;
  evaluate<false, false>(s, cable_motion(e), false, o);
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 3; ++k) f[3 * i + k] = o.f[i][k];
}

void cable_water_tangent(const WaterSection& s, const CableInWater& e, bool convex, Vec6& f, Mat6& K, Mat6& C,
                         Mat6& M) {
  Forces<2> o;
  evaluate<false, true>(s, cable_motion(e), convex, o);
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 3; ++k) f[3 * i + k] = o.f[i][k];
    for (int j = 0; j < 2; ++j) {
      put(K, i, j, o.K[i][j]);
      put(C, i, j, o.C[i][j]);
      put(M, i, j, o.M[i][j]);
    }
  }
}

void beam_water_force(const WaterSection& s, const WaterEnds& e, Vec12& f) {
  BeamMotion b;
  beam_motion(s, e, b);
  Forces<4> o;
  evaluate<true, false>(s, b.m, false, o);
  put_beam_force(s, b, o.f, f);
}

void beam_water_tangent(const WaterSection& s, const WaterEnds& e, bool convex, Vec12& f, Mat12& K, Mat12& C,
                        Mat12& M) {
  BeamMotion b;
  beam_motion(s, e, b);
  Forces<4> o;
  evaluate<true, true>(s, b.m, convex, o);
  put_beam_force(s, b, o.f, f);
  // Columns: the tangents' position, velocity and acceleration by theta, w and alpha.
  Mat A[2], TV[2], TA[2], W[2], row[2];
  for (int i = 0; i < 2; ++i) {
    const Mat Q = s.length * b.Q[i];
    A[i] = times_hat(Q, -b.c);
    TV[i] = times_hat(Q, -b.rate[i]);
    TA[i] = times_hat(Q, b.given ? -e.motion.director_weight * b.rate[i] : -b.g[i]);
    W[i] = b.given ? Mat{} : times_hat(Q, -b.rate[i]) - times_hat(times_hat(Q, b.w[i]), b.c);
    row[i] = s.length * hat_times(b.c, transpose(b.Q[i]));
  }
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 2; ++k) {
      const int x = 2 * k;
      const int t = x + 1;
      Mat Kx = o.K[i][x];
      Mat Cx = o.C[i][x];
      Mat Mx = o.M[i][x];
      Mat Kt = o.K[i][t] * A[k] + o.C[i][t] * TV[k] + o.M[i][t] * TA[k];
      Mat Ct = o.C[i][t] * A[k];
      Mat Mt = o.M[i][t] * A[k];
      if (!b.given) Ct += o.M[i][t] * W[k];
      if (i % 2) {
        const Mat& r = row[i / 2];
        Kx = r * Kx;
        Cx = r * Cx;
        Mx = r * Mx;
        Kt = r * Kt;
        Ct = r * Ct;
        Mt = r * Mt;
        if (i == t) Kt += s.length * hat_times(b.c, hat(left(o.f[i], b.Q[k])));
      }
      put(K, i, x, Kx);
      put(C, i, x, Cx);
      put(M, i, x, Mx);
      put(K, i, t, Kt);
      put(C, i, t, Ct);
      put(M, i, t, Mt);
    }
}

namespace {

template <bool beam, int n>
double potential(const WaterSection& s, const Motion<n>& m) {
  using R = Rule<beam>;
  const Row chord = m.X[n - (beam ? 2 : 1)] - m.X[0];
  const double l = std::sqrt(dot(chord, chord));
  const double rise_over_axis = m.surface[1] - m.surface[0] - chord[2];
  const Band<beam> band(s, l > 0 ? chord[2] / l : 0);
  double sum = 0;
  for (int g = 0; g < R::points; ++g) {
    const double z = R::at[g];
    double N[n];
    double h = (1 - z) * m.surface[0] + z * m.surface[1];
    R::shape(z, N);
    for (int j = 0; j < n; ++j) h -= N[j] * m.X[j][2];
    const PointInterval<beam> piece(g, h, rise_over_axis);
    sum += R::weight[g] * piece_wetting(piece.h1, piece.h2, band.b).integral;
  }
  return s.buoyancy * s.length * sum;
}

}  // namespace

Vec3 line_drag(const WaterSection& s, const Vec3& u, const Vec3& t) {
  return vec(morison_formula::Drag<double, Row>(load(u), load(t), s.drag_normal, s.drag_axial).force());
}

double water_potential(const WaterSection& s, const WaterEnds& e, bool beam) {
  if (!beam) return potential<false>(s, cable_motion(in_place(e)));
  BeamMotion b;
  beam_motion(s, e, b);
  return potential<true>(s, b.m);
}

namespace {

template <bool beam, int n>
WaterForce flow_force(const WaterSection& s, Motion<n> m, double still_water_level) {
  Forces<n> o;
  if (m.surface[0] == still_water_level && m.surface[1] == still_water_level) {
    evaluate<beam, false, Part::flow>(s, m, false, o);
  } else {
    Forces<n> floating;
    evaluate<beam, false>(s, m, false, o);
    m.surface[0] = m.surface[1] = still_water_level;
    evaluate<beam, false, Part::buoyancy>(s, m, false, floating);
    for (int j = 0; j < n; ++j) o.f[j] -= floating.f[j];
  }
  WaterForce out;
  for (int j = 0; j < 4; ++j) out.force[j] = Vec3::Zero();
  for (int j = 0; j < n; ++j) out.force[beam ? j : 2 * j] = -vec(o.f[j]);
  return out;
}

}  // namespace

WaterForce flow_force_on_line(const WaterSection& s, const WaterEnds& e, bool beam,
                              double still_water_level) {
  if (!beam) return flow_force<false>(s, cable_motion(in_place(e)), still_water_level);
  BeamMotion b;
  beam_motion(s, e, b);
  return flow_force<true>(s, b.m, still_water_level);
}

Vec3 straight_flow_force(const WaterSection& s, const CableInWater& e, bool beam) {
  const Motion<2> c = cable_motion(e);
  if (!beam) {
    Forces<2> o;
    evaluate<false, false, Part::flow>(s, c, false, o);
    return -vec(o.f[0] + o.f[1]);
  }
  // Hermite's cubics are linear if the tangents equal the chord and change with it.
  Motion<4> m;
  for (int i = 0; i < 2; ++i) {
    m.X[2 * i] = c.X[i];
    m.V[2 * i] = c.V[i];
    m.A[2 * i] = c.A[i];
    m.X[2 * i + 1] = c.X[1] - c.X[0];
    m.V[2 * i + 1] = c.V[1] - c.V[0];
    m.A[2 * i + 1] = c.A[1] - c.A[0];
  }
  put_water(e.water1, e.water2, m);
  Forces<4> o;
  evaluate<true, false, Part::flow>(s, m, false, o);
  return -vec(o.f[0] + o.f[2]);
}

void ball_water(const WaterBall& b, const Vec3& x, const Vec3& v, const Vec3& a, const Water& water, Vec3& f,
                Mat3* K, Mat3* C, Mat3* M) {
  const Wetting wet = ball_wetting((water.surface - x.z()) / b.radius);
  const Vec3 u = water.velocity - v;
  const double speed = u.norm();
  const Vec3 dynamic_force =
      b.added_mass * (a - water.acceleration) - b.displaced_mass * water.acceleration - b.drag * speed * u;
  f = wet.fraction * (dynamic_force - b.buoyancy * Vec3::UnitZ());
  if (!K) return;
  Mat3 D = speed * Mat3::Identity();
  if (speed > 0) D += u * u.transpose() / speed;
  D *= wet.fraction * b.drag;
  *K = -D * water.by_height * Vec3::UnitZ().transpose();
  K->col(2) -= wet.slope / b.radius * (dynamic_force - b.buoyancy * Vec3::UnitZ());
  *C = D;
  *M = wet.fraction * b.added_mass * Mat3::Identity();
}

double ball_potential(const WaterBall& b, const Vec3& x, const Water& water) {
  return b.buoyancy * b.radius * ball_wetting((water.surface - x.z()) / b.radius).integral;
}

}  // namespace hawser
