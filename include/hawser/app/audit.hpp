// The energy audit of a run: what was brought in against what is there, and what of it the steps have made.
#pragma once

#include <string>

#include "hawser/system/force_term.hpp"

namespace hawser::app {

// Sums over all ranks, J.
struct Audit {
  Energy now;
  double brought_in = 0;  // by supports, ramped and point loads, moving bodies and dead loads since the start
  double error = 0;       // kinetic + strain + friction + damping - brought in
  // Over the run: the most that was brought in or there without what was made; the largest error, either way;
  // the most that one step made.
  double moved = 0;
  struct Largest {
    double value = 0, time = 0, step = 0;  // J; s, at the end of the step; s, its length
  } off, made;

  // After a step of h [s] that ended at this time; start: of the run.
  void update(const Energy& start, const Energy& now, double time, double h);
  // %, of the error against what moved: work brought in, or the energy that is there.
  double percent() const;
  // What a user must not overlook; empty: at no time was more than 1 % amiss. fixed: the user chose the step.
  std::string warning(bool fixed) const;
};

}  // namespace hawser::app
