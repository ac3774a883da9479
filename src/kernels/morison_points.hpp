// Buoyancy, Morison drag and added mass at the Gauss points of an element with all derivatives, in
// generalised coordinates: (x1, x2) of a cable, (x1, L t1, x2, L t2) of a beam, with positions x of its
// nodes, unit tangents t there and its unstretched length L. The formula is evaluate(), which
// submerged_cables.cpp has a second time for four cables at once, wholly under water: change both (a test
// compares them). Internal to the kernel.
#pragma once

#include <cmath>

#include "hawser/kernels/line_water.hpp"
#include "hawser/kernels/wetting.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser::morison_points {

using namespace wide;

template <bool beam>
struct Rule;
template <>
struct Rule<false> {
  static constexpr int points = 2, shapes = 2;
  static constexpr double at[2] = {0.21132486540518711775, 0.78867513459481288225};
  static constexpr double weight[2] = {0.5, 0.5};
  // Of the length: how far about each point a steep element's wetting is smeared.
  static constexpr double reach[2] = {0.25, 0.25};
  static void shape(double s, double* N) { N[0] = 1 - s, N[1] = s; }
};
template <>
struct Rule<true> {
  static constexpr int points = 3, shapes = 4;
  static constexpr double at[3] = {0.11270166537925831148, 0.5, 0.88729833462074168852};
  static constexpr double weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  // Not beyond its ends, so that what is under water is right when the surface is at a node; that of the
  // middle goes to where the others end.
  static constexpr double reach[3] = {at[0], at[1] - 2 * at[0], at[0]};
  static void shape(double s, double* N) {
    const double r = 1 - s;
    N[0] = r * r * (1 + 2 * s), N[1] = s * r * r, N[2] = s * s * (3 - 2 * s), N[3] = -s * s * r;
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

// Half the width of the band of heights in which the section at a point gets wet. Of a beam: a circle's that
// leans as the chord does, and the reach along it, b² = R² (1 - t_z²) + delta² t_z². Of a cable the circle's
// stays as it is, b² = R² + (delta rise/L)²: an element shorter than thick would rather stand up, as a log
// does, and in a slack cable nothing keeps it from that. So a cable through the surface is that wet only if
// it is long beside its thickness, and its potential is convex.
template <bool beam>
struct Band {
  double by_lean = 0, b = 1;  // m², derivative of b² by lean²; m
  Band() = default;
  Band(double radius, double delta, double lean)
      : by_lean(delta * delta - (beam ? radius * radius : 0)),
        b(std::sqrt(radius * radius + by_lean * lean * lean)) {}
};

// Derivatives of lean²/2 by the chord. The lean of a beam is t_z, that of a cable its rise over its length L.
template <bool beam>
Row by_chord_of(Row t, double inverse, double lean, double length) {
  return beam ? (inverse * lean) * (unit(2) - lean * t) : (lean / length) * unit(2);
}
template <bool beam>
Mat by_chord2_of(Row t, double inverse, double lean, double length) {
  const Row up = unit(2);
  if (!beam) return (1 / (length * length)) * outer(up, up);
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
  const double ma = s.added_axial - s.added_normal, lean = beam ? t[2] : chord[2] / s.length;
  // Sums of which blocks are made.
  double masses[n][n] = {};
  Mat by_chord[n];  // derivative by x2 (minus that by x1) through the chord
  Row by_z[n][2];   // through the current
  if constexpr (tangent)
    for (int j = 0; j < n; ++j) {
      by_chord[j] = Mat{}, by_z[j][0] = by_z[j][1] = zero;
      for (int k = 0; k < n; ++k) out.K[j][k] = Mat{}, out.C[j][k] = Mat{};
    }
  const Mat P = identity(1) - outer(t, t);

  for (int g = 0; g < R::points; ++g) {
    const double z = R::at[g];
    double N[n];
    R::shape(z, N);
    const double w = R::weight[g] * s.length;
    double h = (1 - z) * m.surface[0] + z * m.surface[1];
    for (int j = 0; j < n; ++j) h -= N[j] * m.X[j][2];
    const double delta = R::reach[g] * s.length;
    Band<beam> band;
    double level = 1;
    Wetting wet{1, 0, 1};
    if (h < s.radius + delta * std::abs(lean)) {  // else above any band
      band = Band<beam>(s.radius, delta, lean);
      level = h / band.b;
      if (level <= -1) continue;
      wet = circle_wetting(level);
    }
    const bool partly = level < 1;
    Row by_chord_of_b = zero, dh[n];  // minus the derivative of h, with what the band adds
    if (partly) {
      by_chord_of_b = (band.by_lean / band.b) * by_chord_of<beam>(t, inverse, lean, s.length);
      for (int j = 0; j < n; ++j) dh[j] = N[j] * unit(2);
      dh[0] -= level * by_chord_of_b, dh[end] += level * by_chord_of_b;
    }
    if constexpr (part != Part::flow) {
      const double B = w * s.buoyancy;
      for (int j = 0; j < n; ++j) out.f[j][2] -= B * N[j] * wet.share;
      if (partly) {
        const double G = B * (wet.integral - level * wet.share);
        out.f[0] -= G * by_chord_of_b, out.f[end] += G * by_chord_of_b;
        if constexpr (tangent) {
          const double k1 = B * wet.slope / band.b;
          for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) out.K[j][k] += outer(k1 * dh[j], dh[k]);
          if (!beam || !convex) {  // a section wider than the reach would rather stand
            const Mat k2 = (G / band.b) * (band.by_lean * by_chord2_of<beam>(t, inverse, lean, s.length) -
                                           outer(by_chord_of_b, by_chord_of_b));
            out.K[0][0] += k2, out.K[end][end] += k2;
            out.K[0][end] -= k2, out.K[end][0] -= k2;
          }
        }
      }
    }
    if constexpr (part == Part::buoyancy) continue;

    Row u = (1 - z) * m.u[0] + z * m.u[1];
    for (int j = 0; j < n; ++j) u -= N[j] * m.V[j];
    const Row aw = (1 - z) * m.a[0] + z * m.a[1];
    const double along = dot(u, t);
    const Row un = u - along * t;
    const double speed = std::sqrt(dot(un, un)), size = std::abs(along);
    const double wF = w * wet.share;
    // Drag ½ρ Cd D |u_n| u_n across and ½ρ Cd πD |u_t| u_t along, and Froude-Krylov, N/m of wet length.
    const Row flow = (s.drag_normal * speed) * un + (s.drag_axial * size * along) * t + s.displaced_mass * aw;
    // Accelerations that belong to each shape: consistent for a beam, the mean of lumped and consistent for a
    // cable, as its own mass.
    double share[n][n];
    Row y[n], q[n];
    Row point{};
    for (int k = 0; k < n; ++k) point += N[k] * m.A[k];
    for (int j = 0; j < n; ++j) {
      if constexpr (beam)
        y[j] = N[j] * (point - aw);
      else
        y[j] = (0.5 * N[j]) * (point + m.A[j]) - N[j] * aw;
      q[j] = s.added_normal * y[j] + (ma * dot(t, y[j])) * t - N[j] * flow;  // residual per wet length
      out.f[j] += wF * q[j];
      if constexpr (tangent)
        for (int k = 0; k < n; ++k) {
          share[j][k] = beam ? N[j] * N[k] : 0.5 * N[j] * (N[k] + (j == k ? 1 : 0));
          masses[j][k] += wF * share[j][k];
        }
    }
    if constexpr (tangent) {
      const double over = speed > 0 ? 1 / speed : 0;
      // Derivative of the drag by the relative velocity.
      Mat D = outer((s.drag_normal * over) * un, un) + (s.drag_normal * speed) * P +
              outer((2 * s.drag_axial * size) * t, t);
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) out.C[j][k] += (wF * N[j] * N[k]) * D;
      if (!convex) {
        Mat T = outer((-s.drag_normal * along * over) * un +
                          (2 * s.drag_axial * size - s.drag_normal * speed) * t,
                      un) +
                (along * (s.drag_axial * size - s.drag_normal * speed)) * P;
        const Row d[2] = {times(D, m.by_height[0]), times(D, m.by_height[1])};
        for (int j = 0; j < n; ++j) {
          const double ty = dot(t, y[j]);
          const Row across = y[j] - ty * t;
          by_chord[j] += (-wF * N[j] * inverse) * T + (wF * inverse * ma) * (outer(t, across) + ty * P);
          by_z[j][0] -= (wF * N[j] * (1 - z)) * d[0], by_z[j][1] -= (wF * N[j] * z) * d[1];
        }
        if (partly)
          for (int k = 0; k < n; ++k) {
            const Row slope = (-w * wet.slope / band.b) * dh[k];
            for (int j = 0; j < n; ++j) out.K[j][k] += outer(q[j], slope);
          }
      }
    }
  }
  if constexpr (tangent) {
    const Mat added = identity(s.added_normal) + outer(ma * t, t);
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) out.M[j][k] = masses[j][k] * added;
      out.K[j][end] += by_chord[j], out.K[j][0] -= by_chord[j];
      for (int r = 0; r < 3; ++r)
        out.K[j][0].r[r][2] += by_z[j][0][r], out.K[j][end].r[r][2] += by_z[j][1][r];
    }
  }
}

}  // namespace hawser::morison_points
