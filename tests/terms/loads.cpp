// Point loads, moments and masses, assembled by a System of one beam element and one cable node, against hand
// calculations.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "hawser/math/so3.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/point_loads.hpp"

namespace hawser::loads_test {
namespace {

Mesh two_lines() {
  Mesh mesh;
  mesh.add(Node{0, 0, 1, true});
  mesh.add(Node{0, 2, 1, true});
  mesh.add(Node{1, 0, 0, false});
  mesh.add(Element{0, 0, 1, 0, 2, true});
  mesh.lines = {{0, 2, 0, 1, 2}, {2, 1, 1, 0, 0}};
  return mesh;
}

LocalMesh local_mesh(const Mesh& mesh) {
  LocalMesh l;
  l.mesh = &mesh;
  l.owned = 3;
  l.owner = NodeRanks::all_of(3);
  l.global = {0, 1, 2};
  l.block = {0, 2, 4};
  l.owned_blocks = 5;
  l.global_block = {0, 1, 2, 3, 4};
  l.elements = {{0, 1, 0, true}};
  l.copy_local();
  return l;
}

std::array<double, 15> residual(System& system, const State& s) {
  VecHandle r = system.create_vector();
  system.residual(s.after_step(0.1), r.get());
  std::array<double, 15> values{};
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(r.get(), &p));
  std::copy(p, p + 15, values.begin());
  check(VecRestoreArrayRead(r.get(), &p));
  return values;
}

State moved() {
  State s(3);
  s.time = 1;
  s.x = {Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(5, 5, 5)};
  s.v = {Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(-1, 0, 2)};
  s.a = {Vec3(0.1, 0.2, 0.3), Vec3(0.4, -0.5, 0.6), Vec3(1, 1, 1)};
  s.q[1] = exp_so3({0.9, -0.4, 1.2});
  return s;
}

TEST(PointLoads, ForceMomentAndRamp) {
  const Mesh mesh = two_lines();
  System system(PETSC_COMM_SELF, local_mesh(mesh));
  const Vec3 F(10, -20, 30), M(4, 5, -6);
  system.add(std::make_unique<PointLoads>(
      system.mesh(), std::vector<NodeLoad>{{1, F, M, 0}, {2, F, Vec3::Zero(), 4}, {7, F, M, 0}}));
  State s = moved();
  s.time = 2;  // half of the ramp
  const auto r = residual(system, s);
  const Vec3 moment = s.q[1].conjugate() * M;
  for (size_t c = 0; c < 3; ++c) {
    const Eigen::Index i = static_cast<Eigen::Index>(c);
    EXPECT_EQ(r[c], 0);
    EXPECT_DOUBLE_EQ(r[6 + c], -F[i]);
    EXPECT_NEAR(r[9 + c], -moment[i], 1e-14);
    EXPECT_NEAR(r[12 + c], -0.5 * F[i], 1e-14);
  }
  EXPECT_THROW(PointLoads(system.mesh(), {{2, F, M, 0}}), std::invalid_argument);
}

// K equals the fourth-order difference of the residual over material rotation increments.
TEST(PointLoads, MomentStiffness) {
  const Mesh mesh = two_lines();
  System system(PETSC_COMM_SELF, local_mesh(mesh));
  system.add(
      std::make_unique<PointLoads>(system.mesh(), std::vector<NodeLoad>{{1, {1, 2, 3}, {4, 5, -6}, 0}}));
  const State s = moved();
  MatHandle J = system.create_matrix();
  system.tangent(s.after_step(0.1), {}, std::vector<double>(15, 0.0), false, J.get());
  for (int k = 0; k < 3; ++k) {
    const double h = 1e-3;
    const auto at = [&](double d) {
      State t = s;
      t.q[1] = s.q[1] * exp_so3(d * Vec3::Unit(k));
      return residual(system, t);
    };
    const auto a = at(h);
    const auto b = at(-h);
    const auto c = at(2 * h);
    const auto d = at(-2 * h);
    for (int i = 0; i < 15; ++i) {
      const size_t n = static_cast<size_t>(i);
      const PetscInt row = i;
      const PetscInt column = 9 + k;
      PetscScalar value = 0;
      check(MatGetValues(J.get(), 1, &row, 1, &column, &value));
      EXPECT_NEAR(value, (8 * (a[n] - b[n]) - (c[n] - d[n])) / (12 * h), 1e-10);
    }
  }
}

TEST(PointLoads, WorkAndCheckpoint) {
  const Mesh mesh = two_lines();
  const LocalMesh local = local_mesh(mesh);
  const std::vector<NodeLoad> loads{
      {1, {10, 0, 0}, {0, 0, 6}, 0}, {0, {0, 0, 0}, {0, 0, 2}, 0}, {1, {0, 1, 0}, {0, 3, 0}, 0}};
  PointLoads term(local, loads);
  PointLoads copy(local, loads);
  State s = moved();
  term.prepare(s.after_step(0.1), 0.1);
  const double before = term.energy(s.after_step(0.1)).potential;
  for (int i = 0; i < 10; ++i) {
    term.prepare(s.after_step(0.1), 0.1);
    s.time += 0.1;
    s.x[1] += Vec3(0.2, 0.1, 0);
    s.q[1] = exp_so3({0, 0, 0.05}) * s.q[1];
    s.q[0] = exp_so3({0, 0, 0.1}) * s.q[0];
    term.commit(s.after_step(0.1));
  }
  // Constant forces have a potential, a moment does work.
  EXPECT_NEAR(before - term.energy(s.after_step(0.1)).potential, 10 * 2 + 1 * 1, 1e-12);
  EXPECT_NEAR(term.energy(s.after_step(0.1)).work, 6 * 0.5 + 2 * 1, 1e-12);
  copy.restore(term.save());
  // In the case, the loads of node 1 are before and after that of node 0.
  const std::vector<CheckpointRecord> sums = copy.save();
  ASSERT_EQ(sums.size(), 3u);
  EXPECT_EQ(sums[0].node, 0);
  EXPECT_NEAR(sums[0].values.at(0), 2 * 1, 1e-12);
  EXPECT_NEAR(sums[1].values.at(0), 6 * 0.5, 1e-12);
  EXPECT_EQ(sums[2].values.at(0), term.save()[2].values.at(0));
}

TEST(PointMasses, InertiaAndWeight) {
  const Mesh mesh = two_lines();
  System system(PETSC_COMM_SELF, local_mesh(mesh));
  system.add(std::make_unique<PointMasses>(system.mesh(), std::vector<NodeMass>{{1, 30}}, 9.80665));
  const State s = moved();
  const auto r = residual(system, s);
  EXPECT_DOUBLE_EQ(r[6], 12);
  EXPECT_DOUBLE_EQ(r[7], -15);
  EXPECT_DOUBLE_EQ(r[8], 30 * (0.6 + 9.80665));
  MatHandle J = system.create_matrix();
  Weights weights;
  weights.M = 2;
  system.tangent(s.after_step(0.1), weights, std::vector<double>(15, 0.0), false, J.get());
  PetscInt row = 7;
  PetscScalar value = 0;
  check(MatGetValues(J.get(), 1, &row, 1, &row, &value));
  EXPECT_DOUBLE_EQ(value, 60);
  const Energy e = system.energy(s.after_step(0.1));
  EXPECT_DOUBLE_EQ(e.kinetic, 0.5 * 30 * 77);
  EXPECT_DOUBLE_EQ(e.potential, 30 * 9.80665);
}

TEST(PointLoads, OfACase) {
  model::Case c;
  for (int i = 0; i < 2; ++i) c.lines.emplace_back();
  c.lines[0].point_loads = {{1.9, {1, 0, 0}, {0, 2, 0}, 3}};
  c.lines[0].masses = {{0.1, 5}};
  const Mesh mesh = two_lines();
  const LocalMesh local = local_mesh(mesh);
  const auto loads = point_loads(c, local);
  ASSERT_EQ(loads.size(), 1u);
  EXPECT_EQ(loads[0].node, 1);
  EXPECT_EQ(loads[0].ramp, 3);
  const auto masses = point_masses(c, local);
  ASSERT_EQ(masses.size(), 1u);
  EXPECT_EQ(masses[0].node, 0);
}

TEST(Bodies, OfACase) {
  model::Body still, ship;
  still.position = {1, 2, 3};
  ship.motion = model::TableMotion{{0, 1, 2}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(4, 0, 0)}, {}};
  model::Body reel;
  reel.motion = model::ConstantMotion{Vec3::Zero(), Vec3::UnitY(), 0.1};
  reel.ramp = 10;
  const Bodies bodies(std::vector<model::Body>{still, ship, reel});
  EXPECT_EQ(bodies.size(), 3);
  EXPECT_FALSE(bodies.moves(0));
  EXPECT_FALSE(bodies.moves(-1));
  EXPECT_EQ(bodies.pose(0, 5).position.y(), 2);
  EXPECT_EQ(bodies.pose(-1, 5).position.norm(), 0);
  EXPECT_NEAR(bodies.pose(1, 2).position.x(), 4, 1e-14);
  EXPECT_NEAR(bodies.pose(2, 20).angular_velocity.y(), 0.1, 1e-15);
  EXPECT_NEAR(bodies.pose(2, 20).velocity_at({0, 0, 1}).x(), 0.1, 1e-15);
}

}  // namespace
}  // namespace hawser::loads_test
