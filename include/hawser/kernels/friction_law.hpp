// Elastic-plastic anisotropic Coulomb friction of a point on a surface. The elastic slip is a vector in the
// tangent plane, in the axes of the caller: of the body for volumes, of space for the bed, of the contact for
// two lines. The law is a pure function of this slip, the normal force and the axial direction. It is a
// template of the scalar, for automatic differentiation.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "hawser/kernels/friction_return.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// Friction with mobilisation lengths d, while it sticks. elliptic: f_i = -mu_i P s_i/d_i, one spring in each
// direction, with the coefficient at rest and the peak P of the normal force (FrictionLaw::stiffens); no
// closed path generates energy. michalopoulos: f_i = -mu_i N R s_i/|s|, R² = (s_a/d_a)² + (s_l/d_l)²
// (Michalopoulos 1986; OMAE2006-92155, eqs 6-10); it has no potential unless the lengths are equal and N is
// constant.
enum class FrictionSpring { elliptic, michalopoulos };

struct FrictionLaw {
  double axial = 0, lateral = 0;                // Coulomb coefficients along and across the line, at rest
  double stiffness = 0;                         // N/m; > 0: linear springs; 0: mobilisation lengths are used
  double axial_length = 0, lateral_length = 0;  // m, mobilisation lengths, used when stiffness is 0
  FrictionReturn return_rule = FrictionReturn::radial;
  FrictionSpring spring = FrictionSpring::elliptic;
  double axial_kinetic = 0, lateral_kinetic = 0;  // coefficients at speeds far above the blend speed
  double blend_speed = 0;                         // m/s; 0: the coefficients at rest apply at every speed
  // sqrt(kg), 2 zeta sqrt(mass), for isotropic laws: sticking friction with the stiffness k has the damper c
  // = damping sqrt(k).
  double damping = 0;

  bool operator==(const FrictionLaw&) const = default;
  bool active() const { return axial > 0 || lateral > 0; }
  bool blends() const { return blend_speed > 0; }
  // The springs have the stiffness mu P/d, with the largest normal force P since the point touched: if it
  // followed N down and up again, it would do work on a stuck slip.
  bool stiffens() const { return stiffness <= 0 && spring == FrictionSpring::elliptic; }
  bool isotropic() const {
    return axial == lateral && (stiffness > 0 || axial_length == lateral_length) &&
           (!blends() || axial_kinetic == lateral_kinetic);
  }
};

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

template <class S>
struct Coulomb {
  S axial, lateral;
};

template <class S>
struct Friction {
  Vector3<S> force = Vector3<S>::Zero();  // N, on the point
  Vector3<S> slip = Vector3<S>::Zero();   // m, elastic slip that remains
  S peak = S(0);  // N, largest normal force since the point touched, if the springs stiffen with it
  bool slides = false;
};

// Rotates `slip`, a tangent vector at the normal `from`, by the smallest rotation that takes `from` to `to`.
template <class S, class U = double>
Vector3<S> transport_slip(const Vector3<U>& slip, const Vector3<U>& from, const Vector3<S>& to) {
  const Vector3<S> s = slip.template cast<S>();
  const Vector3<S> f = from.template cast<S>();
  const S along = s.dot(to);
  const S opening = S(1) + f.dot(to);
  if (opening < 1e-9) return s - to * along;  // normals are opposite: there is no unique smallest rotation
  const Vector3<S> sum = f + to;
  const S scale = along / opening;
  return s - sum * scale;
}

// Coefficients at the square of the tangential speed [m²/s²]. They fall from those at rest to the kinetic
// ones with exp(-(v/v0)²) (Armstrong-Hélouvry, Dupont, Canudas de Wit 1994, Automatica 30, with exponent 2),
// and are the kinetic ones where that is 1e-12: kinetic coefficients of 0 would vanish below all numbers.
template <class S>
Coulomb<S> coulomb_at(const FrictionLaw& law, const S& speed2) {
  using std::exp;
  constexpr double kFast = 27.6;  // (v/v0)²
  if (speed2 > kFast * law.blend_speed * law.blend_speed)
    return {S(law.axial_kinetic), S(law.lateral_kinetic)};
  const S static_weight = exp(S(speed2 * (-1 / (law.blend_speed * law.blend_speed))));
  return {S(static_weight * (law.axial - law.axial_kinetic) + law.axial_kinetic),
          S(static_weight * (law.lateral - law.lateral_kinetic) + law.lateral_kinetic)};
}

// Stiffness k of an isotropic law under the normal force N with its peak [N], N/m.
template <class S, class M>
S isotropic_stiffness(const FrictionLaw& law, const Coulomb<M>& mu, const S& N, const S& peak) {
  if (law.stiffness > 0) return S(law.stiffness);
  if (law.stiffens()) return S(peak * (law.axial / law.axial_length));
  return S(N * M(mu.axial / law.axial_length));
}

// Friction of a spring that slides if its slip exceeds `limit` [m].
template <class S>
Friction<S> on_spring(const Vector3<S>& slip, const S& limit, const S& stiffness) {
  using std::sqrt;
  Friction<S> r;
  r.slip = slip;
  const S s2 = slip.squaredNorm();
  if (s2 > S(limit * limit)) {
    const S shrink = limit / sqrt(s2);
    r.slip = slip * shrink;
    r.slides = true;
  }
  r.force = r.slip * S(-stiffness);
  return r;
}

