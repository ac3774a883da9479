// Energy audit of a run: external work against energy present, and energy that the time integration has
// created or lost.
#pragma once

#include <string>

#include "hawser/advice/energy.hpp"
#include "hawser/system/force_term.hpp"

namespace hawser::record {

// Sums over all ranks, J.
struct Audit {
  Energy now, change;     // at the last step; since the start
  double brought_in = 0;  // work of supports, ramped, point and dead loads and moving bodies since the start
  // Kinetic + strain + friction + damping + unresolved energy - external work: created energy, or lost if
  // negative.
  double error = 0;
  // Reference of the error over the run so far: initial kinetic energy, absolute work of every step, and
  // strain energy released from the start state.
  double initial_kinetic = 0, absolute_work = 0, released_strain = 0;
  // Largest kinetic energy and change of strain energy since the start at a time, without created energy.
  double largest_energy = 0;
  double largest_strain = 0;  // largest strain energy: scale of rounding errors
  double smallest_error = 0;  // minimum of `error` so far
  // Dissipated so far by friction, damping and the scheme, and the net energy taken out by water.
  double dissipated = 0, smallest_by_water = 0;
  // Created energy that may still be in the lines (docs/theory/time-integration.md): current and largest
  // value.
  double remaining = 0, largest_remaining = 0;
  struct Step {
    double value = 0, time = 0, length = 0;  // J; s, at its end; s
    int node = -1;                           // of the mesh, with the largest change of motion; -1: unknown
    using ContactWith = advice::ContactWith;
    ContactWith with = ContactWith::nothing;  // force acting there
  } largest_step_gain;                        // the step that created most since the error was least
  struct Largest {
    double value = 0, time = 0, step = 0;  // J; s, at the end of the step; s, its length
  } largest_gain, largest_loss;            // created since the error was least; lost since the start
  Step worst;                              // of `largest_gain`: the step that created most

  // Update after a step of h [s] that ended at `time`; start: energies at the start of the run; passed:
  // external work [J] that cancels within the step and is not in brought_in. True: the place of the largest
  // change of motion is needed, and located() must be called.
  bool update(const Energy& start, const Energy& now, double time, double h, double passed = 0);
  void located(int node, Step::ContactWith with);
  double size() const;
  // Error relative to size(), %.
  double percent() const;
  // Warning about the energy error; empty: none. where: description of worst.node; initial_velocity_key: key
  // of the motion that begins with a velocity ("bodies.vessel.motion"), or "".
  std::string warning(advice::StepChoice step, const std::string& where,
                      const std::string& initial_velocity_key = "") const;
  // True if the created or lost energy invalidates the results, or is not finite: the run has failed.
  bool wrong() const;
  // Note on damped, unresolved vibration; empty: it is small.
  std::string note() const;
};

}  // namespace hawser::record
