// Linear motion of lines and bodies in waves about an equilibrium. See docs/theory/platforms.md.
#pragma once

#include <vector>

#include "hawser/kernels/platform_waves.hpp"
#include "hawser/math/function_ref.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// Solves (K - omega² M + i omega C) u = X about `state`, which is at rest, for each of the waves, with M, C
// and X at its frequency. `each` gets the number of the wave and u: the motion is Re(u exp(i omega t)), three
// numbers for each owned local block, positions in space axes and rotations in node axes. Waves of one
// frequency that follow each other share a factorisation. K is that of natural modes. Collective. Throws
// SolveError if the equations are singular.
void linear_responses(System& system, const Kinematics& state, const std::vector<WaveComponent>& waves,
                      FunctionRef<void(size_t, const std::vector<Complex>&)> each);

}  // namespace hawser
