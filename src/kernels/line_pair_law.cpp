// Normal force, friction and friction couple at a pair of points of two lines, with the return of the trial
// slip to the friction limit; derivatives by automatic differentiation.
#include "hawser/kernels/line_pair_law.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "hawser/kernels/line_pair_closing.hpp"

namespace hawser {
namespace {

using Force = LinePairForce;

template <class S>
struct Local {
  Vector3<S> away, along, moved;
  S force, slip[2];
  Vector3<S> away_before, slope, slope_before, along_before;  // for new material
};

template <class S>
struct Tangential {
  Vector3<S> force, couple;
  S slip[2];
  bool slides = false;
};

template <class S>
Tangential<S> tangential(const LinePairLaw& law, const LinePairPoint& at, const Local<S>& v) {
  using std::sqrt;
  const S d = sqrt(S(v.away.squaredNorm()));
  const Vector3<S> n = v.away / d;
  Vector3<S> b = v.along - n * S(n.dot(v.along));
  if (!(b.squaredNorm() > 1e-12 * v.along.squaredNorm())) {  // beyond an end, on the axis of the other line
    const Vec3 any = Vec3::Unit(std::abs(at.along.x()) < 0.9 * at.along.norm() ? 0 : 1);
    b = any.cast<S>() - n * S(n.dot(any.cast<S>()));
  }
  b /= S(sqrt(S(b.squaredNorm())));
  const Vector3<S> l = n.cross(b);
  Vector3<S> slip = v.moved - n * S(n.dot(v.moved));
  if (at.is_new) {
    // Only the part of the slip after the first touch counts: the fraction of the approach of this step that
    // was made within the contact distance.
    const double ramp = law.normal.smoothing;
    const S deep = S(law.radii + ramp) - d;
    const S closing =
        line_pair_closing<S>({v.away, v.away_before, v.slope, v.slope_before, v.along, v.along_before});
    if (closing > deep) slip *= S((deep + ramp) / (closing + ramp));
  }
  slip += b * v.slip[0] + l * v.slip[1];
  // The law is isotropic: the direction of the line has no effect.
  const Vec3 any_direction = Vec3::UnitX();
  const Friction<S> f = friction<S>(law.friction, Coulomb<double>{law.friction.axial, law.friction.lateral},
                                    v.force, slip, n, any_direction);
  Tangential<S> r;
  r.force = f.force;
  r.couple = f.force.cross(v.away);
  r.slip[0] = f.slip.dot(b);
  r.slip[1] = f.slip.dot(l);
  r.slides = f.slides;
  return r;
}

// Derivatives by the first `Inputs` variables, stored in r.by.
template <int Inputs>
Tangential<double> derived(const LinePairLaw& law, const LinePairPoint& at, Force& r) {
  using Row = Eigen::Matrix<double, Inputs, 1>;
  using Dual = Eigen::AutoDiffScalar<Row>;
  const auto dual = [](const Vec3& v, int first) -> Vector3<Dual> {
    return {Dual(v[0], Inputs, first), Dual(v[1], Inputs, first + 1), Dual(v[2], Inputs, first + 2)};
  };
  Row by = Row::Zero();
  by.template head<3>() = r.along_normal.by_gap * at.away.normalized();
  by[Force::kRate] = r.along_normal.by_rate;
  Local<Dual> v;
  v.away = dual(at.away, Force::kAway);
  v.along = dual(at.along, Force::kAlong);
  v.moved = dual(at.moved, Force::kMoved);
  v.force = Dual(r.along_normal.force, by);
  for (int c = 0; c < 2; ++c) v.slip[c] = Dual(at.slip[c], Inputs, Force::kSlip + c);
  if constexpr (Inputs == Force::kInputs) {
    v.away_before = dual(at.away_before, Force::kAwayBefore);
    v.slope = dual(at.slope, Force::kSlope);
    v.slope_before = dual(at.slope_before, Force::kSlopeBefore);
    v.along_before = dual(at.along_before, Force::kAlongBefore);
  }
  const Tangential<Dual> t = tangential<Dual>(law, at, v);
  Tangential<double> out;
  for (int c = 0; c < 3; ++c) {
    out.force[c] = t.force[c].value();
    out.couple[c] = t.couple[c].value();
    r.by.row(c).template head<Inputs>() += t.force[c].derivatives().transpose();
    r.by.row(3 + c).template head<Inputs>() += t.couple[c].derivatives().transpose();
  }
  out.slip[0] = t.slip[0].value();
  out.slip[1] = t.slip[1].value();
  out.slides = t.slides;
  return out;
}

}  // namespace

// flatten: otherwise most operations on dual numbers are function calls.
[[gnu::flatten]] Force line_pair_force(const LinePairLaw& law, const LinePairPoint& at, bool derivatives) {
  Force r;
  if (derivatives) r.by.setZero();
  const double d = at.away.norm();
  r.gap = d - law.radii;
  r.along_normal = normal_force(law.normal, r.gap, at.rate);
  if (!(r.along_normal.force > 0) || !(d > 0)) {
    r.along_normal.force = 0;
    return r;
  }
  const Vec3 n = at.away / d;
  r.force = r.along_normal.force * n;
  if (derivatives) {
    r.by.block<3, 3>(0, Force::kAway) = r.along_normal.by_gap * n * n.transpose() +
                                        r.along_normal.force / d * (Mat3::Identity() - n * n.transpose());
    r.by.block<3, 1>(0, Force::kRate) = r.along_normal.by_rate * n;
  }
  if (!law.friction.active()) return r;
  Tangential<double> t;
  if (!derivatives)
    t = tangential<double>(law, at,
                           {at.away,
                            at.along,
                            at.moved,
                            r.along_normal.force,
                            {at.slip[0], at.slip[1]},
                            at.away_before,
                            at.slope,
                            at.slope_before,
                            at.along_before});
  else if (at.is_new)
    t = derived<Force::kInputs>(law, at, r);
  else
    t = derived<Force::kAwayBefore>(law, at, r);
  r.friction = t.force;
  r.couple = t.couple;
  r.slides = t.slides;
  r.slip[0] = t.slip[0];
  r.slip[1] = t.slip[1];
  r.force += r.friction;
  return r;
}

}  // namespace hawser
