// Messages about static equilibrium.
#include "hawser/advice/statics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hawser/advice/steps.hpp"
#include "hawser/base/count_of.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/model/notes.hpp"

namespace hawser::advice {

std::string slack_at_rest(const std::string& line, double length, bool relaxed) {
  return fmt::format(
      "lines.{}: {:.3g} m of it have no tension at rest and can rest in other positions as well; {}", line,
      length,
      relaxed
          ? "this is one of them; give 'start' near the intended one"
          : "rounding or the number of ranks may decide which one is found: give 'start' near the intended "
            "one, or set 'statics: {dynamic_relaxation: always}', which lets the line fall to rest");
}

std::string no_waterplane(const std::string& body) {
  return fmt::format(
      "bodies.{}: it floats at the surface, and in_water has no waterplane stiffness in roll and pitch, so "
      "that their periods and amplitudes are wrong: give turning_stiffness, rho g times the second moments "
      "of area of the waterplane",
      body);
}

std::string lie_on_bed(const std::vector<std::string>& lines, const std::vector<OnBed>& values) {
  const auto range = [&](double OnBed::*member, double unit) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const OnBed& v : values) {
      low = std::min(low, v.*member / unit);
      high = std::max(high, v.*member / unit);
    }
    const std::string from = fmt::format("{:.4g}", low);
    const std::string to = fmt::format("{:.4g}", high);
    return from == to ? from : from + " to " + to;
  };
  std::string friction = "without friction in statics";
  if (values.front().with_friction)
    friction = fmt::format("where friction takes {} kN of tension and is not fully mobilised over {} m",
                           range(&OnBed::friction_tension, 1e3), range(&OnBed::sticking, 1));
  return fmt::format("{}{}: {} m on the seabed, {}", lines.size() > 1 ? "lines " : "lines.",
                     model::names_text(lines), range(&OnBed::lies, 1), friction);
}

std::string held_without_weight(const std::string& body, bool with_friction) {
  return fmt::format(
      "bodies.{}: statics holds it in its initial position and without its weight, since it does not start "
      "at rest in contact{}; as dynamics begins it falls onto its contact and may bounce and slide; {}set "
      "'statics: {{contact_friction: true}}' to let it come to rest in contact",
      body, with_friction ? "" : ", and nothing holds it along the volumes that it can touch",
      with_friction ? "" : "give the volumes 'friction' and ");
}

std::string left_without_friction(const std::string& body, const std::string& volume, double friction) {
  return fmt::format(
      "bodies.{}: statics moves it off volume {}, on which it starts, without their friction of {:.3g}; set "
      "'statics: {{contact_friction: true}}' if friction holds it there",
      body, volume, friction);
}

std::string moved_without_friction(const std::string& body, double distance, const std::string& volume,
                                   double friction) {
  return fmt::format(
      "bodies.{}: statics moves it by {:.3g} m along volume {}, on which it rests, without their friction of "
      "{:.3g}; set 'statics: {{contact_friction: true}}' if friction holds it",
      body, distance, volume, friction);
}

std::string toppled_in_statics(const std::string& body, double angle, const std::string& volume) {
  return fmt::format(
      "bodies.{}: statics topples or rolls it on volume {}: at rest it is tilted by {:.3g} degrees from its "
      "initial position; if that is not intended, check 'position', 'rotation_deg' and its centre of mass",
      body, volume, angle / kDegree);
}

std::string unstable_equilibria_left(int equilibria) {
  return fmt::format(
      "the search passed through {} (lines buckled or snapped through, or a body heeled or capsized): the "
      "model can rest in more than one shape; check that this is the intended one, and give `start` near it "
      "if not",
      count_of(equilibria, "unstable equilibrium", "unstable equilibria"));
}

std::string unstable_at_rest(long eigenvalues) {
  return fmt::format(
      "the static equilibrium is unstable ({}), and statics has not found a stable one near it: start lines "
      "(`start`) or floating bodies (`position`, `rotation_deg`) where they can rest, or restrain them",
      count_of(eigenvalues, "negative eigenvalue"));
}

