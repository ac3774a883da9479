// Elastic-plastic Coulomb friction of a point on a surface, anisotropic. The elastic slip is a vector in the
// tangent plane, in the body's frame; the law is a pure function of it, of the normal force and of the
// axial direction. Written for any scalar, so that exact derivatives come by automatic differentiation.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "hawser/math/types.hpp"

namespace hawser {

struct FrictionLaw {
  double axial = 0, lateral = 0;                // Coulomb coefficients along and across the line
  double stiffness = 0;                         // N/m: > 0: linear springs; 0: mobilisation lengths
  double axial_length = 0, lateral_length = 0;  // m, mobilisation lengths, used when stiffness is 0

  bool active() const { return axial > 0 || lateral > 0; }
  bool isotropic() const { return axial == lateral && (stiffness > 0 || axial_length == lateral_length); }
};

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

template <class S>
struct Friction {
  Vector3<S> force = Vector3<S>::Zero();  // N, on the point
  Vector3<S> slip = Vector3<S>::Zero();   // m, elastic slip that is left
  bool slides = false;
};

// The tangent vector `slip` at the normal `from`, turned by the smallest rotation that takes `from` to `to`.
template <class S>
Vector3<S> transport_slip(const Vec3& slip, const Vec3& from, const Vector3<S>& to) {
  const Vector3<S> s = slip.cast<S>(), f = from.cast<S>();
  const S along = s.dot(to), opening = S(1) + f.dot(to);
  if (opening < 1e-9) return s - to * along;  // normals turned over: no rotation is smallest
  const Vector3<S> sum = f + to;
  const S scale = along / opening;
  return s - sum * scale;
}

// Force and remaining slip for a trial slip in the tangent plane of `normal`; N [N] >= 0; `tangent` is a
// direction of the line (unit, need not lie in the plane).
//
// stiffness k: f = -k s, cut to the slip surface (f_a/mu_a)² + (f_l/mu_l)² <= N².
// mobilisation lengths (OMAE2006-92155, eqs 6-10): R² = (s_a/d_a)² + (s_l/d_l)², f_i = -mu_i N min(R, 1)
// s_i/|s|; with equal lengths f_i = -mu_i N s_i/d. Both return radially: the slip shrinks in its own
// direction. (An associated return would go here.)
template <class S>
Friction<S> friction(const FrictionLaw& law, const S& N, const Vector3<S>& slip, const Vector3<S>& normal,
                     const Vec3& tangent) {
  Friction<S> r;
  if (!(N > 0.0)) return r;
  using std::sqrt;
  if (law.isotropic()) {
    const S s2 = slip.squaredNorm();
    const S limit = law.stiffness > 0 ? S(N * (law.axial / law.stiffness)) : S(law.axial_length);
    const S stiffness = law.stiffness > 0 ? S(law.stiffness) : S(N * (law.axial / law.axial_length));
    r.slip = slip;
    if (s2 > S(limit * limit)) {
      const S shrink = limit / sqrt(s2);
      r.slip = slip * shrink;
      r.slides = true;
    }
    r.force = r.slip * S(-stiffness);
    return r;
  }
  Vector3<S> a = tangent.cast<S>();
  a -= normal * S(a.dot(normal));
  if (!(a.squaredNorm() > 1e-12)) {  // the line stands on the surface
    a = Vec3::Unit(std::abs(tangent.x()) < 0.9 ? 0 : 1).cast<S>();
    a -= normal * S(a.dot(normal));
  }
  a /= S(sqrt(S(a.squaredNorm())));
  const Vector3<S> l = normal.cross(a);
  S sa = slip.dot(a), sl = slip.dot(l);
  if (law.stiffness > 0) {
    const double k = law.stiffness;
    if (law.axial == 0) sa = S(0);  // no friction that way: nothing is held
    if (law.lateral == 0) sl = S(0);
    const S ra = law.axial > 0 ? S(sa * (k / law.axial)) : S(0);
    const S rl = law.lateral > 0 ? S(sl * (k / law.lateral)) : S(0);
    const S r2 = (ra * ra + rl * rl) / (N * N);
    if (r2 > 1.0) {
      const S shrink = S(1) / sqrt(r2);
      sa *= shrink, sl *= shrink;
      r.slides = true;
    }
    r.slip = a * sa + l * sl;
    r.force = r.slip * S(-k);
    return r;
  }
  const S ra = sa / law.axial_length, rl = sl / law.lateral_length;
  const S r2 = ra * ra + rl * rl, s2 = sa * sa + sl * sl;
  if (!(s2 > 0.0)) {
    r.force = (a * S(sa * law.axial) + l * S(sl * law.lateral)) * S(N * (-1 / law.axial_length));
    return r;
  }
  r.slides = r2 > 1.0;
  const S spring = r.slides ? S(N / sqrt(s2)) : S(N * sqrt(S(r2 / s2)));
  r.force = a * S(sa * spring * (-law.axial)) + l * S(sl * spring * (-law.lateral));
  const S shrink = r.slides ? S(S(1) / sqrt(r2)) : S(1);
  r.slip = a * S(sa * shrink) + l * S(sl * shrink);
  return r;
}

}  // namespace hawser
