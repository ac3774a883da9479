// What a run does with its feeders after every step: all ranks agree on them, nodes leave the feeder or are
// caught by it, checkpoints keep where they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hawser/app/simulation.hpp"
#include "hawser/io/checkpoint.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::app {

class Feeding {
 public:
  explicit Feeding(Simulation& simulation) : sim_(simulation) {}

  // After a step was accepted, before it is shown. Collective.
  void agree();
  // After it was shown: nodes that leave or are caught. SolveError where a stock has run out, or all of a
  // line is hauled in. Collective.
  void hand_over();

  void save(io::Checkpoint& to) const;
  // InputError where the checkpoint has no such feeders, or others.
  void restore(const io::Checkpoint& from, const std::string& path);

 private:
  void let_out(Feeder& f);
  void haul_in(Feeder& f);
  double felt(const Feeder& f);
  void hand_over(Feeder& f, int mouth, double length, const std::optional<Dynamics::Moved>& moved);

  Simulation& sim_;
};

}  // namespace hawser::app
