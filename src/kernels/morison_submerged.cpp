// Buoyancy, drag, added mass and Froude-Krylov force of four submerged cable elements at once in vector
// arithmetic, with their weighted tangent: the residual and the blocks of morison_points.hpp (a cable, F =
// 1), in the form of docs/theory/water.md#four-submerged-cables-at-once.
#include "hawser/kernels/morison_submerged.hpp"

#include "hawser/math/gauss_points.hpp"
#include "hawser/math/triple.hpp"
#include "morison_formula.hpp"

namespace hawser {
namespace {

using wide::Lanes4;

using Vec = Triple<Lanes4>;  // of four elements
Vec lanes(const Lanes4* p) { return {{p[0], p[1], p[2]}}; }

constexpr auto& kGaussPoints = GaussPoints<2>::unit;

// Symmetric matrix: xx, yy, zz, xy, xz, yz.
struct Symmetric {
  Lanes4 c[6];
};
constexpr int kPlace[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

struct Chords {
  Lanes4 inverse;  // 1/m, of their lengths; 0 where that is 0
  Vec t;           // unit vectors
  explicit Chords(const CablesInWater4& m) {
    const Vec chord = lanes(m.x[1]) - lanes(m.x[0]);
    const Lanes4 l = wide::sqrt(dot(chord, chord));
    inverse = l > 0 ? 1 / l : Lanes4{};
    t = inverse * chord;
  }
};

// Closed-form integrals along the element; k is the node other than j:
//   y_j = L/12 (5 a_j + a_k) - w_j,  w_j = L/6 (2 a_w,j + a_w,k),
//   f_j = (m_n P + m_t t t') y_j - m_d w_j - L/2 rho g A e.
template <bool moving>
inline void inertia_and_buoyancy(const WaterSections4& s, const CablesInWater4& m, const Chords& c,
                                 Vec (&y)[2], Vec (&f)[2]) {
  const Lanes4 ma = s.added_axial - s.added_normal;
  for (int j = 0; j < 2; ++j) {
    const int k = 1 - j;
    y[j] = (s.length * (1. / 12)) * (5.0 * lanes(m.a[j]) + lanes(m.a[k]));
    Vec water;
    if constexpr (moving) {
      water = (s.length * (1. / 6)) * (2.0 * lanes(m.acceleration[j]) + lanes(m.acceleration[k]));
      y[j] = y[j] - water;
    }
    f[j] = morison_formula::added_mass(s.added_normal, ma, c.t, y[j]);
    if constexpr (moving) f[j] = f[j] - s.displaced_mass * water;
    f[j].c[2] -= 0.5 * s.length * s.buoyancy;
  }
}

// Sums over the two points, w = L/2 each: C_jk of N_j N_k w S, and N_j w T = by_un + by_P P of each node.
struct DragSums {
  Symmetric C[3] = {};  // 00, 01, 11
  Lanes4 by_un[2][3][3] = {};
  Lanes4 by_P[2] = {};
};

// f_j = -N_j w drag.
template <bool tangent, bool moving>
inline void drag_at_points(const WaterSections4& s, const CablesInWater4& m, const Chords& c, Vec (&f)[2],
                           DragSums& sums) {
  const Vec& t = c.t;
  for (int g = 0; g < 2; ++g) {
    const double N[2] = {1 - kGaussPoints[g], kGaussPoints[g]};
    const Lanes4 w = 0.5 * s.length;
    Vec u = -N[0] * lanes(m.v[0]) - N[1] * lanes(m.v[1]);
    if constexpr (moving) u = u + N[0] * lanes(m.velocity[0]) + N[1] * lanes(m.velocity[1]);
    const morison_formula::Drag<Lanes4, Vec> drag(u, t, s.drag_normal, s.drag_axial);
    const Vec force = w * drag.force();
    const Vec& un = drag.across;
    for (int j = 0; j < 2; ++j) f[j] = f[j] - N[j] * force;
    if constexpr (tangent) {
      const Vec a = (w * drag.over_speed) * un;
      const Vec b = (w * drag.lengthwise()) * t;
      Symmetric S;
      for (int i = 0; i < 3; ++i) {
        S.c[i] = a.c[i] * un.c[i] + b.c[i] * t.c[i] + w * drag.normal;
        for (int k = i + 1; k < 3; ++k) S.c[kPlace[i][k]] = a.c[i] * un.c[k] + b.c[i] * t.c[k];
      }
      for (int e = 0; e < 6; ++e) {
        sums.C[0].c[e] += (N[0] * N[0]) * S.c[e];
        sums.C[1].c[e] += (N[0] * N[1]) * S.c[e];
        sums.C[2].c[e] += (N[1] * N[1]) * S.c[e];
      }
      const Vec first = w * drag.by_across();
      const Lanes4 p = w * drag.by_turn();
      for (int j = 0; j < 2; ++j) {
        sums.by_P[j] += N[j] * p;
        for (int i = 0; i < 3; ++i)
          for (int k = 0; k < 3; ++k) sums.by_un[j][i][k] += (N[j] * first.c[i]) * un.c[k];
      }
    }
  }
}

// J_jn = wK K_jn + wC C_jn + wM M_jn with M_jn = L (5/12 or 1/12) (m_n P + m_t t t').
template <bool moving>
inline void put_blocks(const WaterSections4& s, const CablesInWater4& m, const Chords& chords,
                       const Vec (&y)[2], const DragSums& sums, double wK, double wC, double wM,
                       std::array<Mat6, 4>& J) {
  const Vec& t = chords.t;
  const Lanes4 ma = s.added_axial - s.added_normal;
  const Lanes4 scale = wK * chords.inverse;
  for (int j = 0; j < 2; ++j) {
    // K by x2 and minus K by x1: (-T + (m_t - m_n) (t (P y)' + (t.y) P)) / l, with P = I - t t'.
    const Lanes4 ty = dot(t, y[j]);
    const Vec Py = y[j] - ty * t;
    const Lanes4 onP = ma * ty - sums.by_P[j];
    const Vec row = ma * Py - onP * t;
    Lanes4 chordwise[3][3];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        chordwise[i][k] = scale * (t.c[i] * row.c[k] - sums.by_un[j][i][k]);
        if (i == k) chordwise[i][k] += scale * onP;
      }
    for (int n = 0; n < 2; ++n) {
      const Symmetric& c = sums.C[j + n];
      const Lanes4 mass = (wM * (j == n ? 5. / 12 : 1. / 12)) * s.length;
      const Lanes4 lengthwise = mass * ma;
      for (int i = 0; i < 3; ++i) {
        Lanes4 entry[3];
        for (int k = 0; k < 3; ++k) {
          const Lanes4 turned = n ? chordwise[i][k] : -chordwise[i][k];
          entry[k] = turned + wC * c.c[kPlace[i][k]] + (lengthwise * t.c[i]) * t.c[k];
        }
        entry[i] += mass * s.added_normal;
        if constexpr (moving) {
          const Vec sheared{{c.c[kPlace[i][0]], c.c[kPlace[i][1]], c.c[kPlace[i][2]]}};
          entry[2] -= wK * dot(sheared, lanes(m.by_height[n]));
        }
        for (int k = 0; k < 3; ++k)
          for (int lane = 0; lane < 4; ++lane) J[lane](3 * j + i, 3 * n + k) = entry[k][lane];
      }
    }
  }
}

template <bool tangent, bool moving>
void evaluate(const WaterSections4& s, const CablesInWater4& m, double wK, double wC, double wM,
              std::array<Vec6, 4>& f, std::array<Mat6, 4>* J) {
  const Chords c(m);
  Vec y[2], out[2];
  inertia_and_buoyancy<moving>(s, m, c, y, out);
  DragSums sums;
  drag_at_points<tangent, moving>(s, m, c, out, sums);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i)
      for (int lane = 0; lane < 4; ++lane) f[lane][3 * j + i] = out[j].c[i][lane];
  if constexpr (tangent) put_blocks<moving>(s, m, c, y, sums, wK, wC, wM, *J);
}

}  // namespace

