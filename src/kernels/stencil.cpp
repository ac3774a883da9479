// Chain rule from attached positions and rotations to the blocks of nodes.
#include "hawser/kernels/stencil.hpp"

#include "hawser/math/wide3.hpp"

namespace hawser {
namespace {

// Block on which a row of forces acts: increments of the block change the quantity conjugate to the row by E,
// and its velocity by D (FramePoint::by_turn(), velocity_by_turn()).
struct Part {
  int block = -1;
  bool turns = false;
  wide::Mat E = {}, D = {};
};
struct StencilPoint {
  size_t index = 0;
  bool couple = false;
  const AttachedPosition* attached = nullptr;
  std::array<Part, 2> parts;
  size_t count = 0;

  void add(int block) { parts[count++] = {block}; }
  void add_turning(int block, const Mat3& E, const Mat3& D) {
    parts[count++] = {block, true, wide::load(E), wide::load(D)};
  }
  auto begin() const { return parts.begin(); }
  auto end() const { return parts.begin() + static_cast<std::ptrdiff_t>(count); }
};

// 3x3 block of a row-major matrix.
template <class Matrix>
wide::Mat block_at(const Matrix& m, size_t row, size_t column) {
  constexpr size_t kWidth = Matrix::ColsAtCompileTime;
  const double* p = m.data() + 3 * (row * kWidth + column);
  const auto line = [p](size_t i) { return wide::Row{p[i], p[i + 1], p[i + 2], 0}; };
  return {{line(0), line(kWidth), line(2 * kWidth)}};
}

}  // namespace

AttachedForces::AttachedForces(int n, bool couples, bool derivatives)
    : positions(static_cast<size_t>(n)), rotates(couples) {
  F.fill(Vec3::Zero());
  if (!derivatives) return;
  if (couples) {
    K.setZero();
    C.setZero();
  } else {
    K.topLeftCorner(3 * n, 3 * n).setZero();
    C.topLeftCorner(3 * n, 3 * n).setZero();
  }
}

void Stencil::to_blocks(const AttachedForces& g, bool turning, BlockVector& f, BlockMatrix* K,
                        BlockMatrix* C) const {
  std::array<StencilPoint, AttachedForces::kMaxRows> rows;
  size_t count = 0;
  for (size_t i = 0; i < g.positions; ++i) {
    const AttachedPosition& p = attached[i];
    StencilPoint& r = rows[count++];
    r.index = i;
    r.attached = &p;
    if (p.position >= 0) r.add(p.position);
    if (p.rotation >= 0) r.add_turning(p.rotation, p.point.by_turn(), p.point.velocity_by_turn());
  }
  for (size_t i = 0; g.rotates && i < turns.size(); ++i) {
    if (turns[i].rotation < 0) continue;
    StencilPoint& r = rows[count++];
    r.index = AttachedForces::kPositions + i;
    r.couple = true;
    r.attached = &turns[i];
    r.add_turning(turns[i].rotation, turns[i].point.R, Mat3::Zero());
  }
  const auto put = [](BlockMatrix& to, int i, int j, const wide::Mat& b) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) to(3 * i + r, 3 * j + c) += b.r[r][c];
  };
  for (size_t i = 0; i < count; ++i)
    for (const Part& p : rows[i]) {
      const StencilPoint& row = rows[i];
      const Vec3& F = g.F[row.index];
      const Vec3 on_block = p.turns ? wide::vec(wide::left(wide::load(F), p.E)) : F;
      f.segment<3>(3 * p.block) += on_block;
      if (!K) continue;
      for (size_t j = 0; j < count; ++j)
        for (const Part& q : rows[j]) {
          const StencilPoint& column = rows[j];
          wide::Mat k = block_at(g.K, row.index, column.index);
          if (q.turns) k = k * q.E;
          if (C && !column.couple) {
            wide::Mat c = block_at(g.C, row.index, column.index);
            if (q.turns) {
              k += c * q.D;
              c = c * q.E;
            }
            if (p.turns) c = wide::transposed_times(p.E, c);
            put(*C, p.block, q.block, c);
          }
          if (p.turns) k = wide::transposed_times(p.E, k);
          put(*K, p.block, q.block, k);
        }
      if (!p.turns || !turning) continue;
      // Arm and couple, in material axes, rotate with the node.
      const FramePoint& point = row.attached->point;
      put(*K, p.block, p.block,
          wide::load(row.couple ? point.components_by_turn(F) : point.moment_by_turn(F)));
    }
}

}  // namespace hawser
