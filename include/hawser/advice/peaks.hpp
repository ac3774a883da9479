// Sentences about largest tensions that steps or elements do not show as they are.
#pragma once

#include <string>

namespace hawser::advice {

// Of an element that has folded and snaps taut.
struct FoldedPeak {
  double tension = 0, time = 0, arc = 0;  // N, s, m
  double share = 1;                       // of its length, to which it was folded
};
std::string folded_peak(const std::string& line, const FoldedPeak& at);

// Of an impact.
struct ImpactPeak {
  enum class Cause { steps, elements, crosswise, damping };  // what does not resolve it
  Cause cause = Cause::steps;
  double tension = 0, time = 0, arc = 0;  // N, s, m
  double step = 0;                        // s, that led to it
  double share = 0;                       // of the tension, that came up in this step
  double from = 0, within = 0;            // N, s: from what it came up, and how long that took
  double shorter = 0;                     // s, of steps to compare with
  bool fixed = false;                     // the user chose the step
};
std::string impact_peak(const std::string& line, const ImpactPeak& at);

}  // namespace hawser::advice
