// A case whose bodies with mass are held and can be moved one by one; attached lines come to rest and have a
// stiffness against displacement of the bodies.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/run/simulation.hpp"
#include "hawser/solve/body_stiffness.hpp"

namespace hawser::run {

// Holds a body with mass in its start position.
void hold_body(Simulation& sim, int body);

// Natural periods of each body with hydrodynamic coefficients on its lines, by the stiffness of all that acts
// on it at rest, with other bodies held and without the mass of lines; of a farm, those at the first place of
// each platform. The simulation has solved its statics. Collective.
std::vector<std::string> periods_on_lines(Simulation& sim);

class HeldBodies {
 public:
  // Holds the bodies of the simulation at their positions, and removes the loads on the bodies themselves:
  // weight, springs, loads, water, wind, thrusters (AppliesExternalLoad). Lines, links and contact remain.
  // The simulation outlives it. Collective, as are the others.
  explicit HeldBodies(Simulation& sim);

  // body: index in the case; it must have mass.
  const RigidPose& pose(int body) const { return poses_->at(static_cast<size_t>(body)); }
  // Moves a body in increments and solves statics after each. Throws SolveError if that fails.
  void put(int body, const RigidPose& target);
  void solve();
  // About the centre of mass.
  BodyStiffness stiffness(int body);
  // Largest tension of each mesh line, N.
  std::vector<double> tensions() const;

 private:
  void move(int body, const RigidPose& target);
  int steps_to(int body, const RigidPose& target) const;

  Simulation& sim_;
  std::shared_ptr<std::vector<RigidPose>> poses_;  // by body of the case
  BodyMotion motion_;
};

}  // namespace hawser::run
