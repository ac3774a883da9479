// A case in which all bodies with mass are held, and can be put elsewhere one by one: what is tied to them
// comes to rest, and has a stiffness against their displacements.
#pragma once

#include <memory>
#include <vector>

#include "hawser/run/simulation.hpp"
#include "hawser/solve/body_stiffness.hpp"

namespace hawser::run {

// Ties a body with mass where it starts.
void hold_body(Simulation& sim, int body);

class HeldBodies {
 public:
  // Holds the bodies of the simulation where they are, and takes away what acts on them by themselves:
  // weight, springs, loads, water, wind, thrusters (terms that are RestrainedInStatics or ActsOnBodies).
  // Lines, links and contact stay. The simulation outlives it. Collective, as are the others.
  explicit HeldBodies(Simulation& sim);

  // Of the case; of one with mass.
  const RigidPose& pose(int body) const { return poses_->at(static_cast<size_t>(body)); }
  // Puts a body there, in steps, and solves statics after each. SolveError where that fails.
  void put(int body, const RigidPose& there);
  void solve();
  // About its centre of mass.
  BodyStiffness stiffness(int body);
  // N, the largest of each line of the mesh.
  std::vector<double> tensions() const;

 private:
  void move(int body, const RigidPose& there);
  int steps_to(int body, const RigidPose& there) const;

  Simulation& sim_;
  std::shared_ptr<std::vector<RigidPose>> poses_;  // by body of the case
  BodyMotion motion_;
};

}  // namespace hawser::run
