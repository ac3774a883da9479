// The relative motion of two touching points split into sliding along either line and closing, with its
// derivatives by automatic differentiation.
#include "hawser/kernels/line_pair_closing.hpp"

#include <unsupported/Eigen/AutoDiff>

#include "hawser/kernels/friction_law.hpp"

namespace hawser {
namespace {

using Closing = LinePairClosing;
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, Closing::kInputs, 1>>;

// Lines at less than about a tenth of a radian count as along each other: which of them slides makes no
// difference then, and each has half of it.
constexpr double kParallel = 3e-3;

// w = x - y less what it was is alpha a + beta b and what is normal to both, a and b the unit tangents at the
// end; with s = (w.a + w.b)/2, d = (w.a - w.b)/2 and c = a.b it is alpha, beta = s/(1 + c) +- d/(1 - c). A
// line that slides along itself by alpha brings x nearer by -alpha n.t/(a.t), t the mean of its tangents at
// the start and at the end: on a circle this is the direction in which it went.
template <class S>
S closing(const Vector3<S>& away, const Vector3<S>& away_before, const Vector3<S>& slope,
          const Vector3<S>& slope_before, const Vector3<S>& along, const Vector3<S>& along_before) {
  using std::sqrt;
  const auto unit = [](const Vector3<S>& v) -> Vector3<S> { return v / S(sqrt(S(v.squaredNorm()))); };
  const auto over = [](const S& v, const S& by) -> S { return v * by / S(by * by + kParallel * kParallel); };
  const Vector3<S> n = unit(away), w = away - away_before, a = unit(slope), b = unit(along);
  const S c = a.dot(b), wa = w.dot(a), wb = w.dot(b);
  const S both = over(S(0.5 * (wa + wb)), S(1 + c)), apart = over(S(0.5 * (wa - wb)), S(1 - c));
  const auto brings = [&n](const S& way, const Vector3<S>& was, const Vector3<S>& now) -> S {
    const Vector3<S> mean = was + now;
    return -way * n.dot(mean) / S(now.dot(mean));
  };
  return -n.dot(w) - brings(S(both + apart), unit(slope_before), a) -
         brings(S(both - apart), unit(along_before), b);
}

Vector3<Dual> dual(const Vec3& v, int first) {
  return {Dual(v[0], Closing::kInputs, first), Dual(v[1], Closing::kInputs, first + 1),
          Dual(v[2], Closing::kInputs, first + 2)};
}

}  // namespace

LinePairClosing line_pair_closing(const LinePairWay& w, bool derivatives) {
  Closing c;
  c.by.setZero();
  if (!derivatives) {
    c.value = closing<double>(w.away, w.away_before, w.slope, w.slope_before, w.along, w.along_before);
  } else {
    const Dual d = closing<Dual>(dual(w.away, Closing::kAway), dual(w.away_before, Closing::kAwayBefore),
                                 dual(w.slope, Closing::kSlope), dual(w.slope_before, Closing::kSlopeBefore),
                                 dual(w.along, Closing::kAlong), dual(w.along_before, Closing::kAlongBefore));
    c.value = d.value(), c.by = d.derivatives();
  }
  if (!(c.value > 0)) c.value = 0, c.by.setZero();
  return c;
}

}  // namespace hawser
