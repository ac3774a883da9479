// Update of feeders after each step: agreement of all ranks, released and absorbed nodes, and checkpoints.
#pragma once

#include <optional>
#include <string>

#include "hawser/io/checkpoint.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::run {

class FeederNodes {
 public:
  explicit FeederNodes(Simulation& simulation) : sim_(simulation), feeders_(simulation.feeders()) {}

  // After an accepted step, before its output. Collective.
  void agree();
  // In statics: pays out `paid_out` [m] (negative: hauls in), including released and absorbed nodes; the
  // equilibrium must be solved afterwards. Throws SolveError as transfer_node(). Collective.
  void shift(Feeder& f, double paid_out);
  // After the output of a step: releases or absorbs nodes. Throws SolveError if a stock has run out or all of
  // a line is hauled in. Collective.
  void transfer_node();

  void save(io::Checkpoint& to) const;
  // Throws InputError if the feeders of the checkpoint are missing or different.
  void restore(const io::Checkpoint& from, const std::string& path);

 private:
  Dynamics::Moved released(const Feeder& f, const Kinematics& k, const LocalElement& e) const;
  struct Absorbed {
    std::optional<Dynamics::Moved> moved;  // the node, on the ranks that have it
    double length = 0;                     // m, of the element at the feed point afterwards
  };
  Absorbed absorbed(const Feeder& f, const Kinematics& k) const;
  void refuse_all_out(const Feeder& f, double time) const;
  void refuse_all_in(const Feeder& f, double time) const;
  void release_node(Feeder& f);
  void absorb_node(Feeder& f);
  double feeder_force(const Feeder& f);
  // The transfer of a node that is due at the length of the element at the feed point. Throws SolveError if a
  // stock has run out or all of a line is hauled in.
  enum class Transfer { none, release, absorb };
  Transfer due_transfer(const Feeder& f, double time) const;
  void transfer_node(Feeder& f, int feed_point, double length, const std::optional<Dynamics::Moved>& moved);

  Simulation& sim_;
  Feeders* const feeders_;  // null: no line is fed
};

}  // namespace hawser::run
