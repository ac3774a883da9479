// Sentences about contact stiffness: which one was chosen or raised, where one is too low, and what helps.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

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

// A line that is deeper in a volume than its law is for. place: of the line, in words.
struct TooDeep {
  std::string place;
  double depth = 0, radius = 0;  // m; of the line
  double time = 0;               // s
  bool automatic = false;        // the stiffness is, and was raised
};
std::string too_deep(const model::Volume& volume, const TooDeep& at);

// A line that would be drawn through a volume on its way to an equilibrium. too_soft: by a stiffness that the
// case gives.
std::string drawn_through(const model::Volume& volume, const std::string& place, bool too_soft);

// Lines that would pass through each other. places: of both, in words.
std::string lines_pass(const std::string& places);
std::string lines_start_too_near(const std::string& places);
struct PressedLines {
  std::string places;
  double depth = 0, radii = 0;                   // m; the sum of both
  double stiffness = 0, wanted = 0;              // N/m per m: it is; it should be, which is rounded up
  double energy = 0;                             // J, in the contact
  std::string only_of = {}, only_of_other = {};  // lines, where the case has a stiffness for these two
};
std::string lines_too_soft(const PressedLines& at);

// Bodies that are in each other by `depth` [m], beyond what their corners and edges met [m]; time in s.
std::string bodies_overlap(const std::string& one, const std::string& other, double depth, double met,
                           double time);

}  // namespace hawser::advice
