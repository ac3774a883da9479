// Force of a time-varying current on a line at rest, against the closed form of the drag.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "hawser/model/case.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/lines_in_water.hpp"

namespace hawser::current_test {
namespace {

// A cable of 2 m along x, deep in water that flows along y: the force on its first node [N].
double pull(double ramp, double time, double step) {
  Mesh mesh;
  mesh.add(Node{0, 0, 1, false});
  mesh.add(Node{0, 2, 1, false});
  mesh.add(Element{0, 0, 1, 0, 2, false});
  mesh.lines = {{0, 2, 0, 1, 2}};
  LocalMesh local;
  local.mesh = &mesh;
  local.owned = 2;
  local.owned_blocks = 2;
  local.owner = NodeRanks::all_of(2);
  local.global = local.block = local.global_block = {0, 1};
  local.elements = {{0, 1, 0, false}};
  local.copy_local();
  model::Case c;
  c.lines.emplace_back();
  model::Water& w = c.environment.water;
  w.present = true;
  w.density = 1000;
  w.current.profile = {{0, 1, M_PI / 2}};
  w.current.ramp = ramp;
  w.current.time_factor = TimeFactor({{10, 0.5}, {20, 2}, {40, -1}});
  model::LineType& t = c.line_types.emplace_back();
  t.outer_diameter = 0.5;
  t.Cd_normal = 1.2;
  System system(PETSC_COMM_SELF, std::move(local));
  system.add(std::make_unique<LinesInWater>(system.mesh(), c));
  State s(2);
  s.time = time;
  s.x = {Vec3(0, 0, -50), Vec3(2, 0, -50)};
  VecHandle r = system.create_vector();
  const Kinematics at = step > 0 ? s.after_step(step) : s.at_rest();
  system.prepare(at, step);
  system.residual(at, r.get());
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(r.get(), &p));
  const double force = -p[1];
  check(VecRestoreArrayRead(r.get(), &p));
  return force;
}

// rho/2 Cd D U |U| times half the length: 300 N at 1 m/s. The factor is that at the time of the trial.
TEST(CurrentInTime, FactorIsThatOfTheTrial) {
  EXPECT_NEAR(pull(0, 0, 0), 300 * 0.25, 1e-9);  // statics: the first row
  EXPECT_NEAR(pull(0, 5, 0.1), 300 * 0.25, 1e-9);
  EXPECT_NEAR(pull(0, 14, 0.1), 300 * 1.1 * 1.1, 1e-9);
  EXPECT_NEAR(pull(0, 20, 0.1), 300 * 4, 1e-9);
  EXPECT_NEAR(pull(0, 36, 0.1), -300 * 0.4 * 0.4, 1e-9);
  EXPECT_NEAR(pull(0, 90, 0.1), -300, 1e-9);
  EXPECT_EQ(pull(30, 0, 0), 0);  // the ramp multiplies the factor: half at 15 s
  EXPECT_NEAR(pull(30, 15, 0.1), 300 * std::pow(0.5 * 1.25, 2), 1e-9);
}

}  // namespace
}  // namespace hawser::current_test
