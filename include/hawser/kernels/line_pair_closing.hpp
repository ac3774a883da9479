// How far two lines came nearer to each other where they touch, sliding apart: what material that is new to a
// contact needs to know about how long the contact has been there. See docs/theory/line-line.md. Pure.
#pragma once

#include <Eigen/Core>

#include "hawser/math/types.hpp"

namespace hawser {

// Of two material points, x of one line and y of the other, which touch at the end of a step.
struct LinePairWay {
  Vec3 away, away_before;    // m, x - y at the end of the step and at its start
  Vec3 slope, slope_before;  // dx/dxi of the line of x, m: at the end and at the start
  Vec3 along, along_before;  // dy/deta of the line of y, m
};

struct LinePairClosing {
  // Rows of `by`: as in LinePairWay.
  static constexpr int kAway = 0, kAwayBefore = 3, kSlope = 6, kSlopeBefore = 9, kAlong = 12,
                       kAlongBefore = 15, kInputs = 18;
  double value = 0;                      // m, >= 0
  Eigen::Matrix<double, kInputs, 1> by;  // filled on request
};

// Of the way that x has come nearer to y along the normal, what neither line makes by sliding along itself. A
// crossing that sweeps along a line has none, however far from it the material was that it meets; a line that
// is laid down, wound up or strikes has all of it.
LinePairClosing line_pair_closing(const LinePairWay& way, bool derivatives);

}  // namespace hawser
