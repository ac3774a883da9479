// Report of an equilibrium: lines on the seabed.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/system.hpp"

namespace hawser::run {

// Length of each line on the seabed and the effect of friction, one sentence each. Collective.
std::vector<std::string> lines_on_bed(const model::Case& c, const System& system, const Kinematics& state);

}  // namespace hawser::run
