// Messages about peak tensions.
#include "hawser/advice/peaks.hpp"

#include <fmt/format.h>

namespace hawser::advice {

std::string folded_peak(const std::string& line, const FoldedPeak& at) {
  return fmt::format(
      "the largest tension of line {} ({:.4g} kN at arc length {:.4g} m, t = {:.6g} s) occurs as an element "
      "snaps taut that was folded to {:.0f} % of its length: the bend there, and this tension, depend on the "
      "element length. If it matters, give the line type its EI, which prevents folding, and compare with "
      "elements half as long",
      line, at.tension / 1000, at.arc, at.time, 100 * at.ratio);
}

std::string impact_peak(const std::string& line, const ImpactPeak& at) {
  std::string why = "it lasts less than an axial wave takes to pass three elements";
  if (at.cause == ImpactPeak::Cause::steps)
    why = fmt::format("{:.0f} % of it build up in one step of {:.2g} s", 100 * at.fraction, at.step);
  if (at.cause == ImpactPeak::Cause::crosswise)
    why = "it lasts less than a transverse wave takes to pass an element that lies over a volume";
  if (at.cause == ImpactPeak::Cause::damping)
    why = fmt::format("it rises from {:.3g} kN within {:.2g} s, and the steps damp axial waves",
                      at.from / 1000, at.within);
  return fmt::format(
      "the largest tension of line {} ({:.4g} kN at arc length {:.4g} m, t = {:.6g} s) is due to an impact "
      "that is not resolved: {}; the true value may be higher or lower, and the value may differ on another "
      "number of ranks. If it matters, compare with dynamics.{}: {:.2g} s and elements half as long",
      line, at.tension / 1000, at.arc, at.time, why, step_key(at.choice), at.shorter);
}

std::string other_peak(const std::string& line, const ImpactPeak& at) {
  return fmt::format(
      "line {} comes taut within one step of {:.2g} s (t = {:.6g} s, arc length {:.4g} m): the peak between "
      "the steps may be {:.4g} kN, above the largest tension. If it matters, compare with dynamics.{}: "
      "{:.2g} s",
      line, at.step, at.time, at.arc, at.tension / 1000, step_key(at.choice), at.shorter);
}

}  // namespace hawser::advice
