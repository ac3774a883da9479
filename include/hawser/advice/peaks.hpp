// Messages about peak tensions that time steps or elements do not resolve.
#pragma once

#include <string>

#include "hawser/advice/step_choice.hpp"

namespace hawser::advice {

// Peak in an element that was folded and snaps taut.
struct FoldedPeak {
  double tension = 0, time = 0, arc = 0;  // N, s, m
  double ratio = 1;                       // folded length over element length
};
std::string folded_peak(const std::string& line, const FoldedPeak& at);

// Peak of an impact.
struct ImpactPeak {
  enum class Cause { steps, elements, crosswise, damping };  // reason why it is not resolved
  Cause cause = Cause::steps;
  double tension = 0, time = 0, arc = 0;  // N, s, m
  double step = 0;                        // s, step at the peak
  double fraction = 0;                    // fraction of the tension that built up in this step
  double from = 0, within = 0;            // N, s: tension before the rise, and duration of the rise
  double shorter = 0;                     // s, step recommended for comparison
  StepChoice choice = StepChoice::automatic;
};
std::string impact_peak(const std::string& line, const ImpactPeak& at);
// Another peak than the largest tension, which a step does not resolve. tension: its estimate.
std::string other_peak(const std::string& line, const ImpactPeak& at);

}  // namespace hawser::advice
