// The longest step that automatic steps may take where the case does not say: a part of the fastest of what
// the case makes move. The local error and the terms make steps shorter than that where they must.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

struct LongestStep {
  double length = 0;   // s
  std::string reason;  // what it comes from, for the user
};

// A hundredth of the period of waves (mean period T01 of a spectrum, DNV-RP-C205 3.5.2.3) and of prescribed
// motions and turns; a row of a table; a twentieth of a ramp, of each line's slowest period and of a floating
// body's on its springs; a tenth of the time in which drag slows what is carried along; the time between
// outputs; a fiftieth of the duration.
LongestStep longest_step(const Case& c);

}  // namespace hawser::model
