// The energy audit of a run: what was brought in against what is there, and what of it the steps have made or
// lost.
#pragma once

#include <string>

#include "hawser/system/force_term.hpp"

namespace hawser::app {

// Sums over all ranks, J.
struct Audit {
  Energy now;
  double brought_in = 0;  // by supports, ramped and point loads, moving bodies and dead loads since the start
  // Kinetic + strain + friction + damping + unresolved - brought in: made out of nothing, or lost if
  // negative.
  double error = 0;
  // What made and lost energy is judged against: what moved at the start, the work of every step whichever
  // way it went, and the strain energy that the start has set free.
  double at_start = 0, worked = 0, set_free = 0;
  double least_error = 0;  // so far
  struct Largest {
    double value = 0, time = 0, step = 0;  // J; s, at the end of the step; s, its length
    double size = 0;                       // J, what it is judged against at that time
  } made, lost;                            // since the error was least; against the start
  struct Step {
    double value = 0, time = 0, length = 0;  // J; s, at its end; s
    int node = -1;                           // of the mesh, where the motion changed most; -1: not known
    enum class Touch { nothing, volume, line, seabed } touch = Touch::nothing;  // what acted there
  } worst;                                                                      // the step that made most

  // After a step of h [s] that ended at this time; start: of the run. True: no step before made as much, so
  // that worst.node and worst.touch are to be found out.
  bool update(const Energy& start, const Energy& now, double time, double h);
  double size() const { return at_start + worked + set_free; }
  // %, of the error against size().
  double percent() const;
  // What a user must not overlook; empty: nothing. fixed: the user chose the step; where: words for
  // worst.node.
  std::string warning(bool fixed, const std::string& where) const;
  // More was made or lost than any result can bear: the run has failed.
  bool wrong() const;
  // What a user may want to know of what the steps did not resolve; empty: it is little.
  std::string note() const;
};

}  // namespace hawser::app
