// Distance by which two lines approached each other at a contact, without sliding along themselves. It shows
// how long new material in a contact has been in touch. See docs/theory/line-line.md. Pure, for any scalar.
#pragma once

#include <cmath>

#include "hawser/kernels/friction_law.hpp"

namespace hawser {

// If 1 + cosine of the rotation of a line in a step is below this, the rotation counts as half a turn: the
// directions before and after do not determine its axis.
inline constexpr double kHalfRound = 3e-3;

// Two material points, x of one line and y of the other, in contact at the end of a step.
template <class S>
struct LinePairMotion {
  Vector3<S> away, away_before;    // m, x - y at the end of the step and at its start
  Vector3<S> slope, slope_before;  // dx/dxi of the line of x, m, at the end and at the start
  Vector3<S> along, along_before;  // dy/deta of the line of y, m, likewise
};

// Approach of x along the normal, m, excluding the contribution of either line sliding along itself; < 0:
// separation. A crossing that sweeps along a line has none, for any initial distance of the material. A line
// that is laid down, wound up or meets the other in an impact has all of it.
//
// w = x - y minus its value at the start consists of alpha a + beta b and a part normal to both, with the
// unit tangents a and b at the end. With s = (w.a + w.b)/2, d = (w.a - w.b)/2 and c = a.b: alpha, beta = s/(1
// + c) +- d/(1 - c). A line that slides along itself by alpha brings x nearer by -alpha n.t/(a.t), where t is
// the mean of its tangents at start and end; on a circle this is the direction of its displacement.
template <class S>
S line_pair_closing(const LinePairMotion<S>& motion) {
  using std::sqrt;
  // Below an angle of about a tenth of a radian lines count as parallel: it does not matter then which of
  // them slides, and each gets half.
  constexpr double kParallel = 3e-3;
  const auto unit = [](const Vector3<S>& v) -> Vector3<S> { return v / S(sqrt(S(v.squaredNorm()))); };
  const auto quotient = [](const S& v, const S& divisor) -> S {
    return v * divisor / S(divisor * divisor + kParallel * kParallel);
  };
  const Vector3<S> n = unit(motion.away);
  const Vector3<S> w = motion.away - motion.away_before;
  const Vector3<S> a = unit(motion.slope);
  const Vector3<S> b = unit(motion.along);
  const S c = a.dot(b);
  const S wa = w.dot(a);
  const S wb = w.dot(b);
  const S half_sum = quotient(S(0.5 * (wa + wb)), S(1 + c));
  const S half_difference = quotient(S(0.5 * (wa - wb)), S(1 - c));
  const auto approach = [&n](const S& sliding, const Vector3<S>& before, const Vector3<S>& now) -> S {
    const Vector3<S> mean = before + now;
    // A line whose direction reverses within the step, such as one that folds onto itself, does not slide
    // along itself.
    if (!(now.dot(mean) > kHalfRound)) return S(0);
    return -sliding * n.dot(mean) / S(now.dot(mean));
  };
  return -n.dot(w) - approach(S(half_sum + half_difference), unit(motion.slope_before), a) -
         approach(S(half_sum - half_difference), unit(motion.along_before), b);
}

}  // namespace hawser
