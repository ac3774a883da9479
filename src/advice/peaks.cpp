// Messages about peak tensions.
#include "hawser/advice/peaks.hpp"

#include <fmt/format.h>

namespace hawser::advice {

std::string folded_peak(const std::string& line, const FoldedPeak& at) {
  return fmt::format(
      "the largest tension of line {} ({:.4g} kN at arc length {:.4g} m, t = {:.6g} s) is that with which an "
      "element snaps taut that was folded to {:.0f} % of its length: how sharply the line bends there, and "
      "this tension, depend on the length of its elements. Where it matters, give the line type its EI, "
      "which keeps it from folding, and compare with half as long elements",
      line, at.tension / 1000, at.arc, at.time, 100 * at.share);
}

std::string impact_peak(const std::string& line, const ImpactPeak& at) {
  std::string why = "it comes and goes faster than a wave passes three elements";
  if (at.cause == ImpactPeak::Cause::steps)
    why = fmt::format("{:.0f} % of it come up in one step of {:.2g} s", 100 * at.share, at.step);
  if (at.cause == ImpactPeak::Cause::crosswise)
    why = "it comes and goes faster than a wave across the line passes an element that lies over a volume";
  if (at.cause == ImpactPeak::Cause::damping)
    why = fmt::format("it comes up from {:.3g} kN within {:.2g} s, and the steps damp axial waves",
                      at.from / 1000, at.within);
  return fmt::format(
      "the largest tension of line {} ({:.4g} kN at arc length {:.4g} m, t = {:.6g} s) is that of an impact "
      "which is not resolved: {}, so that it may be higher or lower, on another number of ranks as well. "
      "Where it matters, compare with dynamics.{}: {:.2g} s and elements half as long",
      line, at.tension / 1000, at.arc, at.time, why, at.fixed ? "step" : "max_step", at.shorter);
}

}  // namespace hawser::advice
