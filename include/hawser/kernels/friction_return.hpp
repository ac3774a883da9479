// How a slip beyond the slip ellipse returns to it. The axes of the ellipse are along and across the line.
#pragma once

#include <cmath>
#include <type_traits>

namespace hawser {

// radial: the slip shrinks in its own direction. associated: the slip goes to the nearest point in the energy
// norm of the springs. This is the backward Euler step of friction that flows along the normal of the slip
// surface, which dissipates most (Simo & Hughes 1998, Computational Inelasticity, 3.3). Both are equal for
// isotropic friction.
enum class FrictionReturn { radial, associated };

template <class S>
struct SlipEllipse {
  S slip[2] = {S(0), S(0)};       // m, along and across
  S axis[2] = {S(1), S(1)};       // m, half axes, > 0
  S stiffness[2] = {S(1), S(1)};  // of the springs, up to a common factor; they define the nearest point

  // > 1: the slip is outside the ellipse.
  S square() const {
    const S a = slip[0] / axis[0];
    const S l = slip[1] / axis[1];
    return a * a + l * l;
  }

  // Returns true if the slip was outside.
  bool return_to_limit(FrictionReturn rule) {
    using std::sqrt;
    const S outside = square();
    if (!(outside > 1.0)) return false;
    if (rule == FrictionReturn::radial) {
      const S shrink = S(1) / sqrt(outside);
      slip[0] *= shrink;
      slip[1] *= shrink;
      return true;
    }
    // s_i = trial_i/(1 + x c_i), c_i = 1/(k_i axis_i²), x >= 0 the root of the ellipse's equation.
    const S c[2] = {S(S(1) / (stiffness[0] * axis[0] * axis[0])),
                    S(S(1) / (stiffness[1] * axis[1] * axis[1]))};
    const S x = multiplier(c);
    for (int i = 0; i < 2; ++i) slip[i] = slip[i] / S(S(1) + x * c[i]);
    return true;
  }

 private:
  static double plain(const S& x) {
    if constexpr (std::is_arithmetic_v<S>)
      return x;
    else
      return x.value();
  }

  // Solves h(x) = sum (s_i/(axis_i (1 + x c_i)))² = 1. 1/sqrt(h) is nearly linear in x, so Newton's method on
  // it converges from x = 0 to the root in a few iterations, from below (Moré & Sorensen 1983, SIAM J. Sci.
  // Stat. Comput. 4). One more step in the scalar S adds the derivatives of the root.
  S multiplier(const S c[2]) const {
    const double p[2] = {plain(c[0]), plain(c[1])};
    const double u[2] = {plain(S(slip[0] / axis[0])), plain(S(slip[1] / axis[1]))};
    double x = 0, slope = -1;
    for (int i = 0; i < 50; ++i) {
      double h = 0;
      slope = 0;
      for (int j = 0; j < 2; ++j) {
        const double d = 1 / (1 + x * p[j]);
        const double v = u[j] * d;
        h += v * v;
        slope -= 2 * v * v * p[j] * d;
      }
      if (std::abs(h - 1) < 1e-15) break;
      const double step = 2 * h * (std::sqrt(h) - 1) / -slope;
      x += step;
      if (std::abs(step) < 1e-16 * x) break;
    }
    S h(-1);
    for (int j = 0; j < 2; ++j) {
      const S v = slip[j] / axis[j] / S(S(1) + c[j] * x);
      h += v * v;
    }
    return S(h * (-1 / slope) + x);
  }
};

}  // namespace hawser
