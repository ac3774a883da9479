// What a run does with its feeders after every step: all ranks agree on them, nodes leave the feeder or are
// caught by it, checkpoints keep where they are.
#pragma once

#include <optional>
#include <string>

#include "hawser/io/checkpoint.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::run {

class FeederNodes {
 public:
  explicit FeederNodes(Simulation& simulation) : sim_(simulation) {}

  // After a step was accepted, before it is shown. Collective.
  void agree();
  // In statics, `by` [m] more of the line is outside, or less, with the nodes that leave or are caught; the
  // state is to come to rest after it. SolveError likewise. Collective.
  void shift(Feeder& f, double by);
  // After it was shown: nodes that leave or are caught. SolveError where a stock has run out, or all of a
  // line is hauled in. Collective.
  void transfer_node();

  void save(io::Checkpoint& to) const;
  // InputError where the checkpoint has no such feeders, or others.
  void restore(const io::Checkpoint& from, const std::string& path);

 private:
  Dynamics::Moved leaving(const Feeder& f, const Kinematics& k, const LocalElement& e) const;
  // The node that is caught, where it is known, and the length [m] of the element at the feed point then.
  std::optional<Dynamics::Moved> caught(const Feeder& f, const Kinematics& k, double& length) const;
  void refuse_all_out(const Feeder& f, double time) const;
  void refuse_all_in(const Feeder& f, double time) const;
  void release_node(Feeder& f);
  void catch_node(Feeder& f);
  double feeder_force(const Feeder& f);
  void transfer_node(Feeder& f, int feed_point, double length, const std::optional<Dynamics::Moved>& moved);

  Simulation& sim_;
};

}  // namespace hawser::run
