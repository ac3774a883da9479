// Continuous beam whose supports settle.
#pragma once

#include <span>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct BeamSpan {
  double length = 0, EI = 0;  // m, N m²
};
// Changes at a support of a continuous beam.
struct SettlementEffect {
  Vec3 moment = Vec3::Zero();  // N m, EI times the change of curvature
  Vec3 force = Vec3::Zero();   // N, of the support on the beam
};

// Effects of displacements [m] of the supports, one more than the spans, on a beam that is straight and free
// to turn at its ends (three-moment equation, Clapeyron 1857).
std::vector<SettlementEffect> settlement_effects(std::span<const BeamSpan> spans,
                                                 std::span<const Vec3> displacements);

}  // namespace hawser
