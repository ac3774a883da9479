// The chain rule from attached positions and rotations to the blocks of nodes.
#include "hawser/kernels/stencil.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// A block that a row of forces acts on: increments of the block move what the row is conjugate to by E, and
// turn its velocity by D.
struct Part {
  int block = -1;
  bool turns = false;
  Mat3 E, D;
};
struct Row {
  size_t index = 0;
  bool couple = false;
  const AttachedPosition* of = nullptr;
  std::array<Part, 2> parts;
  size_t count = 0;

  void add(const Part& p) { parts[count++] = p; }
  auto begin() const { return parts.begin(); }
  auto end() const { return parts.begin() + static_cast<std::ptrdiff_t>(count); }
};

}  // namespace

AttachedForces::AttachedForces(int n, bool couples, bool derivatives)
    : positions(static_cast<size_t>(n)), rotates(couples) {
  F.fill(Vec3::Zero());
  if (derivatives) K.setZero(), C.setZero();
}

void Stencil::to_blocks(const AttachedForces& g, bool turning, double* f, double* K, double* C) const {
  std::array<Row, AttachedForces::kMost> rows;
  size_t count = 0;
  for (size_t i = 0; i < g.positions; ++i) {
    const AttachedPosition& p = at[i];
    Row& r = rows[count++];
    r.index = i, r.of = &p;
    if (p.position >= 0) r.add({p.position, false, {}, {}});
    if (p.rotation >= 0) r.add({p.rotation, true, -p.R * hat(p.arm), -p.R * hat(p.w.cross(p.arm))});
  }
  for (size_t i = 0; g.rotates && i < turns.size(); ++i) {
    if (turns[i].rotation < 0) continue;
    Row& r = rows[count++];
    r.index = AttachedForces::kPositions + i, r.couple = true, r.of = &turns[i];
    r.add({turns[i].rotation, true, turns[i].R, {}});
  }
  const int m = 3 * blocks;
  const auto put = [m](double* to, int i, int j, const Mat3& b) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) to[(3 * i + r) * m + 3 * j + c] += b(r, c);
  };
  for (size_t i = 0; i < count; ++i)
    for (const Part& p : rows[i]) {
      const Row& row = rows[i];
      const Vec3& F = g.F[row.index];
      const Vec3 on_block = p.turns ? Vec3(p.E.transpose() * F) : F;
      for (int r = 0; r < 3; ++r) f[3 * p.block + r] += on_block[r];
      if (!K) continue;
      for (size_t j = 0; j < count; ++j)
        for (const Part& q : rows[j]) {
          const Row& column = rows[j];
          Mat3 k = block_of(g.K, row.index, column.index);
          if (q.turns) k = k * q.E;
          if (!column.couple) {
            Mat3 c = block_of(g.C, row.index, column.index);
            if (q.turns) k += c * q.D, c = c * q.E;
            if (p.turns) c = p.E.transpose() * c;
            put(C, p.block, q.block, c);
          }
          if (p.turns) k = p.E.transpose() * k;
          put(K, p.block, q.block, k);
        }
      if (!p.turns || !turning) continue;
      // Arm and couple, in material axes, turn with the node.
      const Mat3 by_turn = hat(row.of->R.transpose() * F);
      put(K, p.block, p.block, row.couple ? by_turn : Mat3(hat(row.of->arm) * by_turn));
    }
}

}  // namespace hawser
