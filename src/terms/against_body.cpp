// Extends residual and tangent of contact from the nodes of a line to the floating body it touches.
#include "hawser/terms/against_body.hpp"

#include <array>

#include "hawser/kernels/frame_point.hpp"

namespace hawser {

// With the moment m of f at a position, or m = R'Q M of a moment M in the axes of a node with the rotation Q,
// and s = sum m, both in axes of the body:
//   f_z = -K G + (f_theta - C (v - V)_theta) on theta
//   tau_x = -m_x - (G'K)_theta,   tau_X = sum m_x + ...,   tau_theta = -s_theta - G' f_z
// where f and v - V turn with the body, and s is fixed in space (docs/theory/frames.md#tangent).
AgainstBody against_body(LineBlocks line, const FloatingFrame& body, bool turning, const BlockVector& f,
                         const BlockMatrix* K, const BlockMatrix* C) {
  using Matrix = AgainstBody::Matrix;
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(line.size());
  const Eigen::Index m = n + 6;
  const auto point = [&](const LineBlock& l) {
    return FramePoint{body.R.transpose() * (l.x - body.x), body.R};
  };
  // A node's rotation in the axes of the body: its moments turn with it.
  const auto node = [&](const LineBlock& l) { return FramePoint{Vec3::Zero(), body.R.transpose() * l.R}; };
  Matrix G = Matrix::Zero(n, 6);
  for (size_t i = 0; i < line.size(); ++i) {
    const LineBlock& l = line[i];
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
    if (l.turns) {
      G.block<3, 3>(at, 3) = node(l).R.transpose();
      continue;
    }
    G.block<3, 3>(at, 0).setIdentity();
    G.block<3, 3>(at, 3) = point(l).by_turn();
  }
  AgainstBody out;
  out.f.resize(m);
  out.f << f, -G.transpose() * f;
  if (K) {
    out.K = Matrix::Zero(m, m);
    out.K.topLeftCorner(n, n) = *K;
    Matrix by_body = -(*K * G);
    Matrix turned = Matrix::Zero(6, n + 6);
    if (turning) {
      const FramePoint centre{Vec3::Zero(), body.R};
      Vec3 sum = Vec3::Zero();  // moment about the body, space axes
      for (size_t i = 0; i < line.size(); ++i) {
        const LineBlock& l = line[i];
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
        const Vec3 fi = f.segment<3>(at);
        if (l.turns) {
          const FramePoint q = node(l);
          turned.block<3, 3>(3, at) = -q.vector_by_turn(q.R * fi);
          sum += l.R * fi;
          continue;
        }
        const FramePoint p = point(l);
        by_body.block<3, 3>(at, 3) += p.vector_by_turn(fi);
        if (C) by_body.middleCols<3>(3) -= C->middleCols<3>(at) * p.vector_by_turn(l.v - body.v);
        turned.block<3, 3>(3, at) = -p.moment_by_position(fi);
        turned.block<3, 3>(3, n) += p.moment_by_position(fi);
        sum += p.arm().cross(fi);
      }
      turned.block<3, 3>(3, n + 3) -= centre.components_by_turn(sum);
    }
    out.K.topRightCorner(n, 6) = by_body;
    out.K.bottomRows(6) = turned;
    out.K.bottomRows(6) -= G.transpose() * out.K.topRows(n);
  }
  if (C) {
    out.C = Matrix::Zero(m, m);
    out.C.topLeftCorner(n, n) = *C;
    out.C.topRightCorner(n, 6) = -(*C * G);
    out.C.bottomRows(6) = -G.transpose() * out.C.topRows(n);
  }
  return out;
}

// Every rank that owns some of the line's rows adds those; one rank adds the body's rows.
void add_against_body(Assembler& assembler, LineBlocks line, const FloatingFrame& body, bool counted,
                      const BlockVector& f, const BlockMatrix* K, const BlockMatrix* C) {
  const AgainstBody all = against_body(line, body, !assembler.convex(), f, K, C);
  const size_t n = line.size();
  std::array<int, AgainstBody::kBlocks> numbers{};
  const std::span<const int> blocks(numbers.data(), n + 2);
  for (size_t i = 0; i < n; ++i) numbers[i] = line[i].block;
  numbers[n] = body.block;
  numbers[n + 1] = body.block + 1;
  const auto add = [&](size_t first, size_t count) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(first);
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(count);
    const auto rows = [row, size](const AgainstBody::Matrix& of) {
      return of.size() > 0 ? DerivativeView(of.middleRows(row, size)) : DerivativeView();
    };
    assembler.add(blocks.subspan(first, count), blocks, all.f.segment(row, size), rows(all.K), rows(all.C),
                  {});
  };
  add(0, n);
  if (!counted) return;
  assembler.send(true);
  add(n, 2);
  assembler.send(false);
}

}  // namespace hawser
