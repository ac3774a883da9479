// Finds an event within a time step: the first zero of functions whose values are known at the start of the
// step and at the ends of its trials.
#pragma once

#include <functional>
#include <vector>

#include "hawser/state/kinematics.hpp"

namespace hawser {

// Functions of the state at the end of a step; an event is where one of them rises through zero. Their number
// is the same at every state, and the values are the same on all ranks. Each is in units of the tolerance of
// its event: below 0 the event has not happened, and a step that ends above 1 has passed it. A function whose
// event can no longer happen is -1. Collective.
using EventFunctions = std::function<std::vector<double>(const Kinematics&)>;

// Chooses the trials of one step until one ends at the first event, half a tolerance after its zero. Regula
// falsi with the weights of Anderson & Björck (1973, BIT 13), between a trial that ends before all events and
// one that ends beyond an event.
class EventSearch {
 public:
  // Called after a trial of h [s]; `end` and `at_start` are the values of the functions at its end and at the
  // start of the step. Returns the length of the next trial, or h if the step may end there. A function that
  // jumps is located to twice the shortest step [s].
  double next(double h, double shortest, const std::vector<double>& end, const std::vector<double>& at_start);

 private:
  double before_ = 0, beyond_ = 0;    // s, trials that end before and beyond the event; beyond_ = 0: none yet
  std::vector<double> left_, right_;  // weighted function values minus the aim, at the ends of those trials
  int moved_ = 0;                     // bound replaced by the last trial: -1 before, 1 beyond, 0 none
};

}  // namespace hawser
