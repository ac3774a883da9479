// Checks for the model of any term: forces, tangents and energies on several ranks equal those on one, and
// forces rotate with the model. A model has `system`, `contact` and `trial`.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include "support/taylor_model.hpp"

namespace hawser::test {

inline double over_ranks(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

// Compares residual and tangent of the trial, then energies and the number of contacts after it is committed.
// `one` is the whole model on each rank. Returns the size of the largest force, N.
template <class Model>
double expect_same_on_ranks(Model& all, Model& one, std::initializer_list<double Energy::*> parts,
                            double tolerance, const std::string& name) {
  const LocalMesh& a = all.system->mesh();
  const LocalMesh& b = one.system->mesh();
  const double h = one.trial.h;
  const State end_a = state_of(a, all.trial);
  const State end_b = state_of(b, one.trial);
  const auto fa = residual(*all.system, end_a, h);
  const auto fb = residual(*one.system, end_b, h);
  double size = 0;
  for (double x : fb) size = std::max(size, std::abs(x));
  for (int n = 0; n < a.owned; ++n)
    for (int k = 0; k <= a.rotates(n); ++k)
      for (size_t r = 0; r < 3; ++r) {
        const int g = a.global[static_cast<size_t>(n)];
        EXPECT_NEAR(fa[3 * static_cast<size_t>(a.block[static_cast<size_t>(n)] + k) + r],
                    fb[3 * static_cast<size_t>(b.block[static_cast<size_t>(g)] + k) + r], tolerance * size)
            << name << ", node " << g;
      }
  double na = 0, nb = 0;
  const MatHandle Ja = tangent(*all.system, all.trial, {1, 3, 7, 0, 0});
  const MatHandle Jb = tangent(*one.system, one.trial, {1, 3, 7, 0, 0});
  check(MatNorm(Ja.get(), NORM_FROBENIUS, &na));
  check(MatNorm(Jb.get(), NORM_FROBENIUS, &nb));
  EXPECT_NEAR(na, nb, tolerance * nb) << name;

  all.system->commit(at_end(end_a, h));
  one.system->commit(at_end(end_b, h));
  const Energy x = all.contact->energy(at_end(end_a, h));
  const Energy y = one.contact->energy(at_end(end_b, h));
  for (const auto part : parts)
    EXPECT_NEAR(over_ranks(x.*part), y.*part, tolerance * (std::abs(y.*part) + y.strain)) << name;
  EXPECT_EQ(over_ranks(all.contact->active_count()), one.contact->active_count()) << name;
  return size;
}

// Compares the forces of a model with those of the same model rotated in space; moments, in the nodes' axes,
// must not change.
struct TurnedForces {
  double size = 0, off = 0;  // N: the largest force, the largest difference
};
template <class Model>
TurnedForces turned_forces(Model& m, Model& turned, const Quat& rotation) {
  const LocalMesh& mesh = m.system->mesh();
  const auto f = residual(*m.system, state_of(mesh, m.trial), m.trial.h);
  const auto g = residual(*turned.system, state_of(mesh, turned.trial), m.trial.h);
  TurnedForces out;
  for (int n = 0; n < mesh.owned; ++n)
    for (int k = 0; k <= mesh.rotates(n); ++k) {
      const size_t i = 3 * static_cast<size_t>(mesh.block[static_cast<size_t>(n)] + k);
      const Eigen::Map<const Vec3> a(f.data() + i);
      const Eigen::Map<const Vec3> b(g.data() + i);
      out.size = std::max(out.size, a.norm());
      out.off = std::max(out.off, (k ? Vec3(b - a) : Vec3(b - rotation * a)).norm());
    }
  return out;
}

// Returns the largest force, N.
template <class Model>
double expect_turned(Model& m, Model& turned, const Quat& rotation, double tolerance,
                     const std::string& name) {
  const auto [size, off] = turned_forces(m, turned, rotation);
  EXPECT_LE(off, tolerance * size) << name;
  return size;
}

}  // namespace hawser::test
