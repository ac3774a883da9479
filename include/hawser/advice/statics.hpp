// Messages about static equilibrium: how it was found, its contacts, and remedies if it was not found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hawser/advice/step_findings.hpp"
#include "hawser/model/case.hpp"

namespace hawser::advice {

// Length [m] of a line without tension at rest. relaxed: it came to rest by dynamic relaxation.
std::string slack_at_rest(const std::string& line, double length, bool relaxed);
// A floating body without waterplane stiffness in roll and pitch.
std::string no_waterplane(const std::string& body);
// Of a line.
struct OnBed {
  double lies = 0;              // m on the seabed
  bool with_friction = false;   // in statics
  double friction_tension = 0;  // N of tension by friction
  double sticking = 0;          // m with friction that is not fully mobilised
};
// One line, or several with the same description and the ranges of their values.
std::string lie_on_bed(const std::vector<std::string>& lines, const std::vector<OnBed>& values);
std::string more_lines_on_bed(size_t lines);
// Lines of a case without a seabed, up to `below` [m] deeper than the depth of the water [m]; with_anchor:
// one of their anchors is, too.
std::string lie_below_water(const std::vector<std::string>& lines, double below, double depth,
                            bool with_anchor);
// A body with weight that only friction on other bodies would hold; with_friction: the case has it.
std::string held_without_weight(const std::string& body, bool with_friction);
// A body that statics moves by `distance` [m] along a volume with this coefficient of friction, which it
// excludes.
std::string moved_without_friction(const std::string& body, double distance, const std::string& volume,
                                   double friction);
// A body that statics topples or rolls on a volume, and that rests there tilted by `angle` [rad].
std::string toppled_in_statics(const std::string& body, double angle, const std::string& volume);
// A body that statics lifts or moves off a volume on which it starts, with this coefficient of friction,
// which it excludes.
std::string left_without_friction(const std::string& body, const std::string& volume, double friction);
// Unstable equilibria that statics left; number of negative eigenvalues of the one found.
std::string unstable_equilibria_left(int equilibria);
std::string unstable_at_rest(long eigenvalues);
// Two lines that hold each other by contact, as two hooked slings; arc lengths in m.
struct HookedLines {
  std::string line, other;
  double arc = 0, other_arc = 0;
  bool friction = false;  // the case has friction between lines
};
// Dynamic relaxation that takes unusually long.
struct LongRelaxation {
  int steps = 0;                           // so far
  bool line_pairs = false;                 // lines may touch one another
  bool slides_freely = false;              // lines touch volumes without friction
  std::optional<HookedLines> hooked = {};  // without friction in statics
};
std::string long_relaxation(const LongRelaxation& r);
// Reason why statics ends without an equilibrium; at: place of the largest residual; limit: of Newton's
// iterations.
enum class StaticsEnds { forces_beyond_numbers, too_many_iterations, no_descent, stagnation };
std::string no_equilibrium(StaticsEnds how, int limit, const Imbalance& at);
std::string no_rest(int steps, const Imbalance& at);
// Statics without friction of contact failed; the model rests by this friction.
std::string rests_by_contact_friction();
// Lines that no longer move, with this residual.
std::string rests_out_of_balance(const Imbalance& at);
// Messages of a failed search and of a second one from the same start by other means.
std::string second_failure(const std::string& first, const std::string& second);
// because: from clause() of steps.hpp.
std::string path_blocked(const std::string& because);
// A body, described by `place`, that keeps sliding or falling; far: distance from its start, m.
std::string body_moves_on(const std::string& place, double far);
std::string automatic_stiffness_unsettled();
// The stiffness of a mooring is undefined without one of its lines.
std::string singular_mooring();
// The most effective remedies for failed statics that this case does not use; docs/how-to/failing-runs.md.
// hooked: lines that held each other without friction in statics.
std::string statics_failed(const model::Case& c, const std::optional<HookedLines>& hooked = {});

}  // namespace hawser::advice
