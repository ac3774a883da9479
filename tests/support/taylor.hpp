// Taylor tests of a System: residual against tangent, including everything between a term and the matrix
// (retraction, weights, held components, ghosts).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "hawser/math/so3.hpp"
#include "hawser/system/system.hpp"

namespace hawser::test {

// A number in (-1, 1) for a node, a component and a purpose: the same on every rank.
inline double noise(int node, int component, int purpose) {
  std::uint64_t z =
      static_cast<std::uint64_t>(node * 64 + component) * 1000003u + static_cast<std::uint64_t>(purpose);
  for (int i = 0; i < 2; ++i) {  // splitmix64
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return 2 * (static_cast<double>(z >> 11) + 0.5) / 9007199254740992.0 - 1;
}
inline Vec3 noise3(int node, int purpose) {
  return {noise(node, 0, purpose), noise(node, 1, purpose), noise(node, 2, purpose)};
}

// A trial state: increments u (3 * local blocks) from a committed state, and rates.
struct Trial {
  State from, rates;  // rates: only v, w, a, alpha and the directors are used
  std::vector<double> u;
  double h = 0;
  double length = 0.1, angle = 0.1;  // m, rad: size of the test directions
};

inline State state_of(const LocalMesh& mesh, const Trial& t, double step = 0,
                      const std::vector<double>* direction = nullptr, const Weights& w = {}) {
  State s = t.rates;
  s.time = t.from.time + t.h;
  std::vector<double> u = t.u;
  if (direction) {
    for (size_t i = 0; i < u.size(); ++i) u[i] += w.K * step * (*direction)[i];
    for (int n = 0; n < mesh.nodes(); ++n) {
      const size_t i = static_cast<size_t>(n);
      const double* d = direction->data() + 3 * mesh.block[i];
      const Eigen::Map<const Vec3> dx(d);
      s.v[i] += w.C * step * dx;
      s.a[i] += w.M * step * dx;
      if (!mesh.rotates(n)) continue;
      const Eigen::Map<const Vec3> dt(d + 3);
      s.w[i] += w.C * step * dt;
      s.alpha[i] += w.M * step * dt;
    }
  }
  retract(mesh, t.from, u.data(), s);
  if (s.directors.empty() || !direction) return s;
  // The part of the directors' acceleration that the integrator's weights do not contain when each is applied
  // alone: if the weight of M is director_weight times that of C, the sum equals that of a step.
  State before = s;
  retract(mesh, t.from, t.u.data(), before);
  for (size_t i = 0; i < s.q.size(); ++i) {
    const Mat3 now = s.q[i].toRotationMatrix();
    const Mat3 then = before.q[i].toRotationMatrix();
    s.directors[i] +=
        t.rates.director_weight * (now - then) * hat(t.rates.w[i]) + now * hat(s.alpha[i] - t.rates.alpha[i]);
  }
  return s;
}

// Rows of the blocks that this rank owns.
inline std::vector<double> rows(Vec v) {
  const PetscScalar* p = nullptr;
  PetscInt n = 0;
  check(VecGetLocalSize(v, &n));
  check(VecGetArrayRead(v, &p));
  std::vector<double> out(p, p + n);
  check(VecRestoreArrayRead(v, &p));
  return out;
}
// The state at the end of a step of h [s]; h = 0: in statics.
inline Kinematics at_end(const State& s, double h) { return h > 0 ? s.after_step(h) : s.at_rest(); }
inline std::vector<double> residual(System& system, const State& s, double h) {
  VecHandle r = system.create_vector();
  system.residual(at_end(s, h), r.get());
  return rows(r.get());
}
inline MatHandle tangent(System& system, const Trial& t, const Weights& w) {
  MatHandle J = system.create_matrix();
  system.tangent(at_end(state_of(system.mesh(), t), t.h), w, t.u, false, J.get());
  return J;
}

// A direction that is zero at held components (held = false) or at all others (held = true).
inline std::vector<double> direction(const System& system, const Trial& t, int purpose, bool held = false) {
  const LocalMesh& m = system.mesh();
  std::vector<double> d(3 * static_cast<size_t>(m.blocks()), 0);
  for (int n = 0; n < m.nodes(); ++n)
    for (int k = 0; k <= m.rotates(n); ++k)
      for (int c = 0; c < 3; ++c) {
        const size_t b = static_cast<size_t>(m.block[static_cast<size_t>(n)] + k);
        const auto& mask = system.tied_nodes().held();
        const bool is_held = !mask.empty() && (mask[b] >> c & 1);
        if (is_held == held)
          d[3 * b + static_cast<size_t>(c)] =
              (k ? t.angle : t.length) * noise(m.global[static_cast<size_t>(n)], 3 * k + c, purpose);
      }
  return d;
}
inline std::vector<double> multiply(const System& system, Mat J, const std::vector<double>& d) {
  VecHandle x = system.create_vector();
  VecHandle y = system.create_vector();
  PetscScalar* p = nullptr;
  check(VecGetArray(x.get(), &p));
  std::copy(d.begin(), d.begin() + 3 * system.mesh().owned_blocks, p);
  check(VecRestoreArray(x.get(), &p));
  check(MatMult(J, x.get(), y.get()));
  return rows(y.get());
}

struct Taylor {
  double error = 0;      // largest relative error of J d against fourth-order differences
  double order = 1e300;  // smallest order of the remainder
  int orders = 0;        // number of directions with a measurable remainder
};

// Compares J d with (8 (f(e) - f(-e)) - (f(2e) - f(-2e))) / 12e, block by block, and measures the order of
// |f(e) - f - e J d| in e. On one rank.
inline Taylor taylor(System& system, const Trial& t, const Weights& w, int directions = 4) {
  constexpr double e = 0.02;
  const LocalMesh& m = system.mesh();
  const MatHandle J = tangent(system, t, w);
  Taylor out;
  for (int k = 0; k < directions; ++k) {
    const auto d = direction(system, t, 100 + k);
    const auto f = [&](double step) { return residual(system, state_of(m, t, step, &d, w), t.h); };
    const auto Jd = multiply(system, J.get(), d);
    const auto zero = f(0);
    const auto a = f(e);
    const auto b = f(-e);
    const auto c = f(2 * e);
    const auto g = f(-2 * e);
    double largest = 0, size = 0, near = 0, far = 0;
    for (size_t i = 0; i < Jd.size(); ++i) {
      largest = std::max(largest, std::abs(Jd[i]));
      size += zero[i] * zero[i];
      near += std::pow(a[i] - zero[i] - e * Jd[i], 2);
      far += std::pow(c[i] - zero[i] - 2 * e * Jd[i], 2);
    }
    size = std::sqrt(size);
    near = std::sqrt(near);
    far = std::sqrt(far);
    for (size_t i = 0; i < Jd.size(); i += 3) {
      double off = 0, block = 0;
      for (size_t j = i; j < i + 3; ++j) {
        const double difference = (8 * (a[j] - b[j]) - (c[j] - g[j])) / (12 * e);
        off += std::pow(difference - Jd[j], 2);
        block += Jd[j] * Jd[j];
      }
      if (off == 0) continue;
      // For a block with a small change, the error is relative to the change of all others.
      out.error =
          std::max(out.error, std::sqrt(off) / std::max({std::sqrt(block), 1e-3 * largest, 1e-9 * size}));
    }
    if (near < 1e-8 * e * largest + 1e-12 * size) continue;  // linear to round-off
    out.order = std::min(out.order, std::log2(far / near));
    ++out.orders;
  }
  return out;
}

// Tests the three tangents one by one and together. Prints the errors.
inline void expect_tangent(System& system, const Trial& t, const std::string& what) {
  struct Kind {
    const char* name;
    Weights w;
  };
  for (const Kind& k : {Kind{"K", {1, 0, 0, 0, 0}}, Kind{"C", {0, 1, 0, 0, 0}}, Kind{"M", {0, 0, 1, 0, 0}},
                        Kind{"K + 3 C + 7 M", {1, 3, 7, 0, 0}}}) {
    const Taylor r = taylor(system, t, k.w);
    EXPECT_LT(r.error, 1e-6) << what << ": " << k.name;
    if (r.orders) {
      EXPECT_GT(r.order, 1.9) << what << ": " << k.name;
    }
    printf("  %-28s %-14s error %.1e", what.c_str(), k.name, r.error);
    if (r.orders) printf(", order %.2f", r.order);
    printf("\n");
  }
  // Held components have rows and columns of the identity.
  const MatHandle J = tangent(system, t, {1, 3, 7, 0, 0});
  const auto d = direction(system, t, 7, true);
  const auto Jd = multiply(system, J.get(), d);
  for (size_t i = 0; i < Jd.size(); ++i) EXPECT_EQ(Jd[i], d[i]) << what << ": held, row " << i;
}

}  // namespace hawser::test
