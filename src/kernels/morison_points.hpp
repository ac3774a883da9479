// Buoyancy, Morison drag and added mass at the Gauss points of an element with all derivatives, in
// generalised coordinates: (x1, x2) of a cable, (x1, L t1, x2, L t2) of a beam, with positions x of its
// nodes, unit tangents t there and its unstretched length L. Internal to the kernel.
#pragma once

#include <cmath>

#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/wetting.hpp"
#include "hawser/math/wide3.hpp"
#include "morison_formula.hpp"

namespace hawser::morison_points {

using namespace wide;

template <bool beam>
struct Rule;
template <>
struct Rule<false> {
  static constexpr int points = 2, shapes = 2;
  static constexpr double at[2] = {0.21132486540518711775, 0.78867513459481288225};
  static constexpr double weight[2] = {0.5, 0.5};
  static constexpr double edge[3] = {0, 0.5, 1};  // limits of the pieces that the points represent
  static void shape(double s, double* N) {
    N[0] = 1 - s;
    N[1] = s;
  }
};
template <>
struct Rule<true> {
  static constexpr int points = 3, shapes = 4;
  static constexpr double at[3] = {0.11270166537925831148, 0.5, 0.88729833462074168852};
  static constexpr double weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  static constexpr double edge[4] = {0, 5.0 / 18, 13.0 / 18, 1};
  static void shape(double s, double* N) {
    const double r = 1 - s;
    N[0] = r * r * (1 + 2 * s);
    N[1] = s * r * r;
    N[2] = s * s * (3 - 2 * s);
    N[3] = -s * s * r;
  }
};

// Generalised positions, velocities, accelerations and the nodes' water.
template <int n>
struct Motion {
  Row X[n], V[n], A[n];
  Row u[2], by_height[2], a[2];
  double surface[2];
};

template <int n>
struct Forces {
  Row f[n];     // residual
  Mat K[n][n];  // by X, V, A
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
  double by_lean = 0, b = 1;              // m², derivative of b² by t_z²; m, b
  Band(const WaterSection& s, double lean) {
    const double delta = kSharp * s.length;
    if (beam) by_lean = delta * delta - s.radius * s.radius;
    b = std::sqrt(s.radius * s.radius + by_lean * lean * lean);
  }
};

// Piece of the axis that a Gauss point represents: straight, with the slope of the chord, through the point.
// The pieces make up the element, so that the wet part of a straight one is exact.
template <bool beam>
struct Piece {
  double from, to;  // from the point, as fractions of the element's length
  double h1, h2;    // m, height of the surface above its ends
  // h: height of the surface above the point; fall: its increase from one end of the element to the other
  Piece(int g, double h, double fall)
      : from(Rule<beam>::edge[g] - Rule<beam>::at[g]),
        to(Rule<beam>::edge[g + 1] - Rule<beam>::at[g]),
        h1(h + from * fall),
        h2(h + to * fall) {}
};

// Derivatives of t_z²/2 by the chord.
inline Row by_chord_of(Row t, double inverse) { return (inverse * t[2]) * (unit(2) - t[2] * t); }
inline Mat by_chord2_of(Row t, double inverse) {
  const Row up = unit(2);
  const double lean = t[2];
  const Row k = 2 * lean * t;
  const Mat m = outer(up - k, up) + outer(2 * lean * k - 2 * lean * up, t) - identity(lean * lean);
  return (inverse * inverse) * m;
}

enum class Part { all, buoyancy, flow };

template <bool beam, bool tangent, Part part = Part::all>
void evaluate(const WaterSection& s, const Motion<Rule<beam>::shapes>& m, bool convex,
              Forces<Rule<beam>::shapes>& out) {
  using R = Rule<beam>;
  constexpr int n = R::shapes, end = n - (beam ? 2 : 1);  // coordinates of the second node's position
  const Row zero{};
  for (int j = 0; j < n; ++j) out.f[j] = zero;
  const Row chord = m.X[end] - m.X[0];
  const double l = std::sqrt(dot(chord, chord)), inverse = l > 0 ? 1 / l : 0;
  const Row t = inverse * chord;
  const double ma = s.added_axial - s.added_normal;
  const double fall = m.surface[1] - m.surface[0] - chord[2];
  const Band<beam> band(s, t[2]);
  Row db[n] = {};  // derivative of the band
  if constexpr (beam) {
    db[end] = (band.by_lean / band.b) * by_chord_of(t, inverse);
    db[0] = -db[end];
  }
  // Sums from which the blocks are formed.
  double masses[n][n] = {};
  Mat by_chord[n];  // derivative by x2 (minus that by x1) through the chord
  Row by_z[n][2];   // through the gradient of the current
  if constexpr (tangent)
    for (int j = 0; j < n; ++j) {
      by_chord[j] = Mat{};
      by_z[j][0] = by_z[j][1] = zero;
      for (int k = 0; k < n; ++k) {
        out.K[j][k] = Mat{};
        out.C[j][k] = Mat{};
      }
    }
  const Mat P = identity(1) - outer(t, t);

  for (int g = 0; g < R::points; ++g) {
    const double z = R::at[g];
    double N[n];
    R::shape(z, N);
    const double w = R::weight[g] * s.length;
    double h = (1 - z) * m.surface[0] + z * m.surface[1];
    for (int j = 0; j < n; ++j) h -= N[j] * m.X[j][2];
    const Piece<beam> piece(g, h, fall);
    const PieceWetting wet = piece_wetting(piece.h1, piece.h2, band.b);
    const double share = wet.share1 + wet.share2;
    if (!(share > 0)) continue;
    const bool partly = wet.slope11 > 0 || wet.slope22 > 0;
    double from[n], to[n];  // minus the derivatives of h1 and h2 by heights
    for (int j = 0; j < n; ++j) from[j] = to[j] = N[j];
    from[0] -= piece.from;
    from[end] += piece.from;
    to[0] -= piece.to;
    to[end] += piece.to;
    // Derivatives of h1, h2 and b times the second derivatives of the integral.
    Row by1[n], by2[n], by_b[n];
    if (tangent && partly) {
      const double b1 = -(piece.h1 * wet.slope11 + piece.h2 * wet.slope12) / band.b;
      const double b2 = -(piece.h1 * wet.slope12 + piece.h2 * wet.slope22) / band.b;
      const double bb = -(piece.h1 * b1 + piece.h2 * b2) / band.b;
      for (int k = 0; k < n; ++k) {
        by1[k] = -(wet.slope11 * from[k] + wet.slope12 * to[k]) * unit(2) + b1 * db[k];
        by2[k] = -(wet.slope12 * from[k] + wet.slope22 * to[k]) * unit(2) + b2 * db[k];
        by_b[k] = -(b1 * from[k] + b2 * to[k]) * unit(2) + bb * db[k];
      }
    }
    if constexpr (part != Part::flow) {
      const double B = w * s.buoyancy;
      for (int j = 0; j < n; ++j) out.f[j][2] -= B * (wet.share1 * from[j] + wet.share2 * to[j]);
      if (partly) {
        // By Euler's theorem on homogeneous functions.
        const double G = B * (wet.integral - piece.h1 * wet.share1 - piece.h2 * wet.share2) / band.b;
        out.f[0] += G * db[0];
        out.f[end] += G * db[end];
        if constexpr (tangent) {
          for (int k = 0; k < n; ++k) {
            for (int j = 0; j < n; ++j) out.K[j][k].r[2] -= (B * from[j]) * by1[k] + (B * to[j]) * by2[k];
            if constexpr (beam) {
              const Mat by_band = outer(B * db[end], by_b[k]);
              out.K[end][k] += by_band;
              out.K[0][k] -= by_band;
            }
          }
          if (beam && !convex) {  // may be negative for short elements, so not convex
            const Mat k2 = (G / band.b) * (band.by_lean * by_chord2_of(t, inverse) - outer(db[end], db[end]));
            out.K[0][0] += k2;
            out.K[end][end] += k2;
            out.K[0][end] -= k2;
            out.K[end][0] -= k2;
          }
        }
      }
    }
    if constexpr (part == Part::buoyancy) continue;

    Row u = (1 - z) * m.u[0] + z * m.u[1];
    for (int j = 0; j < n; ++j) u -= N[j] * m.V[j];
    const Row aw = (1 - z) * m.a[0] + z * m.a[1];
    const morison_formula::Drag<double, Row> drag(u, t, s.drag_normal, s.drag_axial);
    const double wF = w * share;
    const Row flow = drag.force() + s.displaced_mass * aw;  // with Froude-Krylov, N/m of wet length
    // Accelerations for each shape function: consistent for a beam; for a cable the mean of lumped and
    // consistent, as for its own mass.
    double at[n][n];
    Row y[n], q[n];
    Row point{};
    for (int k = 0; k < n; ++k) point += N[k] * m.A[k];
    for (int j = 0; j < n; ++j) {
      if constexpr (beam)
        y[j] = N[j] * (point - aw);
      else
        y[j] = (0.5 * N[j]) * (point + m.A[j]) - N[j] * aw;
      q[j] =
          morison_formula::added_mass(s.added_normal, ma, t, y[j]) - N[j] * flow;  // residual per wet length
      out.f[j] += wF * q[j];
      if constexpr (tangent)
        for (int k = 0; k < n; ++k) {
          at[j][k] = beam ? N[j] * N[k] : 0.5 * N[j] * (N[k] + (j == k ? 1 : 0));
          masses[j][k] += wF * at[j][k];
        }
    }
    if constexpr (tangent) {
      const Mat D = outer(drag.over_speed * drag.across, drag.across) + identity(drag.normal) +
                    outer(drag.lengthwise() * t, t);
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) out.C[j][k] += (wF * N[j] * N[k]) * D;
      if (!convex) {
        const Mat T = outer(drag.by_across(), drag.across) + drag.by_turn() * P;
        const Row d[2] = {times(D, m.by_height[0]), times(D, m.by_height[1])};
        for (int j = 0; j < n; ++j) {
          const double ty = dot(t, y[j]);
          const Row across = y[j] - ty * t;
          by_chord[j] += (-wF * N[j] * inverse) * T + (wF * inverse * ma) * (outer(t, across) + ty * P);
          by_z[j][0] -= (wF * N[j] * (1 - z)) * d[0];
          by_z[j][1] -= (wF * N[j] * z) * d[1];
        }
        if (partly)
          for (int k = 0; k < n; ++k) {
            const Row slope = w * (by1[k] + by2[k]);
            for (int j = 0; j < n; ++j) out.K[j][k] += outer(q[j], slope);
          }
      }
    }
  }
  if constexpr (tangent) {
    const Mat added = identity(s.added_normal) + outer(ma * t, t);
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) out.M[j][k] = masses[j][k] * added;
      out.K[j][end] += by_chord[j];
      out.K[j][0] -= by_chord[j];
      for (int r = 0; r < 3; ++r) {
        out.K[j][0].r[r][2] += by_z[j][0][r];
        out.K[j][end].r[r][2] += by_z[j][1][r];
      }
    }
  }
}

}  // namespace hawser::morison_points
