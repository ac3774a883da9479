// From the generalised positions of a pair to the blocks of its nodes.
#include "hawser/kernels/line_pair.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {

void to_nodes(const LinePairForces& g, const PairAxis& slave, const PairAxis& master, double* f, double* K,
              double* C) {
  constexpr int kTurns = LinePairForces::kPositions;
  const int na = g.slave, n = g.slave + g.master, m = 3 * n;
  // Of each block: what a generalised position moves by (E) and a velocity turns by (D) with it.
  struct Block {
    bool turn = false;
    int couple = -1;  // index of its rotation
    Mat3 E = Mat3::Identity(), D = Mat3::Zero(), R = Mat3::Identity(), arm = Mat3::Zero();
  };
  std::array<Block, LinePairForces::kPositions> blocks;
  for (int i = 0; i < n; ++i) {
    const bool second = i >= na;
    const PairAxis& axis = second ? master : slave;
    const int j = second ? i - na : i;
    if (!axis.beam() || j % 2 == 0) continue;
    const size_t node = static_cast<size_t>(j / 2);
    Block& b = blocks[static_cast<size_t>(i)];
    b.turn = true;
    b.couple = kTurns + (second ? 2 : 0) + j / 2;
    b.R = axis.to_space[node];
    const Vec3& w = node ? axis.ends.w2 : axis.ends.w1;
    const double L = axis.ends.length;
    b.arm = L * hat(axis.ends.tangent);
    b.E = -b.R * b.arm;
    b.D = -L * b.R * hat(w.cross(axis.ends.tangent));
  }
  const auto put = [m](double* to, int i, int j, const Mat3& b) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) to[(3 * i + r) * m + 3 * j + c] += b(r, c);
  };
  for (int i = 0; i < n; ++i) {
    const size_t a = static_cast<size_t>(i);
    const Block& bi = blocks[a];
    const size_t ca = static_cast<size_t>(bi.couple);
    Vec3 v = bi.turn ? Vec3(bi.E.transpose() * g.F[a]) : g.F[a];
    if (bi.turn && g.rotates) v += bi.R.transpose() * g.F[ca];
    for (int r = 0; r < 3; ++r) f[3 * i + r] += v[r];
    if (!K) continue;
    for (int j = 0; j < n; ++j) {
      const size_t b = static_cast<size_t>(j);
      const Block& bj = blocks[b];
      const size_t cb = static_cast<size_t>(bj.couple);
      // A row of generalised forces, or of couples, to the columns of block j.
      const auto column = [&](size_t row, Mat3& k, Mat3& c) {
        k = g.K[row][b], c = g.C[row][b];
        if (!bj.turn) return;
        k = k * bj.E + c * bj.D;
        c = c * bj.E;
        if (g.rotates) k += g.K[row][cb] * bj.R;
      };
      Mat3 k, c;
      column(a, k, c);
      if (bi.turn) {
        k = bi.E.transpose() * k, c = bi.E.transpose() * c;
        if (i == j) k += bi.arm * hat(bi.R.transpose() * g.F[a]);  // the arm turns with the node
        if (g.rotates) {
          Mat3 kc, cc;
          column(ca, kc, cc);
          k += bi.R.transpose() * kc, c += bi.R.transpose() * cc;
          if (i == j) k += hat(bi.R.transpose() * g.F[ca]);
        }
      }
      put(K, i, j, k), put(C, i, j, c);
    }
  }
}

}  // namespace hawser