void WaterSections4::set(int lane, const WaterSection& s) {
  length[lane] = s.length;
  radius[lane] = s.radius;
  buoyancy[lane] = s.buoyancy;
  displaced_mass[lane] = s.displaced_mass;
  added_normal[lane] = s.added_normal;
  added_axial[lane] = s.added_axial;
  drag_normal[lane] = s.drag_normal;
  drag_axial[lane] = s.drag_axial;
}

// A section gets wet over its radius above and below the axis; see morison_points.hpp.
unsigned submerged(const WaterSections4& s, const CablesInWater4& m) {
  const Lanes4 h[2] = {m.surface[0] - m.x[0][2], m.surface[1] - m.x[1][2]};
  const Lanes4 lowest = h[0] < h[1] ? h[0] : h[1];
  const auto dry = lowest < s.radius;
  unsigned wet = 0;
  for (int i = 0; i < 4; ++i) wet |= dry[i] ? 0u : 1u << i;
  return wet;
}

void submerged_force(const WaterSections4& s, const CablesInWater4& m, bool moving, std::array<Vec6, 4>& f) {
  if (moving)
    evaluate<false, true>(s, m, 0, 0, 0, f, nullptr);
  else
    evaluate<false, false>(s, m, 0, 0, 0, f, nullptr);
}

void submerged_tangent(const WaterSections4& s, const CablesInWater4& m, bool moving, double wK, double wC,
                       double wM, std::array<Vec6, 4>& f, std::array<Mat6, 4>& J) {
  if (moving)
    evaluate<true, true>(s, m, wK, wC, wM, f, &J);
  else
    evaluate<true, false>(s, m, wK, wC, wM, f, &J);
}

}  // namespace hawser
