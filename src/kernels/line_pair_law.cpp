// Normal force, friction and friction couple at one pair of points of two lines, from trial slip to return,
// with derivatives by automatic differentiation.
#include "hawser/kernels/line_pair_law.hpp"

#include <unsupported/Eigen/AutoDiff>

namespace hawser {
namespace {

using Row = Eigen::Matrix<double, LinePairForce::kInputs, 1>;
using Dual = Eigen::AutoDiffScalar<Row>;

template <class S>
struct Local {
  Vector3<S> away, along, moved;
  S force, closing, slip[2];
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
  if (!(b.squaredNorm() > 1e-12 * v.along.squaredNorm())) {  // beyond an end, on the other's axis
    const Vec3 any = Vec3::Unit(std::abs(at.along.x()) < 0.9 * at.along.norm() ? 0 : 1);
    b = any.cast<S>() - n * S(n.dot(any.cast<S>()));
  }
  b /= S(sqrt(S(b.squaredNorm())));
  const Vector3<S> l = n.cross(b);
  Vector3<S> slip = v.moved - n * S(n.dot(v.moved));
  // What closed by less than the ramp is wide was there.
  const double ramp = law.normal.smoothing;
  const S deep = S(law.radii + ramp) - d;
  if (v.closing > deep) slip *= S((deep + ramp) / (v.closing + ramp));
  slip += b * v.slip[0] + l * v.slip[1];
  const Friction<S> f = friction<S>(law.friction, Coulomb<double>{law.friction.axial, law.friction.lateral},
                                    v.force, slip, n, Vec3(Vec3::UnitX()));
  Tangential<S> r;
  r.force = f.force;
  r.couple = f.force.cross(v.away);
  r.slip[0] = f.slip.dot(b), r.slip[1] = f.slip.dot(l);
  r.slides = f.slides;
  return r;
}

}  // namespace

LinePairForce line_pair_force(const LinePairLaw& law, const LinePairPoint& at, bool derivatives) {
  LinePairForce r;
  const double d = at.away.norm();
  r.gap = d - law.radii;
  r.normal = normal_force(law.normal, r.gap, at.rate);
  if (!(r.normal.force > 0) || !(d > 0)) {
    r.by.setZero();
    r.normal.force = 0;
    return r;
  }
  const Vec3 n = at.away / d;
  r.force = r.normal.force * n;
  if (derivatives) {
    r.by.setZero();
    r.by.block<3, 3>(0, LinePairForce::kAway) =
        r.normal.by_gap * n * n.transpose() + r.normal.force / d * (Mat3::Identity() - n * n.transpose());
    r.by.block<3, 1>(0, LinePairForce::kRate) = r.normal.by_rate * n;
  }
  if (!law.friction.active()) return r;
  if (!derivatives) {
    const Tangential<double> t = tangential<double>(
        law, at, {at.away, at.along, at.moved, r.normal.force, at.closing, {at.slip[0], at.slip[1]}});
    r.friction = t.force, r.couple = t.couple, r.slides = t.slides;
    r.slip[0] = t.slip[0], r.slip[1] = t.slip[1];
  } else {
    Local<Dual> v;
    for (int c = 0; c < 3; ++c) {
      v.away[c] = Dual(at.away[c], LinePairForce::kInputs, LinePairForce::kAway + c);
      v.along[c] = Dual(at.along[c], LinePairForce::kInputs, LinePairForce::kAlong + c);
      v.moved[c] = Dual(at.moved[c], LinePairForce::kInputs, LinePairForce::kMoved + c);
    }
    Row by = Row::Zero();
    by.head<3>() = r.normal.by_gap * n;
    by[LinePairForce::kRate] = r.normal.by_rate;
    v.force = Dual(r.normal.force, by);
    v.closing = Dual(at.closing, LinePairForce::kInputs, LinePairForce::kClosing);
    for (int c = 0; c < 2; ++c)
      v.slip[c] = Dual(at.slip[c], LinePairForce::kInputs, LinePairForce::kSlip + c);
    const Tangential<Dual> t = tangential<Dual>(law, at, v);
    for (int c = 0; c < 3; ++c) {
      r.friction[c] = t.force[c].value(), r.couple[c] = t.couple[c].value();
      r.by.row(c) += t.force[c].derivatives().transpose();
      r.by.row(3 + c) += t.couple[c].derivatives().transpose();
    }
    r.slip[0] = t.slip[0].value(), r.slip[1] = t.slip[1].value();
    r.slides = t.slides;
  }
  r.force += r.friction;
  return r;
}

}  // namespace hawser
