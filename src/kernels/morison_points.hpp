// Buoyancy, Morison drag and added mass at the Gauss points of an element with all derivatives, in
// generalised coordinates: (x1, x2) of a cable, (x1, L t1, x2, L t2) of a beam, with positions x of its
// nodes, unit tangents t there and its unstretched length L. Residual and derivatives are stated in
// docs/theory/water.md#tangent. Internal to the kernel.
#pragma once

#include <cmath>

#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/wetting.hpp"
#include "hawser/math/gauss_points.hpp"
#include "hawser/math/wide3.hpp"
#include "morison_formula.hpp"

namespace hawser::morison_points {

using namespace wide;

template <bool beam>
struct Rule;
template <>
struct Rule<false> {
  static constexpr int points = 2, shapes = 2;
  static constexpr auto& at = GaussPoints<2>::unit;
  static constexpr auto& weight = GaussPoints<2>::weight;
  static constexpr double edge[3] = {0, 0.5, 1};  // limits of the pieces that the points represent
  static void shape(double s, double* N) {
    N[0] = 1 - s;
    N[1] = s;
  }
};
template <>
struct Rule<true> {
  static constexpr int points = 3, shapes = 4;
  static constexpr auto& at = GaussPoints<3>::unit;
  static constexpr auto& weight = GaussPoints<3>::weight;
  static constexpr double edge[4] = {0, 5.0 / 18, 13.0 / 18, 1};
  static void shape(double s, double* N) {
    const double r = 1 - s;
    N[0] = r * r * (1 + 2 * s);
    N[1] = s * r * r;
    N[2] = s * s * (3 - 2 * s);
    N[3] = -s * s * r;
  }
};

// Generalised positions X [m], velocities V [m/s], accelerations A [m/s²]; of the water at both nodes:
// velocity u [m/s], du/dz `by_height` [1/s], acceleration a [m/s²], height of the surface [m].
template <int n>
struct Motion {
  Row X[n], V[n], A[n];
  Row u[2], by_height[2], a[2];
  double surface[2];
};

template <int n>
struct Forces {
  Row f[n];     // residual, N
  Mat K[n][n];  // derivatives of f by X, V, A
  Mat C[n][n];
  Mat M[n][n];
};

// Half the height over which a section gets wet, b. For a beam that of a circle perpendicular to the axis, b²
// = R² (1 - t_z²) + delta² t_z², where a small delta keeps b from 0 and the derivatives finite for a vertical
// axis. For a cable b = R at any inclination. With the inclination, buoyancy would have a negative stiffness
// against tilting in an element shorter than its diameter, which a slack cable cannot resist. With b = R the
// potential of a cable is convex.
template <bool beam>
struct Band {
  static constexpr double kSharp = 1e-3;  // delta as a fraction of the length
  double kappa = 0, b = 1;                // m², d(b²)/d(t_z²); m, b
  Band(const WaterSection& s, double tz) {
    const double delta = kSharp * s.length;
    if (beam) kappa = delta * delta - s.radius * s.radius;
    b = std::sqrt(s.radius * s.radius + kappa * tz * tz);
  }
};

// Piece of the axis that a Gauss point represents: straight, with the slope of the chord, through the point.
// The pieces make up the element, so that the wet part of a straight one is exact.
template <bool beam>
struct PointInterval {
  double from = 0, to = 0;  // of the element's length, from the point
  double h1 = 0, h2 = 0;    // m, height of the surface above its ends
  PointInterval() = default;
  // h: above the point; rise_over_axis: by which that grows from one end of the element to the other
  PointInterval(int g, double h, double rise_over_axis)
      : from(Rule<beam>::edge[g] - Rule<beam>::at[g]),
        to(Rule<beam>::edge[g + 1] - Rule<beam>::at[g]),
        h1(h + from * rise_over_axis),
        h2(h + to * rise_over_axis) {}
};

// First derivative of t_z²/2 by the chord, with e upwards and the chord's length l = 1/`inverse`:
//   t_z (e - t_z t)/l.
inline Row by_chord_of(Row t, double inverse) { return (inverse * t[2]) * (unit(2) - t[2] * t); }
// Second derivative: (e e' - 2 t_z (e t' + t e') - t_z² I + 4 t_z² t t')/l²
//   = ((e - k) e' + (2 t_z k - 2 t_z e) t' - t_z² I)/l² with k = 2 t_z t.
inline Mat by_chord2_of(Row t, double inverse) {
  const Row up = unit(2);
  const double tz = t[2];
  const Row k = 2 * tz * t;
  const Mat m = outer(up - k, up) + outer(2 * tz * k - 2 * tz * up, t) - identity(tz * tz);
  return (inverse * inverse) * m;
}

// Quantities that all points of an element share. Its first and last positions are X[0] and X[last].
template <bool beam>
struct Chord {
  static constexpr int n = Rule<beam>::shapes;
  static constexpr int last = n - (beam ? 2 : 1);
  double inverse;         // 1/m, of its length l; 0 where that is 0
  Row t;                  // unit vector
  Mat projector;          // P = I - t t'
  double rise_over_axis;  // m, by which the surface's height above the axis grows from one end to the other
  Band<beam> band;
  Row db[n] = {};  // derivatives of b by X

