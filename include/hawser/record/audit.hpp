// The energy audit of a run: what was brought in against what is there, and what of it the steps have made or
// lost.
#pragma once

#include <string>

#include "hawser/advice/energy.hpp"
#include "hawser/system/force_term.hpp"

namespace hawser::record {

// Sums over all ranks, J.
struct Audit {
  Energy now, change;     // at the last step; since the start
  double brought_in = 0;  // by supports, ramped and point loads, moving bodies and dead loads since the start
  // Kinetic + strain + friction + damping + unresolved - brought in: made out of nothing, or lost if
  // negative.
  double error = 0;
  // What made and lost energy is judged against, all of the run so far: what moved at the start, the work of
  // every step whichever way it went, and the strain energy that the start has set free.
  double at_start = 0, worked = 0, set_free = 0;
  double there = 0;        // the most that moved and was strained at a time, without what was made
  double most_strain = 0;  // the most strain energy: what rounding of an error is a part of
  double least_error = 0;  // so far
  // Dissipated so far: by friction, damping and the scheme, and what water has taken out and not brought
  // back.
  double taken = 0, least_by_water = 0;
  // Of what steps have made, what may still be in the lines (docs/theory/time-integration.md), now and at
  // most.
  double remains = 0, most_remains = 0;
  struct Step {
    double value = 0, time = 0, length = 0;  // J; s, at its end; s
    int node = -1;                           // of the mesh, where the motion changed most; -1: not known
    using ContactWith = advice::ContactWith;
    ContactWith with = ContactWith::nothing;  // what acted there
  } climb;                                    // the step that made most since the error was least
  struct Largest {
    double value = 0, time = 0, step = 0;  // J; s, at the end of the step; s, its length
  } made, lost;                            // since the error was least; against the start
  Step worst;                              // of what was made, the step that made most

  // After a step of h [s] that ended at this time; start: of the run; passed: work [J] that came in and went
  // out within the step, of which brought_in has nothing. True: where it changed the motion most is worth
  // knowing; located() follows.
  bool update(const Energy& start, const Energy& now, double time, double h, double passed = 0);
  void located(int node, Step::ContactWith with);
  double size() const;
  // %, of the error against size().
  double percent() const;
  // What a user must not overlook; empty: nothing. fixed: the user chose the step; where: words for
  // worst.node; initial_velocity_key: of the motion that begins with a velocity ("bodies.vessel.motion"), or
  // "".
  std::string warning(bool fixed, const std::string& where,
                      const std::string& initial_velocity_key = "") const;
  // More was made or lost than any result can bear, or it is no number: the run has failed.
  bool wrong() const;
  // What a user may want to know of what the steps did not resolve; empty: it is little.
  std::string note() const;
};

}  // namespace hawser::record
