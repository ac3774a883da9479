// Messages about rejected steps.
#include "hawser/advice/steps.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hawser/advice/contact_stiffness.hpp"

namespace hawser::advice {

std::string imbalance(const Imbalance& at) {
  if (!at.finite)
    return at.place +
           ", has a force that is not a finite number; check the units of its mass, its loads, its EA and of "
           "gravity";
  return at.turns ? fmt::format("{}, is out of balance by {:.3g} N m (moments of size {:.3g} N m)", at.place,
                                at.value, at.scale)
                  : fmt::format("{}, is out of balance by {:.3g} N (forces of size {:.3g} N)", at.place,
                                at.value, at.scale);
}

namespace {

std::string overstretched(const Overstretched& at) {
  return fmt::format(
      "{}, {} {:.3g} % by {:.3g} N on an EA of {:.3g} N; no line with such an EA can carry {:g} %", at.place,
      at.strain > 0 ? "is stretched by" : "is compressed by", 100 * std::abs(at.strain), std::abs(at.tension),
      at.EA, 100 * std::abs(at.limit));
}

std::string lost_in_rounding(const LostInRounding& at) {
  return fmt::format(
      "the tension of line {} is accurate to {:.2g} % only, because of rounding with an EA of {:.3g} N; an "
      "EA of {:.0e} N is practically inextensible",
      at.line, 100 * at.fraction, at.EA, at.sufficient);
}

// One clause per kind of finding.
struct Clause {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const Imbalance& at) const {
    return "Newton's iteration does not converge: " + imbalance(at);
  }
  std::string operator()(const TurnsTooFar& at) const {
    return fmt::format("{}, turns by {:.3g} rad in it, and half a turn is the limit of a step", at.place,
                       at.angle);
  }
  std::string operator()(const ElementTurnsOver& at) const {
    return at.place + ", a beam element folds: its ends turn against each other by more than half a turn";
  }
  std::string operator()(ImpactNotResolved) const {
    return "an impact or a snap load begins within the step, which is too long to resolve it";
  }
  std::string operator()(ErrorTooLarge at) const {
    return fmt::format("its local error of {:.3g} m is too large", at.error);
  }
  std::string operator()(BeyondContactSearch) const {
    return "lines move further than the contact search covers";
  }
  std::string operator()(const LinePassesVolume& at) const {
    return fmt::format("{}, would pass through volume {}", at.place, at.volume);
  }
  std::string operator()(const BodyPassesBody& at) const {
    return fmt::format("{} would pass through {}", at.volume, at.other);
  }
  std::string operator()(const BodyPressedThrough& at) const { return body_too_soft(at); }
  std::string operator()(const FeedsTooFast& at) const {
    return at.feeder + " is paid out or hauled in too fast for the length of its elements and of the step";
  }
  std::string operator()(const TooDeep& at) const { return too_deep(at); }
  std::string operator()(const PulledThrough& at) const { return pulled_through(at); }
  std::string operator()(const LinesPass& at) const { return lines_pass(at.at); }
  std::string operator()(const LinesStartTooNear& at) const { return lines_start_too_near(at.at); }
  std::string operator()(const PressedLines& at) const { return lines_too_soft(at); }
};

}  // namespace

std::string clause(const StepFinding& finding) { return std::visit(Clause(), finding); }

std::string overstretched_in_statics(const Overstretched& at) {
  return fmt::format("statics: {}: check the units of loads, lengths and EA", overstretched(at));
}

std::string overstretched_at(double time, const Overstretched& at) {
  return fmt::format("at t = {:.6g} s {}: is a load or motion applied suddenly that should have a 'ramp'?",
                     time, overstretched(at));
}

std::string tension_lost_in_statics(const LostInRounding& at) { return "statics: " + lost_in_rounding(at); }

std::string tension_lost_at(double time, const LostInRounding& at) {
  return fmt::format("at t = {:.6g} s {}", time, lost_in_rounding(at));
}

std::string folded_element(const FoldedElement& at) {
  return fmt::format(
      "; {}, is bent by {:.0f} degrees within an element of {:.3g} m: elements of {:.2g} m would resolve "
      "that; if it should not fold, a slower motion, 'EI' or 'stiffness_damping' prevents it",
      at.place, at.turn * 180 / M_PI, at.length, at.sufficient);
}

std::string shortest_step_fails(double time, double step, const std::string& because,
                                const std::string& folded) {
  return fmt::format("stopped at t = {:.6g} s: even the shortest step ({:.3g} s) is rejected: {}{}", time,
                     step, because, folded);
}

std::string no_mass(double time) {
  return fmt::format(
      "at t = {:.6g} s the mass matrix is singular: some part of a line has no mass (is a rotary_inertia "
      "zero?)",
      time);
}

}  // namespace hawser::advice
