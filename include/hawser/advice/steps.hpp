// Messages and clauses about rejected steps of dynamics and statics, and about states that solve the
// equations but are no valid results. place: on a line, in words.
#pragma once

#include <string>

#include "hawser/advice/step_findings.hpp"

namespace hawser::advice {

// Reason why a time step or static trial is rejected; empty for std::monostate.
std::string clause(const StepFinding& finding);
std::string imbalance(const Imbalance& at);

struct Overstretched {
  std::string place;
  double strain = 0, limit = 0;  // limit: allowed for such an EA
  double tension = 0, EA = 0;    // N
};
std::string overstretched_in_statics(const Overstretched& at);
std::string overstretched_at(double time, const Overstretched& at);  // s

// The tension is known only to the fraction `fraction`; sufficient: EA [N] that is practically inextensible.
struct LostInRounding {
  std::string line;
  double fraction = 0, EA = 0, sufficient = 0;
};
std::string tension_lost_in_statics(const LostInRounding& at);
std::string tension_lost_at(double time, const LostInRounding& at);  // s

// A beam element of `length` [m] bent by `turn` [rad]; sufficient: element length [m] that resolves the bend.
struct FoldedElement {
  std::string place;
  double turn = 0, length = 0, sufficient = 0;
};
std::string folded_element(const FoldedElement& at);
// because: from clause().
std::string shortest_step_fails(double time, double step, const std::string& because,
                                const std::string& folded);
std::string no_mass(double time);  // s

}  // namespace hawser::advice
