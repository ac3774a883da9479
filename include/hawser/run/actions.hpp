// What events do to a simulation: ends of lines are let go of or held, feeders get other laws, contact with
// volumes goes on and off.
#pragma once

#include <mpi.h>

#include <array>
#include <vector>

#include "hawser/model/event.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

class Actions {
 public:
  // What an action found, the same on all ranks, with which a run that goes on does it again: of an
  // attachment place and rotation of the end in what holds it (from the centre of mass of a body with mass)
  // and the distance from where it was expected, of a feeder its speed.
  struct Found {
    std::array<double, 3> place{};
    std::array<double, 4> rotation{1, 0, 0, 0};  // w, x, y, z
    double away = 0;                             // m
    double speed = 0;                            // m/s
  };

  explicit Actions(Simulation& simulation) : sim_(simulation) {}

  // Before any of them: the tied nodes that they change, those of the system.
  void begin() { tied_ = sim_.system().tied_nodes().list(); }
  // In the accepted state `at`. SolveError where it cannot be done. Collective.
  Found act(const model::Action& action, const Kinematics& at);
  // In a run that goes on from a checkpoint: what it did at this time [s].
  void repeat(const model::Action& action, const Found& found, double time);
  // Of the local nodes; to be given to the system.
  const std::vector<TiedNode>& tied() const { return tied_; }

  // m, how far the end that an action attaches is from where it is expected; where its node is owned.
  double away(const model::Action& action, const Kinematics& at) const;
  // Node of the mesh at the action's end.
  int node(const model::Action& action) const;

 private:
  bool held(int node) const;
  RigidPose pose(const model::Action& action, const Kinematics& at) const;
  void hold(const model::Action& action, const Found& found);
  void feed(const model::Action& action, double speed, double time);

  Simulation& sim_;
  std::vector<TiedNode> tied_;
};

}  // namespace hawser::run
