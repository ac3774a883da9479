// Messages about contact stiffness.
#include "hawser/advice/contact_stiffness.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser::advice {
namespace {

constexpr double kProposed = 0.05;  // of the radius: penetration at the recommended stiffness

const char* name_of(StiffnessReason::Bend bend) {
  switch (bend) {
    case StiffnessReason::Bend::over_edge:
      return "the smallest radius to which this tension bends the line's EI over an edge";
    case StiffnessReason::Bend::largest:
      return "the largest radius that is assumed";
    case StiffnessReason::Bend::of_shape:
      return "that of the shape";
    case StiffnessReason::Bend::unknown:
      break;
  }
  return "assumed, as the volume's curvature is not known";
}

const char* key_of(model::StiffnessBasis basis) {
  return basis == model::StiffnessBasis::per_point    ? "per_point"
         : basis == model::StiffnessBasis::per_length ? "per_length"
                                                      : "per_area";
}

// Rounds up to two digits.
double rounded_up(double v) {
  const double unit = std::pow(10, std::floor(std::log10(v)) - 1);
  return std::ceil(v / unit) * unit;
}

std::string places(const NearestPlaces& at) {
  return fmt::format("lines {} (arc length {:.6g} m) and {} (arc length {:.6g} m)", at.one, at.arc, at.other,
                     at.other_arc);
}

}  // namespace

std::string chosen_stiffness(const std::string& volume, double stiffness, const StiffnessReason& reason,
                             double bounce, double step) {
  std::string note = fmt::format(
      "volume {}: normal stiffness {:.3g} N/m per m: a tension of {:.3g} N ({}) bent to a radius of {:.3g} m "
      "({}) and the line's weight of {:.3g} N/m penetrate by {}{:.3g} m",
      volume, stiffness, reason.tension,
      reason.has_weight ? "the line's weight" : "1e-4 of its EA, as it has no weight", reason.radius,
      name_of(reason.bend), reason.weight,
      reason.penetration_given ? "the allowed " : "0.5 % of the line's radius, ", reason.penetration);
  if (bounce > 0)
    note += fmt::format(
        "; an impact on it lasts {:.2g} s, and 1.5 steps of {:.2g} s are needed to resolve its force", bounce,
        step);
  return note;
}

std::string settles(const SettledSupport& at) {
  const std::string remedy =
      at.by_smoothing ? fmt::format("'smoothing: {:.1g}'", at.remedy)
      : at.roller     ? fmt::format("a normal_stiffness of {:.1g} N/m", at.remedy)
                      : fmt::format("'normal_stiffness: {{allowed_penetration: {:.1g}}}'", at.remedy);
  return fmt::format(
      "line {} settles where it rests on volumes, by a penetration of {:.2g} m in volume {} at arc length "
      "{:.6g} m and by other amounts at its other supports, which changes its reaction there by {:.2g} % and "
      "the bending moment by {:.2g} % of the largest; give {} and the volumes beside it {}",
      at.line, at.penetration, at.volume, at.arc, 100 * at.of_reaction, 100 * at.of_moment,
      at.roller ? at.volume : "volumes." + at.volume, remedy);
}

std::string raised_stiffness(const StiffnessRaise& raise, const std::string& when) {
  return fmt::format(
      "volume {}: normal stiffness raised from {:.3g} to {:.3g} N/m per m {}, so that the penetration of the "
      "line under its tension and under impacts stays within the allowed value",
      raise.volume, raise.before, raise.after, when);
}

std::string too_deep(const TooDeep& at) {
  const std::string text =
      fmt::format("{}, is {:.3g} m deep in volume {} at t = {:.3g} s, deeper than its radius of {:.3g} m{}",
                  at.place, at.depth, at.law.volume, at.time, at.radius,
                  at.law.table ? " and deeper than the last row of the force table" : "");
  if (at.law.automatic)
    return fmt::format(
        "{}, at an automatic stiffness of {:.3g} N/m per m, which cannot usefully be higher: the line starts "
        "inside the volume or its ends pull it in; move the line or the volume, or exclude the volume from "
        "'contact.volumes'",
        text, at.law.stiffness);
  if (at.law.table)
    return text + ": add rows up to the largest contact force to the table, or set 'normal_stiffness: auto'";
  return fmt::format(
      "{}, the limit of the contact model: a stiffness of {{{}: {:.3g}}} would keep the penetration to about "
      "5 % of the radius ('auto' chooses such a value), and a line that is to penetrate deeper needs a "
      "larger 'contact_diameter'",
      text, key_of(at.law.basis), at.law.stiffness * at.depth / (kProposed * at.radius));
}

std::string too_deep_at_rest(const TooDeep& at) { return "statics: " + too_deep(at); }

std::string pulled_through(const PulledThrough& at) {
  const std::string text = fmt::format("{}, would pass through volume {}", at.place, at.law.volume);
  if (!at.too_soft) return text + "; state on which side it lies with 'start: {points: [[x, y, z], ...]}'";
  return text +
         (at.law.table
              ? ": add rows up to the largest contact force to its table, or set 'normal_stiffness: auto'"
              : ": its normal_stiffness is too small for the contact force; 'auto' chooses a sufficient "
                "value");
}

std::string lines_pass(const NearestPlaces& at) { return places(at) + " would pass through each other"; }

std::string lines_start_too_near(const NearestPlaces& at) {
  return lines_pass(at) + ": at the start their axes are closer than the sum of their radii";
}

std::string lines_too_soft(const PressedLines& at) {
  std::string key = fmt::format("normal_stiffness: {{per_length: {:.2g}}}", rounded_up(at.required));
  if (at.given) key = fmt::format("pairs: [{{lines: [{}, {}], {}}}]", at.at.one, at.at.other, key);
  return fmt::format(
      "{} penetrate each other by {:.3g} m, {:.0f} % of the sum of their radii, and would pass through each "
      "other: their contact stiffness, {:.3g} N/m per m, is too small for the contact force ({:.3g} J of "
      "contact energy). Try contact: {{between_lines: {{{}}}}}",
      places(at.at), at.depth, 100 * at.depth / at.radii, at.stiffness, at.energy, key);
}

std::string body_too_soft(const BodyPressedThrough& at) {
  const std::string text = fmt::format(
      "{} is pressed {:.3g} m deep into {}, past the middle of its thickness of {:.3g} m, from where contact "
      "pushes it out on the far side",
      at.volume, at.depth, at.other, at.thickness);
  if (at.table)
    return text +
           ": the force table of their contact is too soft for the load or the speed; add rows with "
           "larger forces";
  return fmt::format(
      "{}: unless it starts too deep, a contact stiffness of {:.3g} is too small for the load or the speed; "
      "try 'normal_stiffness: {{{}: {:.2g}}}' for {}{}",
      text, at.stiffness, key_of(at.basis), rounded_up(at.required), at.volume,
      at.both ? " and " + at.other + ", of which the lower value counts" : "");
}

std::string bodies_overlap(const std::string& one, const std::string& other, double depth, double penetration,
                           double time, const std::string& slave) {
  const std::string points = slave.empty()
                                 ? "their contact points (corners and edges)"
                                 : fmt::format("the contact points (corners and edges) of {}", slave);
  return fmt::format(
      "at t = {:.6g} s {} and {} overlap by {:.3g} m, but {} penetrate by {:.3g} m at most; give them "
      "stiffnesses per_area (per_length where edges cross), or a sphere or capsule where they touch",
      time, one, other, depth, points, penetration);
}

}  // namespace hawser::advice
