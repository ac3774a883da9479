// Messages about contact stiffness: chosen or raised values, values that are too low, and remedies.
#pragma once

#include <string>

#include "hawser/advice/step_findings.hpp"

namespace hawser::advice {

// Basis of an automatic stiffness of a volume.
struct StiffnessReason {
  enum class Bend { over_edge, largest, of_shape, unknown };  // origin of the bending radius
  double tension = 0, weight = 0;                             // N, N/m
  bool has_weight = true;  // the tension follows from the weight, else from EA
  double radius = 0;       // m, bending radius
  Bend bend = Bend::unknown;
  double penetration = 0;          // m, under tension and weight
  bool penetration_given = false;  // penetration given by the case
};

// Chosen normal stiffness [N/m per m] and its reason; bounce: duration [s] of a bounce on it if steps of
// `step` [s] do not resolve it, else 0.
std::string chosen_stiffness(const std::string& volume, double stiffness, const StiffnessReason& reason,
                             double bounce, double step);
// A raised automatic stiffness of a volume, N/m per m.
struct StiffnessRaise {
  std::string volume;
  double before = 0, after = 0;
};
// when: "in statics" or the like.
std::string raised_stiffness(const StiffnessRaise& raise, const std::string& when);

// A support of a beam that settles by the penetration of contact.
struct SettledSupport {
  std::string line, volume;
  double arc = 0, penetration = 0;  // m; m, negative: a gap
  double of_reaction = 0,
         of_moment = 0;       // error as a fraction of the reaction and of the line's largest moment
  bool by_smoothing = false;  // cause: the smooth onset of contact
  double remedy = 0;          // m, allowed penetration or smoothing; N/m, stiffness of a roller
  bool roller = false;        // the volume is part of a support
};
std::string settles(const SettledSupport& at);

// For the end of statics.
std::string too_deep_at_rest(const TooDeep& at);
// Clauses used by clause() of steps.hpp.
std::string too_deep(const TooDeep& at);
std::string pulled_through(const PulledThrough& at);
std::string lines_pass(const NearestPlaces& at);
std::string lines_start_too_near(const NearestPlaces& at);
std::string lines_too_soft(const PressedLines& at);
std::string body_too_soft(const BodyPressedThrough& at);

// Bodies that overlap by `depth` [m]; penetration: that of their corners and edges, m; time in s; slave: the
// volume whose corners and edges touch, empty: both.
std::string bodies_overlap(const std::string& one, const std::string& other, double depth, double penetration,
                           double time, const std::string& slave);

}  // namespace hawser::advice
