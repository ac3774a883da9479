// Sentences and clauses about steps of time and of statics that cannot be taken, and about states that solve
// the equations and are no results. place: of a line, in words.
#pragma once

#include <string>

namespace hawser::advice {

// The largest residual, in N, or N m if it `turns`.
struct Imbalance {
  std::string place;
  double value = 0, scale = 0;  // scale: of the forces or moments that act
  bool turns = false;
  bool finite = true;
};
std::string imbalance(const Imbalance& at);

struct Overstretched {
  std::string place;
  double strain = 0, most = 0;  // most: that a line of such an EA bears
  double tension = 0, EA = 0;   // N
};
std::string overstretched(const Overstretched& at);
std::string overstretched_in_statics(const std::string& what);
std::string overstretched_at(double time, const std::string& what);  // s

// Tension known within a part `share` of itself; sufficient: EA [N] equivalent to no stretch.
std::string tension_lost_in_rounding(const std::string& line, double share, double EA, double sufficient);

// Of a step: clauses that say why it is not taken.
std::string not_converged(const std::string& imbalance);
std::string element_turns_over(const std::string& place);
std::string turns_too_far(const std::string& place, double angle);  // rad
std::string impact_not_resolved();
std::string error_too_large(double error);  // m
std::string beyond_contact_search();
std::string line_passes_volume();
std::string body_passes_body();
std::string feeds_too_fast(const std::string& feeder);

// A beam element [m] that is bent by so much [rad]; sufficient: m, of elements that follow it.
struct FoldedElement {
  std::string place;
  double turn = 0, length = 0, sufficient = 0;
};
std::string folded_element(const FoldedElement& at);
// because: a clause of those above.
std::string shortest_step_fails(double time, double step, const std::string& because,
                                const std::string& folded);
std::string no_mass(double time);  // s

}  // namespace hawser::advice
