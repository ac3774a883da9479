// Sentences about elements that are too long for what is asked of results (docs/theory/element-length.md).
#pragma once

#include <string>

namespace hawser::advice {

// The worst place of a line: the error that its elements make there, and what was found.
struct LongElements {
  double error = 0, arc = 0, time = 0;  // N or N m; m; s
  double turn = 0;                      // rad, from one element to the next
  double length = 0;                    // m, of the element
  double decay = 0;                     // m, within which a moment falls off
  double recommended = 0;               // m, of elements that are short enough
  double weight = 0;                    // N/m, in water
};
// largest: the tension [N] or moment [N m] against which the error is judged.
// EI [N m²]: of beams that bend within elements of that length.
std::string turns_on_edge(const std::string& line, const LongElements& at, double largest, double EI);
std::string sags_between_nodes(const std::string& line, const LongElements& at, double largest);
std::string leaves_bed_within(const std::string& line, const LongElements& at, double largest);
std::string moment_between_nodes(const std::string& line, const LongElements& at, double largest);

// An element too long for the current and the waves that it is in.
struct LongInFlow {
  std::string line;
  double length = 0, arc = 0, z = 0;  // m; z from the still water
  double time = 0;                    // s
  bool crossed = false;               // by the surface
  bool in_current = false, in_waves = false;
  long joined = 1;              // lines that bear the error together
  double force = 0, error = 0;  // N, of the flow, the largest sum and what it is off by
  double recommended = 0;       // m
};
std::string long_in_flow(const LongInFlow& at);
// A clause after it, on lines that are not listed.
std::string more_long_in_flow(size_t lines);

}  // namespace hawser::advice
