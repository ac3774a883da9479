// How force and tangent on the nodes of a line are extended to the floating body that bears the opposite
// force, for contact with volumes.
#include "hawser/terms/against_body.hpp"

#include <array>

#include "hawser/math/so3.hpp"

namespace hawser {

AgainstBody against_body(std::span<const LineBlock> line, const FloatingFrame& body, bool turning,
                         const double* f, const double* K, const double* C) {
  using Matrix = AgainstBody::Matrix;
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(line.size()), m = n + 6;
  const Eigen::Map<const Eigen::VectorXd> on_line(f, n);
  Matrix G = Matrix::Zero(n, 6);
  for (size_t i = 0; i < line.size(); ++i) {
    const LineBlock& l = line[i];
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
    if (l.turns) {
      G.block<3, 3>(at, 3) = l.R.transpose() * body.R;
      continue;
    }
    G.block<3, 3>(at, 0).setIdentity();
    G.block<3, 3>(at, 3) = -hat(l.x - body.x) * body.R;
  }
  AgainstBody out;
  out.f.resize(m);
  out.f << on_line, -G.transpose() * on_line;
  if (K) {
    const Eigen::Map<const Matrix> KL(K, n, n);
    out.K = Matrix::Zero(m, m);
    out.K.topLeftCorner(n, n) = KL;
    Matrix by_body = -KL * G;
    Matrix turned = Matrix::Zero(6, n + 6);
    if (turning) {
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
    out.K.topRightCorner(n, 6) = by_body;
    out.K.bottomRows(6) = turned;
    out.K.bottomRows(6) -= G.transpose() * out.K.topRows(n);
  }
  if (C) {
    const Eigen::Map<const Matrix> CL(C, n, n);
    out.C = Matrix::Zero(m, m);
    out.C.topLeftCorner(n, n) = CL;
    out.C.topRightCorner(n, 6) = -CL * G;
    out.C.bottomRows(6) = -G.transpose() * out.C.topRows(n);
  }
  return out;
}

// Rows of the line by all who own some, those of the body once.
void add_against_body(Assembler& assembler, std::span<const LineBlock> line, const FloatingFrame& body,
                      bool counted, const double* f, const double* K, const double* C) {
  const AgainstBody all = against_body(line, body, !assembler.convex(), f, K, C);
  std::array<int, Assembler::kMaxBlocks> blocks{};
  for (size_t i = 0; i < line.size(); ++i) blocks[i] = line[i].block;
  blocks[line.size()] = body.block;
  blocks[line.size() + 1] = body.block + 1;
  const Eigen::Index m = all.f.size();
  const auto only = [&](Eigen::Index first, Eigen::Index rows, bool send) {
    AgainstBody part = all;
    const auto cut = [&](auto& of) {
      if (of.size() == 0) return;
      of.topRows(first).setZero();
      of.bottomRows(m - first - rows).setZero();
    };
    cut(part.f);
    cut(part.K);
    cut(part.C);
    assembler.send(send);
    assembler.add({blocks.data(), line.size() + 2}, part.f.data(), K ? part.K.data() : nullptr,
                  C ? part.C.data() : nullptr, nullptr);
    assembler.send(false);
  };
  only(0, m - 6, false);
  if (counted) only(m - 6, 6, true);
}

}  // namespace hawser
