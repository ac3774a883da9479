// Adds the reaction of a line's contact to the floating body that it touches.
//
// Contact depends on the position and velocity of a line (or another body) relative to the body: a rigid
// motion of both only turns the forces. Let u be the unknowns of the line, z = (X, theta) those of the body's
// centre of mass (theta in body axes), and G the derivative of u by z if the line moved rigidly with the
// body,
//   G = [I, -hat(r) R] of a position x = X + r,   G = [0, Q'R] of the rotation Q of a node,
// the forces on the body are -G'f, and the derivatives by its unknowns follow from those by the line's:
//   f_z = -K G + (C hat(v - V) R + [-hat(f) R of positions]) on theta,   f_zdot = -C G.
#pragma once

#include <span>

#include "hawser/math/types.hpp"
#include "hawser/system/assembler.hpp"

namespace hawser {

struct LineBlock {
  int block = 0;  // local
  bool turns = false;
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, of the node
  Mat3 R = Mat3::Identity();                // of the node's rotation
};

struct FloatingFrame {
  int block = 0;                            // local, of the position of its node
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, of the node
  Mat3 R = Mat3::Identity();
};

// f, K and C of the blocks of a line and, behind them, of the two of the body.
struct AgainstBody {
  static constexpr int kBlocks = 6, kMost = 3 * kBlocks;  // of the ends of a beam and of a body
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMost, kMost>;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1> f;
  Matrix K, C;  // of no size where there was none
};
// Of f[3n], K and C [3n x 3n, row-major or null] of n blocks of a line. turning: with how forces, and their
// arms about the body, turn, which may be negative stiffness.
AgainstBody against_body(std::span<const LineBlock> line, const FloatingFrame& body, bool turning,
                         const double* f, const double* K, const double* C);

// Adds them, n <= 4. counted: this rank adds the body's rows, whoever owns them.
void add_against_body(Assembler& assembler, std::span<const LineBlock> line, const FloatingFrame& body,
                      bool counted, const double* f, const double* K, const double* C);

}  // namespace hawser
