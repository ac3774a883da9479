// Where terms put force and tangent. It alone knows the integrator's weights, the retraction, ghosts,
// constraints and the matrix; a term only names its local 3-blocks.
#pragma once

#include <petscmat.h>

#include <span>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

// J = wK K T + wC C + wM M, where T is the right Jacobian of the step's rotation increments, plus a shift of
// the free diagonal: N/m on positions, N m on rotations.
struct Weights {
  double K = 1, C = 0, M = 0;
  double shift_position = 0, shift_rotation = 0;
};

class Sink {
 public:
  static constexpr int kMaxBlocks = 8;

  bool wants_force() const { return force_ != nullptr; }
  bool wants_tangent() const { return matrix_ != nullptr; }
  // True far from a static solution: leave out negative geometric stiffness.
  bool convex() const { return convex_; }

  // blocks: n local 3-blocks; f: 3n; K, C, M: (3n)x(3n) row-major or null. Configuration derivatives are
  // with respect to material rotation increments at the trial rotation; C and M by (v, w) and (a, alpha).
  void add(std::span<const int> blocks, const double* f, const double* K, const double* C, const double* M);

 private:
  friend class System;
  std::vector<double>* force_ = nullptr;  // 3 * local blocks
  // Sums of squares of what was added to owned rows, by line: positions and rotations in turn.
  std::vector<double>* squares_ = nullptr;
  const std::vector<int>* square_of_block_ = nullptr;  // where a local block's rows are summed
  Mat matrix_ = nullptr;
  Weights weights_;
  bool convex_ = false;
  int owned_blocks_ = 0;
  const std::vector<int>* global_block_ = nullptr;
  const std::vector<Mat3>* retraction_ = nullptr;   // per local block; empty: identity everywhere
  const std::vector<char>* is_rotation_ = nullptr;  // per local block
  const std::vector<unsigned char>* held_ =
      nullptr;  // per local block: bit c set when component c is prescribed
};

}  // namespace hawser
