// Normal force, friction and friction couple at a pair of points of two lines, with the return of the trial
// slip to the friction limit. Derivatives by formula, with those of the friction law by slip and normal
// force, and of the part of new material, by automatic differentiation (docs/theory/line-line.md#tangent).
#include "hawser/kernels/line_pair_law.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "hawser/kernels/line_pair_closing.hpp"

namespace hawser {
namespace {

using Force = LinePairForce;
template <int n>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;

template <int n>
Vector3<Dual<n>> dual(const Vec3& v, int first) {
  return {Dual<n>(v[0], n, first), Dual<n>(v[1], n, first + 1), Dual<n>(v[2], n, first + 2)};
}

// Only the part of the slip of new material after the first touch counts: the fraction of the approach of
// this step that was made within the contact distance.
template <class S>
S part_in_contact(const LinePairLaw& law, const LinePairMotion<S>& motion) {
  using std::sqrt;
  const double ramp = law.normal.smoothing;
  const S deep = S(law.radii + ramp) - sqrt(S(motion.away.squaredNorm()));
  const S closing = line_pair_closing(motion);
  return closing > deep ? S((deep + ramp) / (closing + ramp)) : S(1);
}

// Derivatives by D, T (columns from kAway), and by the state at the start of the step (from kAwayBefore).
constexpr int kNow = 6, kBefore = Force::kInputs - Force::kAwayBefore;
Eigen::Matrix<double, kNow + kBefore, 1> part_by_motion(const LinePairLaw& law, const LinePairPoint& at) {
  const auto v = [](const Vec3& value, int first) { return dual<kNow + kBefore>(value, first); };
  constexpr int kShift = kNow - Force::kAwayBefore;
  return part_in_contact<Dual<kNow + kBefore>>(
             law, {v(at.away, Force::kAway), v(at.away_before, Force::kAwayBefore + kShift),
                   v(at.slope, Force::kSlope + kShift), v(at.slope_before, Force::kSlopeBefore + kShift),
                   v(at.along, Force::kAlong), v(at.along_before, Force::kAlongBefore + kShift)})
      .derivatives();
}

// Friction for a slip and a normal force. The law is isotropic: the direction of the line has no effect.
template <class S>
Friction<S> isotropic(const LinePairLaw& law, const Vector3<S>& slip, const S& force, const Vec3& n) {
  return friction<S>(law.friction, force, slip, n.cast<S>(), Vec3(Vec3::UnitX()));
}

// Adds friction to the normal force, at the distance d and with the normal n.
void add_friction(const LinePairLaw& law, const LinePairPoint& at, double d, const Vec3& n, bool derivatives,
                  Force& r) {
  const Mat3 P = Mat3::Identity() - n * n.transpose();
  Vec3 along = at.along;
  Vec3 b = P * along;
  const bool beyond =
      !(b.squaredNorm() > 1e-12 * along.squaredNorm());  // an end, on the axis of the other line
  if (beyond) {
    along = Vec3::Unit(std::abs(along.x()) < 0.9 * along.norm() ? 0 : 1);
    b = P * along;
  }
  const double across = b.norm();
  b /= across;
  const Vec3 l = n.cross(b);
  const Vec3 slid = P * at.moved;
  const double part = at.is_new ? part_in_contact<double>(law, {at.away, at.away_before, at.slope,
                                                                at.slope_before, at.along, at.along_before})
                                : 1;
  const Vec3 slip = part * slid + at.slip[0] * b + at.slip[1] * l;
  const double N = r.along_normal.force;
  const auto keep = [&](const Vec3& force, const Vec3& remains, bool slides) {
    r.friction = force;
    r.couple = force.cross(at.away);
    r.slip[0] = remains.dot(b);
    r.slip[1] = remains.dot(l);
    r.slides = slides;
    r.force += force;
  };
  if (!derivatives) {
    const Friction<double> f = isotropic(law, slip, N, n);
    keep(f.force, f.slip, f.slides);
    return;
  }
  const Friction<Dual<4>> f = isotropic(law, dual<4>(slip, 0), Dual<4>(N, 4, 3), n);
  Mat3 by_slip;
  Vec3 by_force, force, remains;
  for (int c = 0; c < 3; ++c) {
    by_slip.row(c) = f.force[c].derivatives().head<3>();
    by_force[c] = f.force[c].derivatives()[3];
    force[c] = f.force[c].value();
    remains[c] = f.slip[c].value();
  }
  keep(force, remains, f.slides);
  // Derivative of s0 b + s1 l by a rotation about n.
  const Vec3 turned = at.slip[0] * l - at.slip[1] * b;
  const double lean = n.dot(along) / across;
  r.by.block<3, 3>(0, Force::kAway) +=
      r.along_normal.by_gap * by_force * n.transpose() -
      by_slip * (part * n.dot(at.moved) * P + n * slip.transpose() + lean * turned * l.transpose()) / d;
  if (!beyond) r.by.block<3, 3>(0, Force::kAlong) = by_slip * turned / across * l.transpose();
  r.by.block<3, 3>(0, Force::kMoved) = part * by_slip * P;
  r.by.col(Force::kRate) += r.along_normal.by_rate * by_force;
  r.by.col(Force::kSlip) = by_slip * b;
  r.by.col(Force::kSlip + 1) = by_slip * l;
  if (!(part < 1)) return;
  const auto by_part = part_by_motion(law, at);
  const Vec3 by_slid = by_slip * slid;
  r.by.leftCols<kNow>() += by_slid * by_part.head<kNow>().transpose();
  r.by.rightCols<kBefore>() = by_slid * by_part.tail<kBefore>().transpose();
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
  if (law.friction.active()) add_friction(law, at, d, n, derivatives, r);
  return r;
}

}  // namespace hawser
