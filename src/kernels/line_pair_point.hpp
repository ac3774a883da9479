// A point of the slave of a pair of lines, and its state at the start of the step.
#pragma once

#include <algorithm>

#include "hawser/kernels/line_pair.hpp"
#include "hawser/kernels/line_pair_closing.hpp"

namespace hawser {

// Rotation of the sections of a cable whose unit chord went from f to t: the smallest rotation. Beyond the
// limit it is no rotation but still smooth.
inline Mat3 section_turn(const Vec3& f, const Vec3& t) {
  const Vec3 sum = f + t;
  return Mat3::Identity() - sum * sum.transpose() / std::max(1 + f.dot(t), kHalfRound) +
         2 * t * f.transpose();
}

struct LinePairPass::Point {
  double xi = 0;
  AxisProjection foot;
  AxisShape::Weights H, G;  // slave's at xi, master's at eta
  Vec3 slope, along;        // x', y', m
  Vec3 velocity;            // m/s, of x relative to y
  Mat3 Ta, Tb;              // rotations of the sections
  Vec3 before;              // m, x - y of the same material at the start of the step
};

// State of a material point of the slave at the start of the step: its slip with the derivative along the
// slave, or that it did not touch.
struct LinePairPass::Start {
  bool is_new = false;
  double slip[2] = {0, 0}, slip_slope[2] = {0, 0};
};

}  // namespace hawser