// Friction of an isotropic law with damping in a step of length h [s], from the slip s0 at its start, rotated
// to the present normal, over the displacement d in the tangent plane. Spring and damper are parallel, in
// series with the slider: F = -(k s + c (s - s0)/h), |F| <= mu N. With k' = k + c/h, w = k/k' and s = s0 + d
// while sticking, F = -k' (w s0 + d). After sliding, the slip is that which belongs to F: s = (1 - w) s0 -
// F/k'.
template <class S, class M>
Friction<S> damped_friction(const FrictionLaw& law, const Coulomb<M>& mu, const S& N, const S& peak,
                            const Vector3<S>& s0, const Vector3<S>& d, double h) {
  if (!(N > 0.0) || !(mu.axial > 0.0)) return {};
  using std::sqrt;
  const S k = isotropic_stiffness(law, mu, N, peak);
  const S damped = k + sqrt(k) * S(law.damping / h);
  const S w = k / damped;
  Friction<S> r = on_spring<S>(s0 * w + d, N * mu.axial / damped, damped);
  r.slip += s0 * S(S(1) - w);
  return r;
}

// Force and remaining slip for a trial slip in the tangent plane of `normal`. N [N] >= 0, peak >= N;
// `tangent` is the direction of the line (unit vector, need not lie in the plane); mu holds the coefficients
// that apply.
//
// With a stiffness k the force is f = -k s, limited by the slip surface (f_a/mu_a)² + (f_l/mu_l)² <= N². With
// mobilisation lengths it is that of FrictionSpring, limited by the same surface: (s_a/d_a)² + (s_l/d_l)² <=
// 1 for michalopoulos, and for elliptic with d_i mu_i N/(mu0_i P) in place of d_i, mu0 at rest. A slip beyond
// it returns to it by FrictionReturn. A direction with mu = 0 has neither slip nor force.
template <class S, class M, class U = double>
Friction<S> friction(const FrictionLaw& law, const Coulomb<M>& mu, const S& N, const S& peak,
                     const Vector3<S>& slip, const Vector3<S>& normal, const Vector3<U>& tangent) {
  Friction<S> r;
  if (!(N > 0.0)) return r;
  using std::abs, std::sqrt;
  if (law.isotropic()) {
    if (!(mu.axial > 0.0)) return r;
    const S stiffness = isotropic_stiffness(law, mu, N, peak);
    return on_spring(slip, S(N * mu.axial / stiffness), stiffness);
  }
  Vector3<S> a = tangent.template cast<S>();
  a -= normal * S(a.dot(normal));
  if (!(a.squaredNorm() > 1e-12)) {  // the line is normal to the surface: any tangent direction serves
    a = Vec3::Unit(abs(tangent.x()) < 0.9 ? 0 : 1).template cast<S>();
    a -= normal * S(a.dot(normal));
  }
  a /= S(sqrt(S(a.squaredNorm())));
  const Vector3<S> l = normal.cross(a);
  const bool holds_a = mu.axial > 0.0;
  const bool holds_l = mu.lateral > 0.0;
  SlipEllipse<S> e;
  e.slip[0] = holds_a ? S(slip.dot(a)) : S(0);
  e.slip[1] = holds_l ? S(slip.dot(l)) : S(0);
  const double k = law.stiffness;
  if (k > 0) {
    e.axis[0] = holds_a ? S(N * M(mu.axial / k)) : S(1);
    e.axis[1] = holds_l ? S(N * M(mu.lateral / k)) : S(1);
  } else {
    e.axis[0] = S(law.axial_length);
    e.axis[1] = S(law.lateral_length);
    if (law.stiffens()) {
      if (holds_a) e.axis[0] *= S(N / peak) * S(mu.axial / law.axial);
      if (holds_l) e.axis[1] *= S(N / peak) * S(mu.lateral / law.lateral);
      if (law.return_rule == FrictionReturn::associated) {
        if (holds_a) e.stiffness[0] = S(law.axial / law.axial_length);
        if (holds_l) e.stiffness[1] = S(law.lateral / law.lateral_length);
      }
    }
  }
  r.slides = e.return_to_limit(law.return_rule);
  r.slip = a * e.slip[0] + l * e.slip[1];
  if (k > 0) {
    r.force = r.slip * S(-k);
  } else if (law.spring == FrictionSpring::elliptic) {
    const S ka = peak * (law.axial / law.axial_length);
    const S kl = peak * (law.lateral / law.lateral_length);
    r.force = a * S(-(ka * e.slip[0])) + l * S(-(kl * e.slip[1]));
  } else {
    const S s2 = e.slip[0] * e.slip[0] + e.slip[1] * e.slip[1];
    // R/|s| has no limit at zero slip, where the force is zero. The value for an axial slip is used.
    const S spring = s2 > 0.0 ? S(N * sqrt(S(e.square() / s2))) : S(N * (1 / law.axial_length));
    r.force = a * S(-(spring * mu.axial * e.slip[0])) + l * S(-(spring * mu.lateral * e.slip[1]));
  }
  return r;
}

// The same with the coefficients at rest and a normal force that has never been larger.
template <class S, class U = double>
Friction<S> friction(const FrictionLaw& law, const S& N, const Vector3<S>& slip, const Vector3<S>& normal,
                     const Vector3<U>& tangent) {
  return friction<S, double>(law, {law.axial, law.lateral}, N, N, slip, normal, tangent);
}

// Peak of the normal force N in a trial, and the slip of the last accepted state with the peak there (0: the
// point did not touch). An increase of the peak stiffens the springs under their present force, so that the
// slip decreases and their energy too.
template <class S>
struct PeakOfForce {
  S peak, slip_factor;
};
template <class S, class U>
PeakOfForce<S> peak_of_force(const FrictionLaw& law, const U& peak_before, const S& N) {
  const S before(peak_before);
  if (!law.stiffens() || !(before > 0.0)) return {N, S(1)};
  return N > before ? PeakOfForce<S>{N, S(before / N)} : PeakOfForce<S>{before, S(1)};
}

}  // namespace hawser
