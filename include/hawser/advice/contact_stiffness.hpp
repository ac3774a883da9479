// Sentences about contact stiffness: which one was chosen or raised, where one is too low, and what helps.
#pragma once

#include <string>

#include "hawser/advice/step_findings.hpp"

namespace hawser::advice {

// What decided an automatic stiffness of a volume.
struct StiffnessReason {
  enum class Bend { over_edge, largest, of_shape, unknown };  // what the radius of bending is
  double tension = 0, weight = 0;                             // N, N/m
  bool has_weight = true;                                     // the tension is by weight, else by EA
  double radius = 0;                                          // m, of bending
  Bend bend = Bend::unknown;
  double penetration = 0;          // m, by which tension and weight press in
  bool penetration_given = false;  // by the case
};

// A normal stiffness [N/m per m] that was chosen, and why; bounce: s that one on it takes, where it is less
// than steps of `step` [s] show; 0: it is not.
std::string chosen_stiffness(const std::string& volume, double stiffness, const StiffnessReason& reason,
                             double bounce, double step);
// From and to [N/m per m]; when: "in statics" or the like.
std::string raised_stiffness(const std::string& volume, double from, double to, const std::string& when);

// The end of statics.
std::string too_deep_at_rest(const TooDeep& at);
// Clauses of steps.hpp.
std::string too_deep(const TooDeep& at);
std::string drawn_through(const DrawnThrough& at);
std::string lines_pass(const NearestPlaces& at);
std::string lines_start_too_near(const NearestPlaces& at);
std::string lines_too_soft(const PressedLines& at);

// Bodies that are in each other by `depth` [m], beyond what their corners and edges met [m]; time in s.
std::string bodies_overlap(const std::string& one, const std::string& other, double depth, double met,
                           double time);

}  // namespace hawser::advice
