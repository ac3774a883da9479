// Lines that events cut are two lines from the beginning, held together until then.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// The checked case with each such line as its parts: the first keeps the name, the next are "NAME part 2" and
// so on. They meet at a joint, rigid where the line resists bending, and begin with the start shape of the
// whole; a cut is the release of the next part's end A from the joint. What is said of the line by arc length
// goes to the part that has it (docs/theory/events.md). notes of the case say what the parts are called.
Case with_cuts(Case c);

}  // namespace hawser::model
