// Where in a time step an event is: the zero of functions of which its start and the ends of tries are known.
#pragma once

#include <functional>
#include <vector>

#include "hawser/state/kinematics.hpp"

namespace hawser {

// The functions whose rise through zero is an event, of the state at the end of a step: as many at every
// state, the same on all ranks. Each is measured in the tolerance to which its event is to be found: below 0
// the event has not happened, and a step that ends above 1 has gone beyond it. One that can no longer happen
// is -1. Collective.
using EventFunctions = std::function<std::vector<double>(const Kinematics&)>;

// Of one step: which try comes next, until one ends at the first event, half a tolerance behind its zero.
// Regula falsi with the weights of Anderson & Björck (1973, BIT 13), between a try that ends before all
// events and one that ends beyond.
class EventSearch {
 public:
  // After a try of h [s] with these values of the functions at its end: the length of the next try; h, where
  // the step may end so. `at_start` are the values at the start of the step. A jump is found to twice
  // the shortest step [s].
  double next(double h, double shortest, const std::vector<double>& end, const std::vector<double>& at_start);

 private:
  double before_ = 0, beyond_ = 0;    // s, of the tries between which the events are; beyond_ 0: none is
  std::vector<double> left_, right_;  // the functions there, from the aim, with their weights
  int moved_ = 0;                     // which of the two the last try replaced: -1, 1; 0: neither yet
};

}  // namespace hawser
