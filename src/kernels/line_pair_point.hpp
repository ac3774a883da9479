// A point of the slave of a pair of lines and what it brings from the start of the step.
#pragma once

#include "hawser/kernels/line_pair.hpp"

namespace hawser {

struct LinePairPass::Point {
  double xi = 0;
  AxisProjection foot;
  AxisShape::Weights H, G;  // slave's at xi, master's at eta
  Vec3 slope, along;        // x', y', m
  Vec3 velocity;            // m/s, of x relative to y
  Mat3 Ta, Tb;              // turns of the sections
  Vec3 was;                 // m, x - y of the same material at the start
};

// What a material point of the slave brings from the start of the step. Derivatives along the slave, along
// the master, and by the generalised positions at these places.
struct LinePairPass::Start {
  double slip[2] = {0, 0}, slip_slope[2] = {0, 0};
  double closing = 0, closing_xi = 0, closing_eta = 0;
  std::array<Vec3, AttachedForces::kPositions> closing_by;
};

}  // namespace hawser
