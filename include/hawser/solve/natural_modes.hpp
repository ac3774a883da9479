// Small undamped vibrations about an equilibrium: K phi = omega² M phi, by SLEPc.
#pragma once

#include <vector>

#include "hawser/system/system.hpp"

namespace hawser {

struct NaturalMode {
  double squared = 0;       // rad²/s², omega²; below zero: the equilibrium is unstable in this direction
  std::vector<Vec3> shape;  // a local node (owned and ghosts): the translation, the largest of all 1
};

// The `count` modes of the lowest frequencies (fewer where there are no more), ascending, about the state
// `at`, which is at rest; M holds the added mass of the terms. Of tangents that are not symmetric (friction)
// the symmetric part counts. Collective. SolveError where the eigenvalues do not converge.
std::vector<NaturalMode> natural_modes(System& system, const Kinematics& at, int count);

}  // namespace hawser
