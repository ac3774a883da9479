// Where the nodes of lines are: at the ends of their elements, of which the nearest is moved to each point
// mass, point load, link and body on the line.
#pragma once

#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::model {

// For each line of the case the arc lengths [m], growing, at which masses, point loads, links and bodies are
// fixed to it.
std::vector<std::vector<double>> fixed_places(const Case& c);

// Unstretched lengths [m] of the elements of each section of a line, from end A on: those of the section's
// geometric progression, but that the node that is nearest to a fixed place is moved there, and what lies
// between such nodes stretches or shrinks evenly. A place has no node of its own where its node is another's,
// nor within a tenth of an element of another such node or of the section's ends.
std::vector<std::vector<double>> element_lengths(const Line& line, const std::vector<double>& places);

}  // namespace hawser::model
