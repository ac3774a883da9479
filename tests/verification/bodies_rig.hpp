// Shared by the tests of bodies in contact: a case from text, its statics and motion, and the poses of its
// bodies on all ranks.
#pragma once

#include <mpi.h>

#include <cmath>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "support/rig.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test {

struct BodiesRun {
  explicit BodiesRun(const std::string& yaml)
      : c(io::read_case_text(yaml, "bodies.yaml")),
        volumes(run::load_volumes(c)),
        sim(PETSC_COMM_WORLD, c, run::surfaces(volumes), run::skeletons(c, volumes),
            run::volume_facets(volumes)) {}

  void start() { sim.dynamics().start(sim.state()); }
  // Continues from the present time; calls each(info) after every step.
  void move(
      double until, const std::function<void(const StepInfo&)>& each = [](const StepInfo&) {}) {
    integrate(sim.dynamics(), until, until, each);
  }
  // Runs the case from its start to the end of its duration, without statics.
  void run_without_statics() {
    start();
    move(c.dynamics.duration);
  }
  // Poses of all bodies with mass; those of other bodies are default values.
  std::vector<RigidPose> poses(const Kinematics& state) const {
    std::vector<RigidPose> all;
    for (size_t b = 0; b < c.bodies.size(); ++b) {
      std::vector<double> of(13, 0);
      if (const auto pose = c.bodies[b].mass ? sim.body_pose(static_cast<int>(b), state) : std::nullopt) {
        Eigen::Map<Vec3>(of.data()) = pose->position;
        Eigen::Map<Eigen::Vector4d>(of.data() + 3) = pose->rotation.coeffs();
        Eigen::Map<Vec3>(of.data() + 7) = pose->velocity;
        Eigen::Map<Vec3>(of.data() + 10) = pose->angular_velocity;
      }
      MPI_Allreduce(MPI_IN_PLACE, of.data(), 13, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
      RigidPose& p = all.emplace_back();
      if (!c.bodies[b].mass) continue;
      p.position = Eigen::Map<Vec3>(of.data());
      p.rotation = Quat(Eigen::Map<Eigen::Vector4d>(of.data() + 3)).normalized();
      p.velocity = Eigen::Map<Vec3>(of.data() + 7);
      p.angular_velocity = Eigen::Map<Vec3>(of.data() + 10);
    }
    return all;
  }
  std::vector<RigidPose> poses() { return poses(sim.dynamics().committed_kinematics()); }
  Energy energy() {
    Energy e = sim.system().energy(sim.dynamics().committed_kinematics());
    for (double* of : {&e.kinetic, &e.strain, &e.potential, &e.friction, &e.damping, &e.work})
      MPI_Allreduce(MPI_IN_PLACE, of, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return e;
  }
  // Energy less the work brought in [J]; it changes only by the error of the time integration.
  double audit() {
    const Energy e = energy();
    return total(e) + e.friction + e.damping - e.work;
  }

  model::Case c;
  std::vector<run::LoadedVolume> volumes;
  run::Simulation sim;
};

}  // namespace hawser::test
