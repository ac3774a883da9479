// Wet fraction of a round section, a sphere, or a body of some height.
#pragma once

#include <algorithm>
#include <cmath>

#include "hawser/math/gauss_points.hpp"

namespace hawser {

// Functions of u = (height of the surface above the centre)/radius: wet fraction, its derivative, and its
// integral from -infinity, all continuous.
struct Wetting {
  double fraction = 0, slope = 0, integral = 0;
};

// Circular segment: fraction = 1/2 + (u sqrt(1 - u²) + asin u)/pi.
inline Wetting circle_wetting(double u) {
  if (u >= 1) return {1, 0, u};
  if (u <= -1) return {};
  const double c2 = 1 - u * u;
  const double c = std::sqrt(c2);
  const double a = std::asin(u);
  return {0.5 + (u * c + a) / M_PI, 2 * c / M_PI, 0.5 * u + (c - c * c2 / 3 + u * a) / M_PI};
}

// Straight piece of an axis with circular sections, as a function of the heights h1, h2 [m] of the surface
// above its ends and of b [m], half the height over which a section gets wet. z runs from 0 to 1 along the
// piece, h = h1 + z (h2 - h1), and F = circle_wetting(h/b).fraction.
struct PieceWetting {
  double integral = 0;              // m, mean of b Psi(h/b), Psi' = F; homogeneous of degree 1
  double by_h1 = 0, by_h2 = 0;      // derivatives by h1 and h2: means of (1 - z) F and z F
  double slope11 = 0, slope12 = 0;  // 1/m, second derivatives: means of (1 - z)² F'/b and z (1 - z) F'/b,
  double slope22 = 0;               // and of z² F'/b
};

// With h = b sin(phi) within the band |h| < b, where F'/b = 2 cos(phi)/(pi b), the moments are
//   m_k = mean of z^k F'/b = 2/(pi (h2 - h1)) int z^k cos²(phi) dphi,  z = (b sin(phi) - h1)/(h2 - h1),
// in closed form, or by Gauss's rule (exact to rounding) where the closed form loses digits because phi
// changes little. The other means follow from them by parts.
inline PieceWetting piece_wetting(double h1, double h2, double b) {
  if (std::min(h1, h2) >= b) return {0.5 * (h1 + h2), 0.5, 0.5, 0, 0, 0};
  if (std::max(h1, h2) <= -b) return {};
  constexpr double kLevel = 1e-7;   // of b
  constexpr double kNarrow = 0.13;  // tangent of half the change of phi
  const double rise = h2 - h1;
  const double s1 = std::clamp(h1 / b, -1.0, 1.0);
  const double s2 = std::clamp(h2 / b, -1.0, 1.0);
  const double c1 = std::sqrt((1 - s1) * (1 + s1));
  const double c2 = std::sqrt((1 - s2) * (1 + s2));
  const double phi2 = std::asin(s2);
  const double tangent = (s2 - s1) / (c1 + c2);
  double m[3] = {};
  if (std::abs(rise) < kLevel * b) {
    for (int k = 0; k < 3; ++k) m[k] = 2 / (M_PI * b) * c2 / (k + 1);
  } else if (std::abs(tangent) < kNarrow) {
    using Rule = GaussPoints<4>;
    const double half = std::atan(tangent);
    const double by_rise = 1 / rise;
    const double factor = 2 / M_PI * by_rise * half;
    const double secant = std::sqrt(1 + tangent * tangent);  // 1/cosine of half the change
    const double s = 0.5 * secant * (s1 + s2);               // in the middle
    const double c = 0.5 * secant * (c1 + c2);
    double w[4], z[4];
    for (int g = 0; g < 4; ++g) {
      const double d = half * Rule::centred[g];
      const double d2 = d * d;  // sine and cosine to rounding:
      const double sin_d = d * (1 + d2 * (-1 / 6.0 + d2 * (1 / 120.0 + d2 * (-1 / 5040.0))));
      const double cos_d = 1 + d2 * (-1 / 2.0 + d2 * (1 / 24.0 + d2 * (-1 / 720.0 + d2 * (1 / 40320.0))));
      const double cosine = c * cos_d - s * sin_d;
      z[g] = (b * (s * cos_d + c * sin_d) - h1) * by_rise;
      w[g] = factor * (2 * Rule::weight[g]) * cosine * cosine;
    }
    for (int g = 0; g < 4; ++g) {
      m[0] += w[g];
      m[1] += w[g] * z[g];
      m[2] += w[g] * z[g] * z[g];
    }
  } else {
    const auto integrals = [](double phi, double sine, double cosine,
                              double* I) {  // of sin^k cos², k = 0, 1, 2
      I[0] = 0.5 * (phi + sine * cosine);
      I[1] = -cosine * cosine * cosine / 3;
      I[2] = 0.125 * (phi - sine * cosine * (1 - 2 * sine * sine));
    };
    double I[3], low[3];
    integrals(phi2, s2, c2, I);
    integrals(std::asin(s1), s1, c1, low);
    for (int k = 0; k < 3; ++k) I[k] -= low[k];
    const double factor = 2 / (M_PI * rise);
    m[0] = factor * I[0];
    m[1] = factor * (b * I[1] - h1 * I[0]) / rise;
    m[2] = factor * (b * b * I[2] - 2 * b * h1 * I[1] + h1 * h1 * I[0]) / (rise * rise);
  }
  const double fraction = 0.5 + (s2 * c2 + phi2) * (1 / M_PI);  // circle_wetting at h2
  const double integral = h2 >= b ? h2 : b * (0.5 * s2 + (c2 - c2 * c2 * c2 / 3 + s2 * phi2) * (1 / M_PI));
  PieceWetting out;
  out.by_h2 = 0.5 * (fraction - rise * m[2]);
  out.by_h1 = fraction - rise * m[1] - out.by_h2;
  out.integral = integral - rise * out.by_h2;
  out.slope11 = m[0] - 2 * m[1] + m[2];
  out.slope12 = m[1] - m[2];
  out.slope22 = m[2];
  return out;
}

// Spherical cap: fraction = (2 + 3 u - u³)/4.
inline Wetting ball_wetting(double u) {
  if (u >= 1) return {1, 0, u};
  if (u <= -1) return {};
  const double u2 = u * u;
  return {0.25 * (2 + 3 * u - u * u2), 0.75 * (1 - u2), 0.5 * u + 0.375 * u2 - u2 * u2 / 16 + 0.1875};
}

// Body that gets wet uniformly over its height: fraction = (1 + u)/2, u in half heights, rounded by parabolas
// at both ends so that it is continuously differentiable. Exact in between.
inline Wetting even_wetting(double u) {
  constexpr double d = 0.1;  // fraction of the half height on both sides of each end
  if (u >= 1 + d) return {1, 0, u};
  if (u <= -1 - d) return {};
  if (u > 1 - d) {
    const double s = 1 + d - u;
    return {1 - s * s / (8 * d), s / (4 * d), u + s * s * s / (24 * d)};
  }
  if (u < d - 1) {
    const double s = 1 + d + u;
    return {s * s / (8 * d), s / (4 * d), s * s * s / (24 * d)};
  }
  return {0.5 * (1 + u), 0.5, 0.25 * (1 + u) * (1 + u) + d * d / 12};
}

}  // namespace hawser
