// Sentences about contact of lines with lines.
#pragma once

#include <string>

namespace hawser::advice {

// The stiffness [N/m per m] between lines that was chosen, from the least to the most. only_line: a line that
// touches itself alone, or ""; themselves: lines touch themselves too.
std::string chosen_pair_stiffness(double least, double most, const std::string& only_line, bool themselves);
// Two lines, or both ends of one, that go from one place and do not touch within a length [m] from there, and
// how many pairs there are more.
std::string apart_near_place(const std::string& one, const std::string& other, double within, int more);

}  // namespace hawser::advice