namespace {

std::string hooked_lines(const HookedLines& h) {
  return fmt::format(
      "line {} at arc length {:.4g} m and line {} at {:.4g} m hold each other and slide without friction",
      h.line, h.arc, h.other, h.other_arc);
}

std::string hold_by_friction(const HookedLines& h) {
  return h.friction
             ? "'statics: {contact_friction: true}' lets them come to rest"
             : "'friction' in 'contact: {between_lines: ...}' with 'statics: {contact_friction: true}' "
               "lets them come to rest";
}

}  // namespace

std::string long_relaxation(const LongRelaxation& r) {
  std::vector<std::string> ways;
  if (r.hooked)
    ways.push_back(hooked_lines(*r.hooked) + ": " + hold_by_friction(*r.hooked));
  else if (r.line_pairs)
    ways.emplace_back(
        "if folds of slack lines touch one another, 'contact: {between_lines: false}' excludes that contact "
        "and may help");
  if (r.slides_freely)
    ways.emplace_back(
        "if a line slides along a volume, 'friction' of that volume with 'statics: {contact_friction: true}' "
        "holds it");
  return fmt::format("statics has not come to rest in {} of dynamic relaxation{}{}",
                     count_of(r.steps, "step"), ways.empty() ? "" : "; ", fmt::join(ways, "; "));
}

std::string automatic_stiffness_unsettled() {
  return "statics: the automatic contact stiffness, or the direction of a buried stretch, does not converge; "
         "give the volumes a normal_stiffness, or shorten the buried stretches of lines that resist bending";
}

std::string no_equilibrium(StaticsEnds how, int limit, const Imbalance& at) {
  switch (how) {
    case StaticsEnds::too_many_iterations:
      return fmt::format("statics: Newton's method does not converge within {} ('max_iterations'): {}",
                         count_of(limit, "iteration"), imbalance(at));
    case StaticsEnds::no_descent:
      return "statics: the line search finds no smaller residual: " + imbalance(at);
    case StaticsEnds::stagnation:
      return "statics: Newton's method hardly moves the lines and does not reduce the residual: " +
             imbalance(at);
    case StaticsEnds::forces_beyond_numbers:
      break;
  }
  return "statics: " + imbalance(at);
}

std::string no_rest(int steps, const Imbalance& at) {
  return fmt::format("statics: not at rest after {} of dynamic relaxation: {}", count_of(steps, "step"),
                     imbalance(at));
}

std::string rests_by_contact_friction() {
  return "statics found no equilibrium without friction of contact, so that lines and bodies came to rest "
         "with it on the path from their start ('statics: {contact_friction: true}'): their forces depend on "
         "this path, by as much as friction can hold";
}

std::string rests_out_of_balance(const Imbalance& at) {
  return fmt::format(
      "statics ends where no line moves any more, but {}: facets of a mesh meet in kinks, on which a line "
      "finds no exact equilibrium; a 'shape' in place of the mesh, for example a tube, has no kinks",
      imbalance(at));
}

std::string second_failure(const std::string& first, const std::string& second) {
  return fmt::format("{}; after that, {}", first, second);
}

std::string path_blocked(const std::string& because) { return "statics: " + because; }

std::string body_moves_on(const std::string& place, double far) {
  return fmt::format(
      "statics: {} has moved by {:.3g} m and does not come to rest: its lines, springs, supports and "
      "friction do not balance the loads on it",
      place, far);
}

std::string more_lines_on_bed(size_t lines) { return fmt::format("{} more lines are on the seabed", lines); }

