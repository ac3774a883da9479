// Positions that forces act on, attached to the nodes of a model, and the way of forces and tangents from
// them to the nodes' blocks. Of a node's position X and rotation R either may be excluded: a node of a cable
// is X, the tangent at the end of a beam times its length is R y (axis_shape.hpp), a point of a body is both.
#pragma once

#include <array>

#include "hawser/kernels/frame_point.hpp"

namespace hawser {

struct AttachedPosition {
  int position = -1, rotation = -1;  // blocks of the stencil; -1: not of it
  FramePoint point;
};

// Of a matrix in blocks of three: one of them.
template <class Matrix>
auto block_of(Matrix& m, size_t row, size_t column) {
  return m.template block<3, 3>(3 * static_cast<Eigen::Index>(row), 3 * static_cast<Eigen::Index>(column));
}

// Forces conjugate to positions [N], and behind them couples conjugate to small rotations of nodes, in space
// axes [N m], with their derivatives by both and by the velocities of the positions.
struct AttachedForces {
  static constexpr size_t kPositions = 8, kTurns = 4, kMost = kPositions + kTurns;
  size_t positions;
  bool rotates;  // couples act: rows and columns from kPositions on count
  std::array<Vec3, kMost> F;
  // In blocks of three, a row and a column for each of F (block_of).
  Eigen::Matrix<double, 3 * kMost, 3 * kMost, Eigen::RowMajor> K;
  Eigen::Matrix<double, 3 * kMost, 3 * kPositions, Eigen::RowMajor> C;

  // Zero; without derivatives K and C are left as they are.
  explicit AttachedForces(int positions, bool rotates = false, bool derivatives = true);
};

// The blocks that positions are attached to.
struct Stencil {
  int blocks = 0;
  size_t positions = 0;
  std::array<AttachedPosition, AttachedForces::kPositions> at;
  std::array<AttachedPosition, AttachedForces::kTurns> turns;  // rotation and its R; of a cable none

  void add(const AttachedPosition& p) { at[positions++] = p; }
  // Adds to f[3n], K and C (3n)x(3n), row-major, n = blocks; K and C may be null together, and C alone where
  // g.C is zero. turning: K with what forces bring whose arms turn with their nodes, which may be negative
  // stiffness.
  void to_blocks(const AttachedForces& g, bool turning, double* f, double* K, double* C) const;
};

}  // namespace hawser
