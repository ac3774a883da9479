// Messages about contact between lines.
#pragma once

#include <string>

namespace hawser::advice {

// Chosen stiffness between lines [N/m per m], least and most. only_line: the only line that touches itself,
// or ""; themselves: lines also touch themselves.
std::string chosen_pair_stiffness(double smallest, double largest, const std::string& only_line,
                                  bool themselves);
// Two lines, or both ends of one, that start at one place and do not touch within a length [m] from it, and
// the number of further pairs.
std::string separate_near_place(const std::string& one, const std::string& other, double within, int more);

}  // namespace hawser::advice
