// The model of the term suite: a line of three beams and one of three cables, strongly deformed. Every node
// has its own increments, velocities and accelerations, the same on any number of ranks.
#pragma once

#include <functional>
#include <memory>

#include "hawser/mesh/partition.hpp"
#include "support/taylor.hpp"

namespace hawser::test {

// A rigid motion of the whole model: x -> rotation x + shift.
struct Placement {
  Quat rotation = Quat::Identity();
  Vec3 shift = Vec3::Zero();
  Vec3 point(const Vec3& x) const { return rotation * x + shift; }
};

inline Mesh suite_mesh() {
  Mesh m;
  const double L = 1.2;
  for (int line = 0; line < 2; ++line) {
    const int first = 4 * line;
    for (int i = 0; i < 4; ++i) m.add(Node{line, i * L, i % 3 ? L : L / 2, line == 0});
    for (int i = 0; i < 3; ++i) m.add(Element{line, first + i, first + i + 1, line, L, line == 0});
    LineSpan span;
    span.first_node = first;
    span.nodes = 4;
    span.first_element = 3 * line;
    span.elements = 3;
    span.length = 3 * L;
    m.lines.push_back(span);
  }
  return m;
}

struct SuiteModel {
  explicit SuiteModel(MPI_Comm comm = PETSC_COMM_SELF, const Placement& at = {}) : mesh(suite_mesh()) {
    int rank = 0, size = 1;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
    system = std::make_unique<System>(comm, local_mesh(mesh, partition(mesh, size), rank, size));
    const LocalMesh& l = system->mesh();
    trial.h = 0.05;
    trial.from = State(l.nodes());
    trial.rates = State(l.nodes());
    trial.from.time = 1;
    trial.u.assign(3 * static_cast<size_t>(l.blocks()), 0);
    for (int n = 0; n < l.nodes(); ++n) {
      const size_t i = static_cast<size_t>(n);
      const int g = l.global[i];
      // Line 0 along x, line 1 along a diagonal, nodes shifted by up to 0.15 m; their rotations differ by up
      // to half a radian, their increments are up to a radian.
      const Vec3 straight =
          g < 4 ? Vec3(1.25 * g, 0, 0) : Vec3(0.8 * (g - 4), 3 + 0.8 * (g - 4), 0.5 * (g - 4));
      trial.from.x[i] = at.point(straight + 0.15 * noise3(g, 1));
      const Vec3 ux = 0.1 * noise3(g, 2);
      const Vec3 ut = (Vec3(0.5, -0.4, 0.3) + 0.2 * noise3(g, 3));
      double* u = trial.u.data() + 3 * l.block[i];
      Eigen::Map<Vec3>(u, 3) = at.rotation * ux;
      trial.rates.v[i] = at.rotation * noise3(g, 5);
      trial.rates.a[i] = at.rotation * (3 * noise3(g, 6));
      if (!l.rotates(n)) continue;
      trial.from.q[i] = at.rotation * exp_so3(Vec3(0.3, 0.2, -0.1) + 0.15 * noise3(g, 4));
      Eigen::Map<Vec3>(u + 3, 3) = ut;
      trial.rates.w[i] = noise3(g, 7);
      trial.rates.alpha[i] = 3 * noise3(g, 8);
    }
    trial.from.v = trial.rates.v;
    trial.from.w = trial.rates.w;
  }
  // Position of node n (local) in the trial.
  Vec3 where(int n) const { return state_of(system->mesh(), trial).x[static_cast<size_t>(n)]; }
  // Moves local node n to `start` and its trial to `end` (space), with trial velocity v.
  void put(int n, const Vec3& start, const Vec3& end, const Vec3& v) {
    const size_t i = static_cast<size_t>(n);
    trial.from.x[i] = start;
    Eigen::Map<Vec3>(trial.u.data() + 3 * system->mesh().block[i], 3) = end - start;
    trial.rates.v[i] = v;
  }

  Mesh mesh;
  std::unique_ptr<System> system;
  Trial trial;
};

}  // namespace hawser::test
