// Sentences and clauses about steps of time and of statics that cannot be taken, and about states that solve
// the equations and are no results. place: of a line, in words.
#pragma once

#include <string>

#include "hawser/advice/step_findings.hpp"

namespace hawser::advice {

// Why a step, or a trial of statics, is not accepted; empty: by std::monostate.
std::string clause(const StepFinding& found);
std::string imbalance(const Imbalance& at);

struct Overstretched {
  std::string place;
  double strain = 0, most = 0;  // most: that a line of such an EA bears
  double tension = 0, EA = 0;   // N
};
std::string overstretched_in_statics(const Overstretched& at);
std::string overstretched_at(double time, const Overstretched& at);  // s

// Tension known within a part `share` of itself; sufficient: EA [N] equivalent to no stretch.
struct LostInRounding {
  std::string line;
  double share = 0, EA = 0, sufficient = 0;
};
std::string tension_lost_in_statics(const LostInRounding& at);
std::string tension_lost_at(double time, const LostInRounding& at);  // s

// A beam element [m] that is bent by so much [rad]; sufficient: m, of elements that follow it.
struct FoldedElement {
  std::string place;
  double turn = 0, length = 0, sufficient = 0;
};
std::string folded_element(const FoldedElement& at);
// because: by clause().
std::string shortest_step_fails(double time, double step, const std::string& because,
                                const std::string& folded);
std::string no_mass(double time);  // s

}  // namespace hawser::advice
