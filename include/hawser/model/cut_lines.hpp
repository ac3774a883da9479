// Lines that events cut: two lines from the start, joined until the cut.
#pragma once

#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::model {

// Returns the checked case with each such line split into parts. The first keeps the name, the next are "NAME
// part 2" and so on. Parts meet at a joint, rigid if the line resists bending, and start in the shape of the
// whole line; a cut releases end A of the next part from the joint. Items at an arc length go to the part
// that contains it (docs/theory/events.md).
Case with_cuts(Case c);

// A line of the case before events cut it: its parts are consecutive in Case::lines.
struct GivenLine {
  int first = 0;  // index of the first part in Case::lines
  int parts = 1;  // number of parts
};
std::vector<GivenLine> given_lines(const Case& c);

}  // namespace hawser::model
