// Describes for the user where a residual that did not converge is largest.
#pragma once

#include <string>

#include "hawser/system/system.hpp"

namespace hawser {

// "line hose, arc length 12.5 m, is out of balance by 3.1e+04 N (forces of size 2e+06 N)", or the same with
// moments if these are further from balance. norms: of the same residual. Collective, the same text on all
// ranks.
std::string imbalance(const System& system, Vec residual, const ResidualNorms& norms);

}  // namespace hawser
