// Location of the largest residual of a solution that did not converge.
#pragma once

#include "hawser/advice/step_findings.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// Largest imbalance of forces, or of moments if these are further from equilibrium. norms: of the same
// residual. Collective, the same on all ranks.
advice::Imbalance imbalance(const System& system, Vec residual, const ResidualNorms& norms);

}  // namespace hawser
