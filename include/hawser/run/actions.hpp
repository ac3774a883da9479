// Actions of events on a simulation: release and attachment of line ends, feeder laws, contact with volumes,
// static friction and current.
#pragma once

#include <mpi.h>

#include <array>
#include <vector>

#include "hawser/model/event.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

class Actions {
 public:
  // Result of an action, the same on all ranks, needed to repeat it in a continued run: for an attachment,
  // position and rotation of the end relative to its support (from the centre of mass of a body with mass)
  // and the distance from the expected place; for a feeder, its speed.
  struct Found {
    std::array<double, 3> place{};
    std::array<double, 4> rotation{1, 0, 0, 0};  // w, x, y, z
    double away = 0;                             // m
    double speed = 0;                            // m/s
  };

  explicit Actions(Simulation& simulation) : sim_(simulation) {}

  // Takes the tied nodes of the system, which the actions change.
  void begin() { tied_ = sim_.system().tied_nodes().nodes(); }
  // Performs an action in the accepted `state`. Throws SolveError if it is impossible. Collective.
  Found act(const model::Action& action, const Kinematics& state);
  // Repeats an action performed at this time [s], in a run continued from a checkpoint.
  void repeat(const model::Action& action, const Found& placed, double time);
  // Tied local nodes, to be passed to the system.
  const std::vector<TiedNode>& tied() const { return tied_; }

  // Distance [m] of the end to be attached from its expected place; valid where its node is owned.
  double away(const model::Action& action, const Kinematics& state) const;
  // Mesh node at the action's line end.
  int node(const model::Action& action) const;

 private:
  bool held(int node) const;
  RigidPose pose(const model::Action& action, const Kinematics& state) const;
  void hold(const model::Action& action, const Found& placed);
  void feed(const model::Action& action, double speed, double time);

  Simulation& sim_;
  std::vector<TiedNode> tied_;
};

}  // namespace hawser::run
