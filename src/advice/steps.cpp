// Sentences about steps that cannot be taken.
#include "hawser/advice/steps.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser::advice {

std::string imbalance(const Imbalance& at) {
  if (!at.finite)
    return at.place +
           ", has forces beyond all numbers; is its mass, its load, its EA or the gravity in another unit?";
  return at.turns ? fmt::format("{}, is out of balance by {:.3g} N m (moments of size {:.3g} N m)", at.place,
                                at.value, at.scale)
                  : fmt::format("{}, is out of balance by {:.3g} N (forces of size {:.3g} N)", at.place,
                                at.value, at.scale);
}

std::string overstretched(const Overstretched& at) {
  return fmt::format(
      "{}, is {} by {:.3g} % by {:.3g} N on an EA of {:.3g} N, and {:g} % is more than any line of such an "
      "EA bears",
      at.place, at.strain > 0 ? "stretched" : "pressed together", 100 * std::abs(at.strain),
      std::abs(at.tension), at.EA, 100 * std::abs(at.most));
}

std::string overstretched_in_statics(const std::string& what) {
  return fmt::format("statics: {}: is the load, the length or the EA in another unit?", what);
}

std::string overstretched_at(double time, const std::string& what) {
  return fmt::format("at t = {:.6g} s {}: does something pull at once that should have a 'ramp'?", time,
                     what);
}

std::string tension_lost_in_rounding(const std::string& line, double share, double EA, double sufficient) {
  return fmt::format(
      "the tension of line {} is known to within {:.2g} % only, so large is rounding beside an EA of {:.3g} "
      "N; an EA of {:.0e} N is equivalent to one that does not stretch",
      line, 100 * share, EA, sufficient);
}

std::string not_converged(const std::string& imbalance) {
  return "Newton's iteration does not converge: " + imbalance;
}

std::string turns_too_far(const std::string& place, double angle) {
  return fmt::format("{}, turns by {:.3g} rad in it, and a step follows half a turn at most", place, angle);
}

std::string element_turns_over(const std::string& place) {
  return fmt::format("{}, a beam element folds: its ends turn against each other by more than half a turn",
                     place);
}

std::string impact_not_resolved() { return "it does not resolve an impact that its start did not show"; }

std::string error_too_large(double error) {
  return fmt::format("its local error of {:.3g} m is too large", error);
}

std::string beyond_contact_search() { return "lines move farther in it than the contact search covers"; }

std::string line_passes_volume() { return "in it a line would pass through a volume"; }

std::string body_passes_body() { return "in it a body would pass through another one"; }

std::string feeds_too_fast(const std::string& feeder) {
  return feeder + " is paid out or hauled in by more of an element than one step can follow";
}

std::string folded_element(const FoldedElement& at) {
  return fmt::format(
      "; {}, is bent by {:.0f} degrees within an element of {:.3g} m: elements of {:.2g} m would follow "
      "that, and if it is not meant to fold, a slower motion, 'EI' or 'stiffness_damping' keeps it from it",
      at.place, at.turn * 180 / M_PI, at.length, at.sufficient);
}

std::string shortest_step_fails(double time, double step, const std::string& because,
                                const std::string& folded) {
  return fmt::format("stopped at t = {:.6g} s: the shortest step ({:.3g} s) cannot be taken: {}{}", time,
                     step, because, folded);
}

std::string no_mass(double time) {
  return fmt::format(
      "at t = {:.6g} s the mass matrix is singular: some part of a line has no mass (is a rotary_inertia "
      "zero?)",
      time);
}

}  // namespace hawser::advice
