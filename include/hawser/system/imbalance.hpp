// Where a residual that did not converge is largest.
#pragma once

#include "hawser/advice/step_findings.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// Of forces, or of moments if these are further from balance. norms: of the same residual. Collective, the
// same on all ranks.
advice::Imbalance imbalance(const System& system, Vec residual, const ResidualNorms& norms);

}  // namespace hawser
