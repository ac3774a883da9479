// How force and tangent on the nodes of a line are extended to the floating body that bears the opposite
// force, for contact with volumes.
#include "hawser/terms/against_body.hpp"

#include <array>

#include "hawser/math/so3.hpp"

namespace hawser {

void add_against_body(Assembler& assembler, std::span<const LineBlock> line, const FloatingFrame& body,
                      bool counted, const double* f, const double* K, const double* C) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(line.size()), m = n + 6;
  const Eigen::Map<const Eigen::VectorXd> on_line(f, n);
  std::array<int, Assembler::kMaxBlocks> blocks{};
  Matrix G = Matrix::Zero(n, 6);
  for (size_t i = 0; i < line.size(); ++i) {
    const LineBlock& l = line[i];
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
    blocks[i] = l.block;
    if (l.turns) {
      G.block<3, 3>(at, 3) = l.R.transpose() * body.R;
      continue;
    }
    G.block<3, 3>(at, 0).setIdentity();
    G.block<3, 3>(at, 3) = -hat(l.x - body.x) * body.R;
  }
  blocks[line.size()] = body.block, blocks[line.size() + 1] = body.block + 1;
  Eigen::VectorXd force(m);
  force << on_line, -G.transpose() * on_line;
  Matrix k, c;
  if (K) {
    const Eigen::Map<const Matrix> KL(K, n, n);
    k = Matrix::Zero(m, m);
    k.topLeftCorner(n, n) = KL;
    Matrix by_body = -KL * G;
    // The turning of the forces, and of the arms they have about the body: left out far from a solution.
    Matrix turned = Matrix::Zero(6, n + 6);
    if (!assembler.convex()) {
      Vec3 sum = Vec3::Zero();  // moment about the body, its axes
      for (size_t i = 0; i < line.size(); ++i) {
        const LineBlock& l = line[i];
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
        const Vec3 fi = on_line.segment<3>(at);
        if (l.turns) {
          const Mat3 Q = body.R.transpose() * l.R;
          turned.block<3, 3>(3, at) = Q * hat(fi);
          sum += Q * fi;
          continue;
        }
        by_body.block<3, 3>(at, 3) -= hat(fi) * body.R;
        if (C) {
          const Eigen::Map<const Matrix> CL(C, n, n);
          by_body.middleCols<3>(3) += CL.middleCols<3>(at) * hat(l.v - body.v) * body.R;
        }
        turned.block<3, 3>(3, at) = body.R.transpose() * hat(fi);
        turned.block<3, 3>(3, n) -= body.R.transpose() * hat(fi);
        sum += body.R.transpose() * (l.x - body.x).cross(fi);
      }
      turned.block<3, 3>(3, n + 3) -= hat(sum);
    }
    k.topRightCorner(n, 6) = by_body;
    k.bottomRows(6) = turned;
    k.bottomRows(6) -= G.transpose() * k.topRows(n);
  }
  if (C) {
    const Eigen::Map<const Matrix> CL(C, n, n);
    c = Matrix::Zero(m, m);
    c.topLeftCorner(n, n) = CL;
    c.topRightCorner(n, 6) = -CL * G;
    c.bottomRows(6) = -G.transpose() * c.topRows(n);
  }
  // Rows of the line by all who own some, those of the body once.
  const std::span<const int> all(blocks.data(), line.size() + 2);
  const auto only = [&](Eigen::Index first, Eigen::Index rows, bool send) {
    Eigen::VectorXd fp = Eigen::VectorXd::Zero(m);
    fp.segment(first, rows) = force.segment(first, rows);
    const auto part = [&](const Matrix& of) {
      Matrix out = Matrix::Zero(m, m);
      out.middleRows(first, rows) = of.middleRows(first, rows);
      return out;
    };
    const Matrix kp = K ? part(k) : Matrix(), cp = C ? part(c) : Matrix();
    assembler.send(send);
    assembler.add(all, fp.data(), K ? kp.data() : nullptr, C ? cp.data() : nullptr, nullptr);
    assembler.send(false);
  };
  only(0, n, false);
  if (counted) only(n, 6, true);
}

}  // namespace hawser