std::string lie_below_water(const std::vector<std::string>& lines, double below, double depth,
                            bool with_anchor) {
  const std::string bed =
      with_anchor
          ? "a 'seabed' through its anchors, of which one is down there: 'depth' with 'slope_deg', or 'grid'"
          : fmt::format("'environment: {{seabed: {{depth: {:.6g}}}}}'", depth);
  return fmt::format(
      "{}{}: at rest {:.4g} m below the bottom of the water, whose depth is {:.6g} m, since the case has no "
      "seabed: give {}",
      lines.size() > 1 ? "lines " : "lines.", model::names_text(lines), below, depth, bed);
}

std::string singular_mooring() {
  return "the stiffness of the mooring is singular: a part of a line has no stiffness against some motion at "
         "rest";
}

std::string statics_failed(const model::Case& c, const std::optional<HookedLines>& hooked) {
  std::vector<std::string> ways;
  const bool has_friction = c.contact.has_friction(c.volumes);
  const bool with_friction = c.statics.contact_friction.value_or(has_friction);  // has been tried
  if (hooked && !with_friction)
    return fmt::format("statics has failed: {}; {}; see docs/how-to/failing-runs.md", hooked_lines(*hooked),
                       hold_by_friction(*hooked));
  const bool on_mesh =
      !c.lines.empty() &&
      std::any_of(c.volumes.begin(), c.volumes.end(), [](const model::Volume& v) { return !v.mesh.empty(); });
  if (!c.lines.empty() && !c.volumes.empty() && !with_friction)
    ways.push_back(fmt::format(
        "where a line slides along a volume or finds no rest on its facets, {}",
        has_friction ? "its friction, without 'contact_friction: false'" : "'friction' of that volume"));
  if (on_mesh) ways.emplace_back("'shape: {tube: ...}' for a mesh that is a tube");
  if (c.statics.relaxation == model::Relaxation::never)
    ways.emplace_back("without 'dynamic_relaxation: never'");
  else if (!on_mesh && c.statics.relaxation == model::Relaxation::automatic && !with_friction)
    ways.emplace_back("'statics: {dynamic_relaxation: always}'");
  if (c.environment.water.present && !c.environment.water.current.profile.empty() &&
      !(c.environment.water.current.ramp > 0) && c.dynamics.enabled)
    ways.emplace_back("a 'ramp' of the current, which then begins in dynamics");
  const std::vector<model::BodyPair> bodies = model::body_pairs(c);
  const bool on_bodies = std::any_of(bodies.begin(), bodies.end(),
                                     [](const model::BodyPair& p) { return p.friction.axial > 0; });
  if (on_bodies)
    ways.emplace_back(with_friction ? "more 'friction' of volumes on which a body slides"
                                    : "'contact_friction: true', so that friction holds bodies");
  if (c.statics.contact_friction.value_or(false))
    ways.emplace_back("'contact_friction: false'");
  else if (const model::Seabed& bed = c.environment.seabed; bed.present && bed.full)
    ways.emplace_back("'friction_in_statics: as_laid'");
  else if (bed.present && bed.as_laid && (bed.friction.axial > 0 || bed.friction.lateral > 0))
    ways.emplace_back("'friction_in_statics: none' of the seabed, whose friction then begins in dynamics");
  for (const model::Line& line : c.lines)
    if (line.starts_by_itself()) {
      ways.push_back(fmt::format("'start: {{points: ...}}' of line {}, near where it will rest", line.name));
      break;
    }
  if (!hooked && c.contact.between_lines.enabled && !c.lines.empty())
    ways.emplace_back("'contact: {between_lines: false}'");
  if (std::any_of(c.bodies.begin(), c.bodies.end(), [](const model::Body& b) { return bool(b.mass); }))
    ways.emplace_back(
        "stiffness, hydrostatics, lines or thrusters that can balance the loads of each floating body");
  constexpr size_t kMost = 3;
  if (ways.size() > kMost) ways.resize(kMost);
  return fmt::format("statics has failed; what may help: {}{}see docs/how-to/failing-runs.md",
                     fmt::join(ways, "; "), ways.empty() ? "" : "; ");
}

}  // namespace hawser::advice
