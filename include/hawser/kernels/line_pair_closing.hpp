// How far two lines came nearer to each other where they touch, sliding apart: what material that is new to a
// contact needs to know about how long the contact has been there. See docs/theory/line-line.md. Pure, of any
// scalar.
#pragma once

#include <cmath>

#include "hawser/kernels/friction_law.hpp"

namespace hawser {

// 1 + cosine of the turn of a line in a step from which on it counts as half a turn: its directions before
// and after do not say about which axis.
inline constexpr double kHalfRound = 3e-3;

// Of two material points, x of one line and y of the other, which touch at the end of a step.
template <class S>
struct LinePairMotion {
  Vector3<S> away, away_before;    // m, x - y at the end of the step and at its start
  Vector3<S> slope, slope_before;  // dx/dxi of the line of x, m: at the end and at the start
  Vector3<S> along, along_before;  // dy/deta of the line of y, m
};

// m: of the way that x has come nearer to y along the normal, what neither line makes by sliding along
// itself. A crossing that sweeps along a line has none, however far from it the material was that it meets; a
// line that is laid down, wound up or meets the other in an impact has all of it. < 0: they parted.
//
// w = x - y less what it was is alpha a + beta b and what is normal to both, a and b the unit tangents at the
// end; with s = (w.a + w.b)/2, d = (w.a - w.b)/2 and c = a.b it is alpha, beta = s/(1 + c) +- d/(1 - c). A
// line that slides along itself by alpha brings x nearer by -alpha n.t/(a.t), t the mean of its tangents at
// the start and at the end: on a circle this is the direction in which it went.
template <class S>
S line_pair_closing(const LinePairMotion<S>& way) {
  using std::sqrt;
  // Lines at less than about a tenth of a radian count as along each other: which of them slides makes no
  // difference then, and each has half of it.
  constexpr double kParallel = 3e-3;
  const auto unit = [](const Vector3<S>& v) -> Vector3<S> { return v / S(sqrt(S(v.squaredNorm()))); };
  const auto over = [](const S& v, const S& by) -> S { return v * by / S(by * by + kParallel * kParallel); };
  const Vector3<S> n = unit(way.away), w = way.away - way.away_before, a = unit(way.slope),
                   b = unit(way.along);
  const S c = a.dot(b), wa = w.dot(a), wb = w.dot(b);
  const S both = over(S(0.5 * (wa + wb)), S(1 + c)), apart = over(S(0.5 * (wa - wb)), S(1 - c));
  const auto brings = [&n](const S& by, const Vector3<S>& before, const Vector3<S>& now) -> S {
    const Vector3<S> mean = before + now;
    // A line whose direction reverses within the step, as one that folds onto itself, does not slide along
    // it.
    if (!(now.dot(mean) > kHalfRound)) return S(0);
    return -by * n.dot(mean) / S(now.dot(mean));
  };
  return -n.dot(w) - brings(S(both + apart), unit(way.slope_before), a) -
         brings(S(both - apart), unit(way.along_before), b);
}

}  // namespace hawser