  // rise: of the surface from one end to the other, m.
  Chord(const WaterSection& s, Row chord, double rise)
      : inverse(inverse_length(chord)),
        t(inverse * chord),
        projector(identity(1) - outer(t, t)),
        rise_over_axis(rise - chord[2]),
        band(s, t[2]) {
    if constexpr (beam) {
      db[last] = (band.kappa / band.b) * by_chord_of(t, inverse);
      db[0] = -db[last];
    }
  }

 private:
  static double inverse_length(Row chord) {
    const double l = std::sqrt(dot(chord, chord));
    return l > 0 ? 1 / l : 0;
  }
};

// A Gauss point and the wet part of its piece.
template <bool beam>
struct Point {
  static constexpr int n = Rule<beam>::shapes;
  static constexpr int last = Chord<beam>::last;
  double z;  // of the element's length
  double w;  // m, that it represents
  double N[n];
  PointInterval<beam> piece;
  PieceWetting wet;
  double decrease1[n], decrease2[n];  // by which h1 and h2 decrease with the heights of X
  Row by1[n], by2[n], by_b[n];        // derivatives of dU/dh1, dU/dh2, dU/db by X: differentiate()

  Point(int g, const WaterSection& s, const Motion<n>& m, const Chord<beam>& c)
      : z(Rule<beam>::at[g]), w(Rule<beam>::weight[g] * s.length) {
    Rule<beam>::shape(z, N);
    double h = (1 - z) * m.surface[0] + z * m.surface[1];
    for (int j = 0; j < n; ++j) h -= N[j] * m.X[j][2];
    piece = PointInterval<beam>(g, h, c.rise_over_axis);
    wet = piece_wetting(piece.h1, piece.h2, c.band.b);
    for (int j = 0; j < n; ++j) decrease1[j] = decrease2[j] = N[j];
    decrease1[0] -= piece.from;
    decrease1[last] += piece.from;
    decrease2[0] -= piece.to;
    decrease2[last] += piece.to;
  }
  double fraction() const { return wet.by_h1 + wet.by_h2; }  // F
  bool partly() const { return wet.slope11 > 0 || wet.slope22 > 0; }

