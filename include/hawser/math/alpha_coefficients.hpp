// Coefficients of generalized-alpha, and weights of forces that are given as their mean over a step. Chung &
// Hulbert (1993), "A time integration algorithm for structural dynamics with improved numerical dissipation",
// J. Appl. Mech. 60. See docs/theory/time-integration.md#cables.
#pragma once

namespace hawser {

// Second order, unconditionally stable, spectral radius rho at infinite frequency.
struct AlphaCoefficients {
  double am, af, gamma, beta;
  explicit AlphaCoefficients(double rho_infinity)
      : am((2 * rho_infinity - 1) / (rho_infinity + 1)),
        af(rho_infinity / (rho_infinity + 1)),
        gamma(0.5 + af - am),
        beta(0.25 * (gamma + 0.5) * (gamma + 0.5)) {}
};

// The algorithmic force Q solves (1 - gamma) Q0 + gamma Q1 = S, with S the mean over the step. The force F at
// the end of the step follows from the scheme's relation between algorithmic and true accelerations:
//   Q1 = s S - q Q0,   F1 = a Q1 + b Q0 - c F0 = a s S + history
struct MeanWeights {
  double s, q, a, b, c;
  explicit MeanWeights(const AlphaCoefficients& k)
      : s(1 / k.gamma),
        q((1 - k.gamma) / k.gamma),
        a((1 - k.am) / (1 - k.af)),
        b(k.am / (1 - k.af)),
        c(k.af / (1 - k.af)) {}
  double weight() const { return a * s; }
  template <class V>
  V history(const V& Q, const V& F) const {
    return (b - a * q) * Q - c * F;
  }
  template <class V>
  void advance(const V& S, V& Q, V& F) const {
    const V next = s * S - q * Q;
    F = a * next + b * Q - c * F;
    Q = next;
  }
};

}  // namespace hawser
