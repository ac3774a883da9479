// Positions at which forces act, attached to the nodes of a model, and transfer of forces and tangents from
// them to the nodes' blocks. The position X or the rotation R of a node may be excluded: a cable node is X,
// the tangent at the end of a beam times its length is R y (axis_shape.hpp), a point of a body is both.
#pragma once

#include <array>

#include "hawser/kernels/frame_point.hpp"

namespace hawser {

// Force on up to eight blocks (3n) and its derivatives (3n x 3n), with fixed-capacity storage.
using BlockVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 24, 1>;
using BlockMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 24, 24>;

struct AttachedPosition {
  int position = -1, rotation = -1;  // blocks of the stencil; -1: none
  FramePoint point;
};

// 3x3 block of a matrix.
template <class Matrix>
auto block_of(Matrix& m, size_t row, size_t column) {
  return m.template block<3, 3>(3 * static_cast<Eigen::Index>(row), 3 * static_cast<Eigen::Index>(column));
}

// Part of the residual: minus the forces on the positions [N], followed by minus the couples on nodes,
// conjugate to their small rotations in space axes [N m], with their derivatives by both and by the
// velocities of the positions.
struct AttachedForces {
  static constexpr size_t kPositions = 8, kTurns = 4, kMaxRows = kPositions + kTurns;
  size_t positions;
  bool rotates;  // couples act: rows and columns from kPositions are used
  std::array<Vec3, kMaxRows> F;
  // In 3x3 blocks, a row and a column for each of F (block_of).
  Eigen::Matrix<double, 3 * kMaxRows, 3 * kMaxRows, Eigen::RowMajor> K;
  Eigen::Matrix<double, 3 * kMaxRows, 3 * kPositions, Eigen::RowMajor> C;

  // All zero. Without derivatives K and C are not initialised; without couples only their blocks of positions
  // are.
  explicit AttachedForces(int positions, bool rotates = false, bool derivatives = true);
};

// Blocks to which positions are attached.
struct Stencil {
  int blocks = 0;
  size_t positions = 0;
  std::array<AttachedPosition, AttachedForces::kPositions> attached;
  std::array<AttachedPosition, AttachedForces::kTurns> turns;  // rotation and its R; none for a cable

  void add(const AttachedPosition& p) { attached[positions++] = p; }
  // Adds to f (3n), K and C (3n x 3n), n = blocks; K and C may both be null, or C alone if g.C is zero.
  // turning: include in K the rotation of the arms with their nodes, which may be negative stiffness.
  void to_blocks(const AttachedForces& g, bool turning, BlockVector& f, BlockMatrix* K, BlockMatrix* C) const;
};

}  // namespace hawser