  // Where it is partly wet. Derivatives by b are by Euler's theorem: U is homogeneous in h1, h2 and b.
  void differentiate(const Chord<beam>& c) {
    const double b = c.band.b;
    const double b1 = -(piece.h1 * wet.slope11 + piece.h2 * wet.slope12) / b;
    const double b2 = -(piece.h1 * wet.slope12 + piece.h2 * wet.slope22) / b;
    const double bb = -(piece.h1 * b1 + piece.h2 * b2) / b;
    for (int k = 0; k < n; ++k) {
      by1[k] = -(wet.slope11 * decrease1[k] + wet.slope12 * decrease2[k]) * unit(2) + b1 * c.db[k];
      by2[k] = -(wet.slope12 * decrease1[k] + wet.slope22 * decrease2[k]) * unit(2) + b2 * c.db[k];
      by_b[k] = -(b1 * decrease1[k] + b2 * decrease2[k]) * unit(2) + bb * c.db[k];
    }
  }
};

// f_j = B dU/dX_j and K_jk = B d²U/dX_j dX_k, B = rho g A w, with the potential U(h1, h2, b) of the piece
// (PieceWetting::integral).
template <bool beam, bool tangent>
inline void buoyancy_at(const WaterSection& s, const Chord<beam>& c, const Point<beam>& p, bool convex,
                        Forces<Rule<beam>::shapes>& out) {
  constexpr int n = Chord<beam>::n;
  constexpr int last = Chord<beam>::last;
  const double B = p.w * s.buoyancy;
  for (int j = 0; j < n; ++j)
    out.f[j][2] -= B * (p.wet.by_h1 * p.decrease1[j] + p.wet.by_h2 * p.decrease2[j]);
  if (!p.partly()) return;
  // B dU/db, by Euler's theorem.
  const double G = B * (p.wet.integral - p.piece.h1 * p.wet.by_h1 - p.piece.h2 * p.wet.by_h2) / c.band.b;
  out.f[0] += G * c.db[0];
  out.f[last] += G * c.db[last];
  if constexpr (tangent) {
    for (int k = 0; k < n; ++k) {
      for (int j = 0; j < n; ++j)
        out.K[j][k].r[2] -= (B * p.decrease1[j]) * p.by1[k] + (B * p.decrease2[j]) * p.by2[k];
      if constexpr (beam) {
        const Mat by_band = outer(B * c.db[last], p.by_b[k]);
        out.K[last][k] += by_band;
        out.K[0][k] -= by_band;
      }
    }
    // G d²b/dc² with d²b/dc² = (kappa d²(t_z²/2)/dc² - db/dc (db/dc)')/b, by b db/dc = kappa d(t_z²/2)/dc.
    if (beam && !convex) {  // may be negative for short elements, so not convex
      const Mat k2 =
          (G / c.band.b) * (c.band.kappa * by_chord2_of(c.t, c.inverse) - outer(c.db[last], c.db[last]));
      out.K[0][0] += k2;
      out.K[last][last] += k2;
      out.K[0][last] -= k2;
      out.K[last][0] -= k2;
    }
  }
}

// Forces of the flow at a point.
template <int n>
struct FlowForces {
  morison_formula::Drag<double, Row> drag;
  double wF;       // m, wet length that the point represents
  Row y[n], q[n];  // m/s², acceleration relative to the water that belongs to a shape; N/m, residual
};

// f_j = w F q_j, q_j = (m_n P + m_t t t') y_j - N_j (drag + m_d a_w), with
//   y_j = N_j (sum N_k a_k - a_w) of a beam, consistent with its mass,
//   y_j = N_j (sum N_k a_k + a_j)/2 - N_j a_w of a cable, whose mass is half lumped.
template <bool beam>
inline FlowForces<Rule<beam>::shapes> flow_at(const WaterSection& s, const Motion<Rule<beam>::shapes>& m,
                                              const Chord<beam>& c, const Point<beam>& p,
                                              Forces<Rule<beam>::shapes>& out) {
  constexpr int n = Chord<beam>::n;
  Row u = (1 - p.z) * m.u[0] + p.z * m.u[1];
  for (int j = 0; j < n; ++j) u -= p.N[j] * m.V[j];
  const Row aw = (1 - p.z) * m.a[0] + p.z * m.a[1];
  FlowForces<n> o{{u, c.t, s.drag_normal, s.drag_axial}, p.w * p.fraction(), {}, {}};
  const Row drag_and_pressure = o.drag.force() + s.displaced_mass * aw;  // pressure of the waves, m_d a_w
  const double ma = s.added_axial - s.added_normal;
  Row point{};
  for (int k = 0; k < n; ++k) point += p.N[k] * m.A[k];
  for (int j = 0; j < n; ++j) {
    if constexpr (beam)
      o.y[j] = p.N[j] * (point - aw);
    else
      o.y[j] = (0.5 * p.N[j]) * (point + m.A[j]) - p.N[j] * aw;
    o.q[j] = morison_formula::added_mass(s.added_normal, ma, c.t, o.y[j]) - p.N[j] * drag_and_pressure;
    out.f[j] += o.wF * o.q[j];
  }
  return o;
}

// Sums over the points of which blocks are made.
template <int n>
struct Sums {
  double masses[n][n] = {};  // m, that the added mass of a metre is multiplied by
  Mat by_chord[n] = {};      // derivative by X[last] (minus that by X[0]) through the chord
  Row by_z[n][2] = {};       // through the current
};

// Derivatives of flow_at by velocity, C_jk = w F N_j N_k S, by acceleration, by the chord,
//   w F/l (-N_j T + (m_t - m_n) (t (P y_j)' + (t.y_j) P)),
// by heights through the current, -w F N_j (1 - z, z) S du_w/dz, and through the wet fraction, w q_j
// (dF/dX_k)'.
template <bool beam>
inline void flow_tangent(const WaterSection& s, const Motion<Rule<beam>::shapes>& m, const Chord<beam>& c,
                         const Point<beam>& p, const FlowForces<Rule<beam>::shapes>& at_point, bool convex,
                         Sums<Rule<beam>::shapes>& sums, Forces<Rule<beam>::shapes>& out) {
  constexpr int n = Chord<beam>::n;
  const Row t = c.t;
  const double wF = at_point.wF;
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) {
      const double consistent = p.N[j] * p.N[k];
      const double half_lumped = 0.5 * p.N[j] * (p.N[k] + (j == k ? 1 : 0));
      sums.masses[j][k] += wF * (beam ? consistent : half_lumped);
    }
  const auto& drag = at_point.drag;
  const Mat S = outer(drag.over_speed * drag.across, drag.across) + identity(drag.normal) +
                outer(drag.lengthwise() * t, t);
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) out.C[j][k] += (wF * p.N[j] * p.N[k]) * S;
  if (convex) return;  // the derivatives below are not symmetric and may have negative stiffness
  const double ma = s.added_axial - s.added_normal;
  const Mat T = outer(drag.by_across(), drag.across) + drag.by_turn() * c.projector;
  const Row d[2] = {times(S, m.by_height[0]), times(S, m.by_height[1])};
  for (int j = 0; j < n; ++j) {
    const double ty = dot(t, at_point.y[j]);
    const Row Py = at_point.y[j] - ty * t;
    sums.by_chord[j] +=
        (-wF * p.N[j] * c.inverse) * T + (wF * c.inverse * ma) * (outer(t, Py) + ty * c.projector);
    sums.by_z[j][0] -= (wF * p.N[j] * (1 - p.z)) * d[0];
    sums.by_z[j][1] -= (wF * p.N[j] * p.z) * d[1];
  }
  if (p.partly())
    for (int k = 0; k < n; ++k) {
      const Row slope = p.w * (p.by1[k] + p.by2[k]);
      for (int j = 0; j < n; ++j) out.K[j][k] += outer(at_point.q[j], slope);
    }
}

