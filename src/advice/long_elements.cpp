// Messages about elements that are too long.
#include "hawser/advice/long_elements.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser::advice {
namespace {

std::string touched(const LongElements& at) { return at.over_line ? "a line" : "a volume"; }

// Error as a percentage of the largest value. The estimates are asymptotic; from 50 % on no number is given.
std::string off_by(double fraction) {
  return fraction < 0.5 ? fmt::format("by about {:.2g} % of the largest", 100 * fraction)
                        : "by half of the largest and more";
}

constexpr double kReported = 0.01;  // of the friction over an edge

// Effect of bending stiffness on the friction over a sharp edge (docs/theory/element-length.md); empty:
// small.
std::string friction_of_beam(double turn) {
  const double lower = turn * turn / 24;
  return lower < kReported
             ? ""
             : fmt::format(", which itself reduces friction over a sharp edge by {:.0f} %", 100 * lower);
}

}  // namespace

std::string turns_on_edge(const std::string& line, const LongElements& at, double largest, double EI,
                          double turn) {
  const std::string bending =
      at.held ? ""
              : fmt::format(
                    "give its type an 'EI' of {:.2g} N m² or more (a quarter of that with elements half "
                    "as long){}, or ",
                    EI, friction_of_beam(turn));
  return fmt::format(
      "line {} turns by {:.0f} degrees over {} from one straight element of {:.3g} m to the next (arc "
      "length {:.4g} m, t = {:.4g} s), which changes its tension there by {:.2g} N, {:.2g} % of the "
      "largest: {}use elements of {:.2g} m there{}",
      line, at.turn * 180 / M_PI, touched(at), at.length, at.arc, at.time, at.error, 100 * at.error / largest,
      bending, at.recommended,
      at.held ? " (bending stiffness would also change the tension, because both ends are held)" : "");
}

std::string longer_over_contact(const std::string& line, const LongElements& at, double largest) {
  return fmt::format(
      "the straight elements of line {} over {} are {:.2g} m longer than the curve over it, most at arc "
      "length {:.4g} m (elements of {:.3g} m, turn {:.0f} degrees, t = {:.4g} s); because both ends of the "
      "line are held, its tension is wrong {}: use elements of {:.2g} m there",
      line, touched(at), at.excess, at.arc, at.length, at.turn * 180 / M_PI, at.time,
      off_by(at.error / largest), at.recommended);
}

std::string sags_between_nodes(const std::string& line, const LongElements& at, double largest) {
  return fmt::format(
      "line {} sags between the nodes of its elements of {:.3g} m: it turns by {:.2g} degrees from one to "
      "the next (arc length {:.4g} m, t = {:.4g} s), and its tension is wrong {}: use elements of {:.2g} m "
      "there",
      line, at.length, at.turn * 180 / M_PI, at.arc, at.time, off_by(at.error / largest), at.recommended);
}

std::string leaves_bed_within(const std::string& line, const LongElements& at, double largest) {
  return fmt::format(
      "line {} leaves the bed steeply within an element of {:.3g} m (arc length {:.4g} m), which does not "
      "resolve the touchdown point, and its tension is wrong by about {:.2g} % of the largest: use elements "
      "of {:.2g} m there",
      line, at.length, at.arc, 100 * at.error / largest, at.recommended);
}

std::string moment_between_nodes(const std::string& line, const LongElements& at, double largest) {
  return fmt::format(
      "the bending moment of line {} decays within {:.3g} m at arc length {:.4g} m (t = {:.4g} s), and with "
      "elements of {:.3g} m it is wrong {}{}: use elements of {:.2g} m there",
      line, at.decay, at.arc, at.time, at.length, off_by(at.error / largest),
      at.held ? ", and the tension between its held ends perhaps by more" : "", at.recommended);
}

std::string long_in_flow(const LongInFlow& at) {
  const std::string why = at.crossed       ? "within which the surface lies"
                          : !at.in_waves   ? "between whose nodes the current is not linear"
                          : !at.in_current ? "between whose nodes the waves are not linear"
                                           : "between whose nodes current and waves are not linear";
  const double percent = 100 * at.error / at.force;
  return fmt::format(
      "line {} has elements of {:.3g} m at arc length {:.4g} m ({:.3g} m {} the still water, t = {:.4g} s), "
      "{}, and the hydrodynamic forces on the elements of {} are wrong by about {:.{}f} % of their largest "
      "sum, {:.3g} kN: use elements of {:.2g} m there",
      at.line, at.length, at.arc, std::abs(at.z), at.z > 0 ? "above" : "below", at.time, why,
      at.joined > 1 ? fmt::format("the {} lines that are joined there", at.joined) : "the line", percent,
      percent < 9.95 ? 1 : 0, at.force / 1000, at.recommended);
}

std::string more_long_in_flow(size_t lines) {
  return fmt::format("; the elements of {} more lines are too long for the flow, with smaller errors", lines);
}

}  // namespace hawser::advice
