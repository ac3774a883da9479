// Notes on lines that events cut.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Names of the parts of each such line, one note for each part but the first; empty without cuts.
std::vector<std::string> parts_of_cut_lines(const model::Case& c);

}  // namespace hawser::advice
