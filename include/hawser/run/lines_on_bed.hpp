// Report of an equilibrium: lines on the seabed, and below the water of a case without one.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/system.hpp"

namespace hawser::run {

// Length of each line on the seabed and the effect of friction, one sentence each. Collective.
std::vector<std::string> lines_on_bed(const model::Case& c, const System& system, const Kinematics& state);

// Warning of lines deeper than the water of a case without a seabed (advice::lie_below_water); empty: none.
// Collective.
std::string lines_below_water(const model::Case& c, const System& system, const Kinematics& state);

}  // namespace hawser::run
