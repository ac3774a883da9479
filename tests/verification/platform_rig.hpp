// Runs of floating bodies and files of coefficients for them.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "../regression/runs.hpp"
#include "hawser/base/mpi.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::platform_rig {

// Positions of the bodies' nodes (centres of mass) at the ends of steps.
inline std::vector<std::vector<Vec3>> motion(const model::Case& c, double until, double every) {
  run::Simulation s(PETSC_COMM_WORLD, c);
  if (c.statics.enabled) s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  std::vector<std::vector<Vec3>> out;
  const auto keep = [&](const Kinematics& state) {
    auto& row = out.emplace_back();
    for (size_t b = 0; b < c.bodies.size(); ++b) {
      const int node = s.mesh().body_node(static_cast<int>(b));
      const int local = s.local().find(node);
      Vec3 x = s.local().owns(local) ? state.x[local] : Vec3(Vec3::Zero());
      std::vector<double> all(x.begin(), x.end());
      all_reduce(PETSC_COMM_WORLD, MPI_SUM, all);
      row.push_back(Vec3(all.data()));
    }
  };
  keep(d.committed_kinematics());
  integrate(d, until, every, [&](const StepInfo& i) {
    if (std::abs(std::remainder(i.time, every)) < 1e-9) keep(d.committed_kinematics());
  });
  return out;
}

// Writes files of a barge with little added mass and damping and the given hydrostatic stiffness; returns
// their path without endings.
inline std::string coefficients(const std::string& name, const std::string& stiffness) {
  const std::string stem = testing::TempDir() + name;
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::filesystem::create_directories(std::filesystem::path(stem).parent_path());
    std::ofstream(stem + ".1") << "0 3 3 1\n6 3 3 1 0.1\n5 3 3 1 0.1\n";
    std::ofstream(stem + ".hst") << stiffness;
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  return stem;
}

// Case of such a barge, with springs of the stiffness `surge` [N/m] and `yaw` [N m/rad] and of 1e3 N/m in
// sway. More keys of `floating` may follow.
inline std::string barge(const std::string& name, double surge, double yaw) {
  return fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000, depth: 100}}}}
bodies:
  barge:
    floating:
      mass: 1e6
      inertia: [1e7, 1e7, 1e7]
      hydrodynamics:
        wamit: {}
        place: [0, 0, 0]
        stiffness: [[{}, 0, 0, 0, 0, 0], [0, 1e3, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, {}]]
)",
                     coefficients(name, "3 3 100\n4 4 1000\n5 5 1000\n"), surge, yaw);
}

}  // namespace hawser::test::platform_rig
