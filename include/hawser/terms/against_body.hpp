// Reaction of a line's contact on the floating body that the line touches.
//
// The contact force depends on the position and velocity of the line (or of another body) relative to the
// body. A rigid motion of both only rotates the forces. Let u be the unknowns of the line, z = (X, theta)
// those of the body's centre of mass (theta in body axes), and G the derivative of u by z for a line that
// moves rigidly with the body:
//   G = [I, E] for a position, E of its FramePoint,   G = [0, Q'R] for the rotation Q of a node.
// The forces on the body are -G'f, and the derivatives by its unknowns are those by the line's unknowns times
// G and those of the vectors that turn with the body (FramePoint::vector_by_turn), with a_theta = -hat(a) R:
//   f_z = -K G + ([f_theta of positions] - C (v - V)_theta) on theta,   f_zdot = -C G.
#pragma once

#include <span>

#include "hawser/math/types.hpp"
#include "hawser/system/assembler.hpp"

namespace hawser {

struct LineBlock {
  int block = 0;  // local
  bool turns = false;
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, position and velocity of the node
  Mat3 R = Mat3::Identity();                // rotation of the node
};

// The blocks of an element of a line: the positions of its two nodes, and with the rotations of a beam four.
// AgainstBody has no space for more.
struct LineBlocks : std::span<const LineBlock> {
  LineBlocks(std::span<const LineBlock, 2> of_cable) : span(of_cable) {}
  LineBlocks(std::span<const LineBlock, 4> of_beam) : span(of_beam) {}
};

struct FloatingFrame {
  int block = 0;                            // local block of the position of the body's node
  Vec3 x = Vec3::Zero(), v = Vec3::Zero();  // m, m/s, position and velocity of that node
  Mat3 R = Mat3::Identity();
};

// Residual f and derivatives K and C for the blocks of a line, followed by the two blocks of the body.
struct AgainstBody {
  static constexpr int kBlocks = 6, kMost = 3 * kBlocks;  // four of a beam's ends, two of the body
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMost, kMost>;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1> f;
  Matrix K, C;  // empty where the input was null
};
// Extends f [3n], K and C [3n x 3n, or null] of n blocks of a line to the body. turning: include
// the rotation of the forces and of their arms about the body, which may make the stiffness negative.
AgainstBody against_body(LineBlocks line, const FloatingFrame& body, bool turning, const BlockVector& f,
                         const BlockMatrix* K, const BlockMatrix* C);

// Adds the result of against_body() to the assembler. counted: this rank adds the body's rows, whichever rank
// owns the body.
void add_against_body(Assembler& assembler, LineBlocks line, const FloatingFrame& body, bool counted,
                      const BlockVector& f, const BlockMatrix* K, const BlockMatrix* C);

}  // namespace hawser
