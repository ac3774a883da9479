// Messages about elements that are too long for the results (docs/theory/element-length.md).
#pragma once

#include <string>

namespace hawser::advice {

inline constexpr double kOfContactRadius = 0.2;  // length of elements over a sharp edge, in contact radii

// Place of the largest element error of a line.
struct LongElements {
  double error = 0, arc = 0, time = 0;  // N or N m; m; s
  double turn = 0;                      // rad, between neighbouring elements
  double length = 0;                    // m, of the element
  double decay = 0;                     // m, decay length of the moment
  double recommended = 0;               // m, sufficient element length
  double weight = 0;                    // N/m, in water
  double excess = 0;                    // m, of straight elements over the exact curve
  double own_error = 0;                 // N, part of the error by this excess, without that of other lines
  bool held = false;                    // the line is held at both ends
  bool over_line = false;               // and not over a volume
};
// largest: tension [N] or moment [N m] to which the error is relative.
// EI [N m²]: of beams that bend within such elements; not proposed for held lines. turn: rad, over a sharp
// edge; 0: none.
std::string turns_on_edge(const std::string& line, const LongElements& at, double largest, double EI,
                          double turn);
std::string longer_over_contact(const std::string& line, const LongElements& at, double largest);
std::string sags_between_nodes(const std::string& line, const LongElements& at, double largest);
std::string leaves_bed_within(const std::string& line, const LongElements& at, double largest);
std::string moment_between_nodes(const std::string& line, const LongElements& at, double largest);

// An element too long for the current and waves around it.
struct LongInFlow {
  std::string line;
  double length = 0, arc = 0, z = 0;  // m; z relative to the still water
  double time = 0;                    // s
  bool crossed = false;               // by the surface
  bool in_current = false, in_waves = false;
  long joined = 1;              // number of lines that share the error
  double force = 0, error = 0;  // N: largest total flow force, and its error
  double recommended = 0;       // m
};
std::string long_in_flow(const LongInFlow& at);
// A clause on lines that are not listed.
std::string more_long_in_flow(size_t lines);

}  // namespace hawser::advice
