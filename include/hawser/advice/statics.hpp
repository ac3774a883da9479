// Sentences about static equilibrium: how it was found, what rests, what can be done where it is not found.
#pragma once

#include <string>
#include <vector>

#include "hawser/advice/step_findings.hpp"
#include "hawser/model/case.hpp"

namespace hawser::advice {

// m of a line that have no tension at rest. fell: they came to rest by dynamic relaxation.
std::string slack_at_rest(const std::string& line, double length, bool fell);
// A body in the surface whose stiffness against roll and pitch lacks that of its waterplane.
std::string no_waterplane(const std::string& body);
// Of a line.
struct OnBed {
  double lies = 0;             // m on the seabed
  bool with_friction = false;  // in statics
  double taken = 0;            // N of tension by friction
  double sticking = 0;         // m with friction that is not fully mobilised
};
// Of one line, or of several with one description, with the ranges of their values.
std::string lie_on_bed(const std::vector<std::string>& lines, const std::vector<OnBed>& values);
std::string more_lines_on_bed(size_t lines);
// Of a body with weight that only friction on others would keep in place.
std::string held_without_weight(const std::string& body);
// Equilibria that statics left on its way; eigenvalues below 0 of the one it found.
std::string unstable_equilibria_left(int equilibria);
std::string unstable_at_rest(long eigenvalues);
// So many steps of dynamic relaxation without rest.
std::string long_relaxation(int steps);
// Why statics ends without an equilibrium; at: where the state is farthest from balance.
enum class StaticsEnds { forces_beyond_numbers, too_many_iterations, no_descent };
std::string no_equilibrium(StaticsEnds how, const Imbalance& at);
std::string no_rest(int steps, const Imbalance& at);
// Of a search from the same start by other means, after the first had failed; both in words.
std::string second_failure(const std::string& first, const std::string& second);
// because: by clause() of steps.hpp.
std::string path_blocked(const std::string& because);
// Of a body, by its place in words, that slides or falls on and on; m from where it started.
std::string body_moves_on(const std::string& place, double far);
std::string automatic_stiffness_unsettled();
// No stiffness of a mooring without one of its lines.
std::string singular_mooring();
// What helps most often where statics fails, of what this case has not tried; docs/how-to/failing-runs.md.
std::string statics_failed(const model::Case& c);

// All nodes are on one of several ranks, since whole lines are not cut.
std::string one_rank_has_all();

}  // namespace hawser::advice