enum class Part { all, buoyancy, flow };

template <bool beam, bool tangent, Part part = Part::all>
void evaluate(const WaterSection& s, const Motion<Rule<beam>::shapes>& m, bool convex,
              Forces<Rule<beam>::shapes>& out) {
  constexpr int n = Chord<beam>::n;
  constexpr int last = Chord<beam>::last;
  const Chord<beam> chord(s, m.X[last] - m.X[0], m.surface[1] - m.surface[0]);
  for (int j = 0; j < n; ++j) out.f[j] = Row{};
  if constexpr (tangent)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        out.K[j][k] = Mat{};
        out.C[j][k] = Mat{};
      }
  Sums<n> sums;
  for (int g = 0; g < Rule<beam>::points; ++g) {
    Point<beam> p(g, s, m, chord);
    if (!(p.fraction() > 0)) continue;
    if (tangent && p.partly()) p.differentiate(chord);
    if constexpr (part != Part::flow) buoyancy_at<beam, tangent>(s, chord, p, convex, out);
    if constexpr (part != Part::buoyancy) {
      const FlowForces<n> at_point = flow_at<beam>(s, m, chord, p, out);
      if constexpr (tangent) flow_tangent<beam>(s, m, chord, p, at_point, convex, sums, out);
    }
  }
  if constexpr (tangent) {
    const double ma = s.added_axial - s.added_normal;
    const Mat added = identity(s.added_normal) + outer(ma * chord.t, chord.t);
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) out.M[j][k] = sums.masses[j][k] * added;
      out.K[j][last] += sums.by_chord[j];
      out.K[j][0] -= sums.by_chord[j];
      for (int r = 0; r < 3; ++r) {
        out.K[j][0].r[r][2] += sums.by_z[j][0][r];
        out.K[j][last].r[r][2] += sums.by_z[j][1][r];
      }
    }
  }
}

}  // namespace hawser::morison_points
